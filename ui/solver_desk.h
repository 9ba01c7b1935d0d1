// The linear system of radiosity solved step by step beside the window: forward, back, played; after each piece of work
// a state to be drawn. The window never waits, and the scene never changes by it.
#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "radiosity/field.h"
#include "radiosity/solution.h"
#include "scene/scene.h"
#include "workbench/worker.h"

namespace cg {

// A system and how it is solved.
struct SolverTask {
  SolutionHandle solution;  // its patches and form factors; the matrix is not null
  Scene scene;              // that it was made of, as radiosity_inputs() gives it; meshes may be missing
  Radiosity options;        // solver, residual and memory count
};

// Whether both have the same equations.
bool same_system(const RadiositySolution& a, const RadiositySolution& b);

// What the solver has come to. Never changed once it is published.
struct SolverState {
  std::shared_ptr<const SolverTask> task;
  std::size_t step = 0, steps_a_sweep = 1;
  double sweeps = 0;
  std::optional<std::size_t> active;  // the row or the shooting patch of the next step
  SolverEnd end = SolverEnd::none;
  Text message;
  std::vector<ResidualPoint> curve;
  double error_factor = 1;
  std::optional<double> residual;  // of this very state: measured where the solver rests
  glm::dvec3 ambient{0};
  double brightest = 0;  // of B over pi
  LightPart part = LightPart::total;
  double gain = 1;  // by which the part is brightened to be seen
  RadiosityHandle field;
};
using SolverStateHandle = std::shared_ptr<const SolverState>;

class SolverDesk {
 public:
  // `wake` is called on another thread when there is something new.
  explicit SolverDesk(std::function<void()> wake) : wake_(std::move(wake)) {}

  // Once a frame. Another system or solver begins at its beginning; another residual goes on where it stands.
  void take(const SolutionHandle& solution, const Scene& scene, const Radiosity& options);
  void show(LightPart part);

  // Where it is to go, from where it was last sent.
  void go_to(std::size_t step);
  void step() { go_to(wanted() + 1); }
  void back() { go_to(wanted() > 0 ? wanted() - 1 : 0); }
  void sweep();   // to the end of the sweep
  void finish();  // until it ends
  void reset() { go_to(0); }
  void stop();  // where it is now
  void play();
  bool playing() const { return playing_; }
  // Once a frame, with the window's clock: goes on where it plays, `speed` steps a second.
  void advance(double now, double speed);

  struct State {
    bool busy = false;
    float fraction = 1;           // of a step that takes long
    SolverStateHandle newest;     // null before the first
    std::optional<Text> problem;  // why there is no solver
    std::size_t furthest = 0;     // the most steps that it has come to
  };
  State state() const;

 private:
  struct Order {
    std::shared_ptr<const SolverTask> task;
    std::size_t target = 0;
    LightPart part = LightPart::total;
    friend bool operator==(const Order&, const Order&) = default;
  };
  std::size_t wanted() const;  // the newest target; of one beyond the end, where it stands
  void send(bool cancel);
  Order order() const;
  void work(Progress& progress);
  void make(const Order& order);
  void move(std::size_t target, Progress& progress);
  void publish(const Order& order, bool resting, Progress& progress);
  RadiosityHandle field_with(const std::vector<glm::dvec3>& part, const SolverState& state) const;

  const std::function<void()> wake_;
  // Of the window's thread.
  bool playing_ = false;
  double played_at_ = -1;     // the clock's time when it was at
  double played_from_ = 0;    // that many steps
  mutable std::mutex mutex_;  // guards what follows
  Order order_;
  SolverStateHandle newest_;
  std::optional<Text> problem_;
  std::size_t furthest_ = 0;
  // Of the worker's thread.
  std::shared_ptr<const SolverTask> made_of_;
  std::unique_ptr<Solver> solver_;
  std::unique_ptr<FieldMeshes> meshes_;
  std::shared_ptr<const Patches> meshes_of_;
  std::size_t piece_ = 1;                        // steps at a time
  double published_at_ = -1e9, publishing_ = 0;  // seconds
  Order published_;
  bool rested_ = false;
  Worker worker_;  // last: it uses what stands above
};

}  // namespace cg
