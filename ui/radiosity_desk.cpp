#include "ui/radiosity_desk.h"

#include "params/input_error.h"
#include "ui/solver_panel.h"
#include "workbench/job.h"
#include "workbench/model_library.h"

namespace cg {

RadiosityHandle RadiosityDesk::update(const Scene& scene, bool always) {
  if (!always && !wants_radiosity(scene)) return nullptr;
  RadiosityHandle drawn;
  {
    const std::lock_guard lock(mutex_);
    if (newest_.field && same_places(solved_, scene)) drawn = newest_.field;
  }
  if (Scene inputs = radiosity_inputs(scene); !asked_ || !(*asked_ == inputs)) {
    asked_ = inputs;
    worker_.submit([this, inputs = std::move(inputs)](Progress& progress) { solve(inputs, progress); }, true);
  }
  return drawn;
}

void RadiosityDesk::take(const Scene& scene, SceneRadiosity solution) {
  asked_ = radiosity_inputs(scene);
  worker_.submit([](Progress&) {}, true);
  const std::lock_guard lock(mutex_);
  ++taken_;  // what is being solved is of no use any more
  newest_ = std::move(solution), solved_ = *asked_, message_.reset();
}

void RadiosityDesk::solve_again() {
  asked_.reset();
  const std::lock_guard lock(mutex_);
  newest_ = {}, solved_ = {};
}

void RadiosityDesk::solve(Scene scene, Progress& progress) {
  SceneRadiosity earlier, solved;
  std::size_t taken = 0;
  {
    const std::lock_guard lock(mutex_);
    earlier = newest_, taken = taken_;
  }
  std::optional<Text> message;
  try {
    Scene loaded = scene;
    load_meshes(loaded);
    solved = solve_scene(loaded, earlier, progress, drawing_threads(), gl_);
  } catch (const Cancelled&) {
    return;
  } catch (const InputError& e) {
    message = Text(e.message(Language::english), e.message(Language::japanese));
  } catch (const std::bad_alloc&) {
    message = Text("There is not enough memory for the form factors", "形態係数を保存するメモリが足りない");
  }
  {
    const std::lock_guard lock(mutex_);
    if (taken != taken_) return;
    message_ = std::move(message);
    if (!message_) newest_ = std::move(solved), solved_ = std::move(scene);
  }
  if (wake_) wake_();
}

RadiosityDesk::State RadiosityDesk::state() const {
  const bool busy = worker_.busy();
  const float fraction = worker_.fraction();
  const std::lock_guard lock(mutex_);
  return {busy, fraction, newest_, solved_, message_};
}

RadiosityDesk& desk_of(App& app) {
  if (!app.radiosity) app.radiosity = std::make_shared<RadiosityDesk>(app.wake);
  return *app.radiosity;
}

Scene scene_with_solution(App& app) {
  Scene scene = app.scene;
  if (wants_radiosity(scene)) scene.radiosity_field = desk_of(app).update(app.scene);
  draw_solver_state(app, scene);
  return scene;
}

}  // namespace cg
