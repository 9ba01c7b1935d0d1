// The radiosity solution of the scene in the window, solved on a thread of its own: the window never waits for it.
#pragma once
#include <functional>
#include <mutex>
#include <optional>

#include "ui/app.h"
#include "workbench/scene_radiosity.h"
#include "workbench/worker.h"

namespace cg {

class RadiosityDesk {
 public:
  // `wake` is called on another thread when there is something new; `gl` draws the hemicubes that are OpenGL's.
  explicit RadiosityDesk(std::function<void()> wake, MakeDrawItems gl = {})
      : wake_(std::move(wake)), gl_(std::move(gl)) {}

  // Null where nobody draws hemicubes by OpenGL.
  const MakeDrawItems& draw_items() const { return gl_; }

  // Asks for the solution where the scene's ambient term wants one and what it depends on changed since it was asked
  // for last: not the camera, not the lights. Returns what is to be drawn: the newest solution, where the objects stand
  // as it has them; else null.
  // `always`: also where the ambient term is constant (its patches and form factors are looked at).
  RadiosityHandle update(const Scene& scene, bool always = false);
  // A solution of `scene` that was read from a file, in place of the newest.
  void take(const Scene& scene, SceneRadiosity solution);
  // Solves what was asked for last once more, form factors and all.
  void solve_again();

  struct State {
    bool busy = false;
    float fraction = 1;
    SceneRadiosity newest;        // null before the first
    Scene solved;                 // radiosity_inputs() of it
    std::optional<Text> message;  // why there is none for what was asked last
  };
  State state() const;

 private:
  void solve(Scene scene, Progress& progress);

  const std::function<void()> wake_;
  const MakeDrawItems gl_;
  std::optional<Scene> asked_;  // radiosity_inputs() of the scene that was asked for last
  mutable std::mutex mutex_;    // guards what follows
  SceneRadiosity newest_;
  Scene solved_;  // radiosity_inputs() of newest_
  std::optional<Text> message_;
  std::size_t taken_ = 0;  // how often a solution was taken from elsewhere
  Worker worker_;          // last: it uses what stands above
};

RadiosityDesk& desk_of(App& app);

// The scene with the solution that is drawn in it, or with the state of the solver that is looked at.
Scene scene_with_solution(App& app);

}  // namespace cg
