#include "ui/solver_desk.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "params/input_error.h"
#include "workbench/job.h"
#include "workbench/model_library.h"

namespace cg {

namespace {

constexpr std::size_t no_end = std::numeric_limits<std::size_t>::max();
constexpr double piece_s = 0.015;  // what a piece of work is to take
constexpr double pause_s = 0.033;  // from one published state to the next

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

bool same_light(const Patches& a, const Patches& b) {
  return std::equal(
      a.patches.begin(), a.patches.end(), b.patches.begin(), b.patches.end(),
      [](const Patch& p, const Patch& q) { return p.reflectance == q.reflectance && p.emission == q.emission; });
}

// What a picture can hold of a solver that diverges.
glm::dvec3 drawable(const glm::dvec3& v) {
  static constexpr double most = 1e30;
  const auto one = [](double x) { return x > -most ? std::min(x, most) : x <= -most ? -most : 0; };
  return {one(v.x), one(v.y), one(v.z)};
}

double most_of(const std::vector<glm::dvec3>& values) {
  double most = 0;
  for (const glm::dvec3& v : values) most = std::max(most, largest(v));
  return most;
}

// Doublings until the brightest would pass `bright`.
double gain_for(double most, double bright) {
  if (!(most > 0) || !(most < bright)) return 1;
  return std::exp2(std::min(std::floor(std::log2(bright / most)), 40.0));
}

}  // namespace

namespace {

// Patches of the same system that are cut in the same elements.
bool same_elements(const RadiositySolution& a, const RadiositySolution& b) {
  return a.patches == b.patches ||
         (a.options.adaptive_levels == b.options.adaptive_levels && a.options.gradient == b.options.gradient &&
          a.patches->elements.size() == b.patches->elements.size());
}

}  // namespace

bool same_system(const RadiositySolution& a, const RadiositySolution& b) {
  return &a == &b || (a.matrix == b.matrix && a.geometry == b.geometry && same_light(*a.patches, *b.patches));
}

void SolverDesk::take(const SolutionHandle& solution, const Scene& scene, const Radiosity& options) {
  const std::shared_ptr<const SolverTask> before = order().task;
  if (!solution || !solution->matrix) {
    if (!before) return;
    playing_ = false;
    {
      const std::lock_guard lock(mutex_);
      order_ = {nullptr, 0, order_.part};
      newest_ = nullptr, problem_.reset(), furthest_ = 0;
    }
    return send(true);
  }
  const bool same_way = before && before->options.solver == options.solver && before->options.memory == options.memory;
  const bool goes_on = same_way && same_system(*before->solution, *solution);
  if (goes_on && before->options.residual == options.residual && before->scene == scene &&
      same_elements(*before->solution, *solution))
    return;
  if (!goes_on) playing_ = false;
  {
    const std::lock_guard lock(mutex_);
    order_.task = std::make_shared<const SolverTask>(SolverTask{solution, scene, options});
    if (!goes_on) order_.target = 0, furthest_ = 0;
    problem_.reset();
  }
  send(true);
}

void SolverDesk::show(LightPart part) {
  {
    const std::lock_guard lock(mutex_);
    if (order_.part == part) return;
    order_.part = part;
  }
  send(false);
}

std::size_t SolverDesk::wanted() const {
  const std::lock_guard lock(mutex_);
  if (!newest_ || newest_->task != order_.task) return order_.target == no_end ? 0 : order_.target;
  return order_.target == no_end || (newest_->end != SolverEnd::none && order_.target > newest_->step) ? newest_->step
                                                                                                       : order_.target;
}

void SolverDesk::go_to(std::size_t step) {
  playing_ = false;
  bool back = false;
  {
    const std::lock_guard lock(mutex_);
    if (!order_.task || order_.target == step) return;
    back = step < order_.target;
    order_.target = step;
  }
  send(back);
}

void SolverDesk::sweep() {
  const SolverStateHandle now = state().newest;
  const std::size_t n = now ? std::max<std::size_t>(now->steps_a_sweep, 1) : 1;
  go_to((wanted() / n + 1) * n);
}

void SolverDesk::finish() { go_to(no_end); }

void SolverDesk::stop() {
  const SolverStateHandle now = state().newest;
  go_to(now ? now->step : 0);
}

void SolverDesk::play() {
  playing_ = true;
  played_at_ = -1;
}

void SolverDesk::advance(double now, double speed) {
  if (!playing_) return;
  const State s = state();
  if (!s.newest || s.newest->end != SolverEnd::none) {
    playing_ = playing_ && !s.newest;
    return;
  }
  if (played_at_ < 0) played_at_ = now, played_from_ = double(s.newest->step);
  // Where the solver cannot keep up it is not sent farther ahead than a moment's work: stopping stops at once.
  const double ahead = double(s.newest->step) + std::max(speed * 0.1, 1.0);
  if (const double due = played_from_ + (now - played_at_) * speed; due > ahead) played_from_ = ahead, played_at_ = now;
  const double target = std::floor(played_from_ + (now - played_at_) * speed);
  if (target <= double(wanted())) return;
  go_to(std::size_t(target));
  playing_ = true;
}

SolverDesk::State SolverDesk::state() const {
  const bool busy = worker_.busy();
  const float fraction = worker_.fraction();
  const std::lock_guard lock(mutex_);
  return {busy, fraction, newest_, problem_, furthest_};
}

void SolverDesk::send(bool cancel) {
  worker_.submit([this](Progress& progress) { work(progress); }, cancel);
}

SolverDesk::Order SolverDesk::order() const {
  const std::lock_guard lock(mutex_);
  return order_;
}

// One piece after the other, until it is where the newest order says.
void SolverDesk::work(Progress& progress) {
  for (;;) {
    const Order now = order();
    if (now.task != made_of_) make(now);
    if (!solver_) return;
    if (solver_->steps() != now.target) move(now.target, progress);
    const bool there =
        solver_->steps() == now.target || (solver_->end() != SolverEnd::none && solver_->steps() < now.target);
    if (there || seconds() - published_at_ > std::max(pause_s, 2 * publishing_)) publish(now, false, progress);
    if (!there || !(now == order())) continue;
    if (!rested_) publish(now, true, progress);
    return;
  }
}

void SolverDesk::make(const Order& now) {
  solver_ = nullptr;
  made_of_ = now.task;
  published_ = {};
  piece_ = 1;
  if (!now.task) {
    meshes_ = nullptr, meshes_of_ = nullptr;
    return;
  }
  std::optional<Text> problem;
  try {
    const RadiositySolution& s = *now.task->solution;
    if (meshes_of_ != s.patches) {
      Scene scene = now.task->scene;
      load_meshes(scene);
      meshes_ = std::make_unique<FieldMeshes>(scene, s.patches);
      meshes_of_ = s.patches;
    }
    solver_ = std::make_unique<Solver>(system_of(*s.patches, s.matrix), now.task->options, drawing_threads());
  } catch (const InputError& e) {
    problem = Text(e.message(Language::english), e.message(Language::japanese));
  } catch (const std::bad_alloc&) {
    problem = Words{"There is not enough memory for this solver", "この解法に必要なメモリが足りない"};
  }
  if (!problem) return;
  {
    const std::lock_guard lock(mutex_);
    if (order_.task == now.task) problem_ = std::move(problem), newest_ = nullptr;
  }
  if (wake_) wake_();
}

void SolverDesk::move(std::size_t target, Progress& progress) {
  const std::size_t steps = solver_->steps();
  rested_ = false;
  if (target == steps + 1) return solver_->step(progress);  // remembered, to come back to
  if (target < steps || solver_->end() != SolverEnd::none) return solver_->go_to(target, progress);
  const double start = seconds();
  solver_->go_to(steps + std::min(target - steps, piece_), progress);
  const double took = seconds() - start;
  if (took < 0.5 * piece_s) piece_ *= 2;
  if (took > 2 * piece_s) piece_ = std::max<std::size_t>(piece_ / 2, 1);
}

void SolverDesk::publish(const Order& now, bool resting, Progress& progress) {
  const Order at{now.task, solver_->steps(), now.part};
  if (!resting && at == published_) return;
  const double start = seconds();
  auto out = std::make_shared<SolverState>();
  const Solver& solver = *solver_;
  out->task = now.task, out->part = now.part;
  out->step = solver.steps(), out->steps_a_sweep = solver.steps_a_sweep(), out->sweeps = solver.sweeps();
  out->active = solver.active(), out->end = solver.end(), out->message = solver.message();
  out->curve = solver.curve(), out->error_factor = solver.error_factor(), out->ambient = solver.ambient();
  const std::vector<glm::dvec3> b = solver.radiosity();
  out->brightest = most_of(b);
  // Else it would have to compute every row.
  const bool knows_residual = solver.kind() == RadiositySolver::southwell ||
                              solver.kind() == RadiositySolver::progressive || solver.system().matrix->whole();
  if (resting && knows_residual) out->residual = solver.residual(progress);
  const std::vector<glm::dvec3> part = now.part == LightPart::total ? b : solver.part(now.part, progress);
  if (now.part == LightPart::unshot) out->gain = gain_for(most_of(part), 1);
  out->field = field_with(part, *out);
  publishing_ = seconds() - start, published_at_ = seconds();
  published_ = at, rested_ = resting;
  {
    const std::lock_guard lock(mutex_);
    if (order_.task != now.task) return;
    furthest_ = std::max(furthest_, out->step);
    newest_ = std::move(out);
  }
  if (wake_) wake_();
}

RadiosityHandle SolverDesk::field_with(const std::vector<glm::dvec3>& part, const SolverState& state) const {
  const Patches& patches = *meshes_of_;
  std::vector<glm::dvec3> light;
  light.reserve(patches.elements.size());
  for (const Element& e : patches.elements) {
    const glm::dvec3 shown =
        state.part == LightPart::total ? part[e.patch] - patches.patches[e.patch].emission : state.gain * part[e.patch];
    light.push_back(drawable(shown));
  }
  auto field = std::make_shared<RadiosityField>(meshes_->field(light, state.task->solution->geometry));
  const std::string step = std::to_string(state.step);
  const Words& solver = names_of<RadiositySolver>[std::size_t(state.task->options.solver)].label;
  field->summary = {std::string(solver.en) + ", step " + step, std::string(solver.ja) + "、ステップ " + step};
  return field;
}

}  // namespace cg
