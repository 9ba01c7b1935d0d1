#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "radiosity/solver_parts.h"

namespace cg {

namespace {

// Where changes are no larger than this times the brightest patch, another sweep brings nothing.
constexpr double digits_of_double = 0x1p-50;
// Sweeps in a row in which the residual did not fall: then it never will, where nothing says that it must.
constexpr int patience = 8;
constexpr double too_bright = 1e200;
// Of a curve; where there are more every other one goes.
constexpr std::size_t most_points = 1 << 15;

Bounce bounce_of(const RadiositySystem& s) {
  Bounce out;
  for (std::size_t i = 0; i < s.reflectance.size(); ++i) {
    const double sum = i < s.matrix->kept_rows() ? s.matrix->row_sum(i) : 1;
    const glm::dvec3& rho = s.reflectance[i];
    out.most = std::max(out.most, largest(rho) * sum);
    out.closed = std::max(out.closed, largest(rho) * std::max(sum, 1.0));
    out.least = std::min(out.least, largest(rho) * sum);
  }
  return out;
}

std::shared_ptr<const SolverData> data_of(RadiositySystem system, const Bounce& bounce, const Radiosity& options,
                                          const Progress* progress) {
  SolverData data;
  data.emission = Channels(system.emission);
  data.reflectance = Channels(system.reflectance);
  data.row_bound = bounce.closed;
  data.system = std::move(system);
  if (options.solver == RadiositySolver::southwell || options.solver == RadiositySolver::progressive)
    prepare_shooting(data, options.memory, progress);
  return std::make_shared<const SolverData>(std::move(data));
}

std::unique_ptr<Iteration> make_iteration(const std::shared_ptr<const SolverData>& data, RadiositySolver solver) {
  switch (solver) {
    case RadiositySolver::jacobi:
      return make_gather(data, false);
    case RadiositySolver::gauss_seidel:
      return make_gather(data, true);
    case RadiositySolver::southwell:
      return make_shooting(data, false);
    case RadiositySolver::progressive:
      return make_shooting(data, true);
    case RadiositySolver::lu:
      break;
  }
  return make_direct(data);
}

}  // namespace

RadiositySystem system_of(const Patches& patches, std::shared_ptr<const FormFactorMatrix> matrix) {
  RadiositySystem out{std::move(matrix), {}, {}};
  for (const Patch& p : patches.patches) {
    out.emission.push_back(p.emission);
    out.reflectance.push_back(p.reflectance);
  }
  return out;
}

Solver::Parts::Parts(RadiositySystem system, const Radiosity& options, int threads, const Progress* progress)
    : kind(options.solver),
      target(options.residual),
      bounce(bounce_of(system)),
      data(data_of(std::move(system), bounce, options, progress)),
      rows(data->system.matrix, threads),
      iteration(make_iteration(data, kind)),
      stride(iteration->unshot() ? std::max<std::size_t>(1, iteration->steps_a_sweep() / 16)
                                 : iteration->steps_a_sweep()) {
  begin();
}

double Solver::Parts::factor() const {
  if (absorbs(bounce.closed)) return 1 / (1 - bounce.closed);
  return absorbs(bounce.most) ? 1 / (1 - bounce.most) : 1;
}

// What is known without a step.
void Solver::Parts::begin() {
  double brightest = 0;
  for (const glm::dvec3& e : data->system.emission) brightest = std::max(brightest, largest(e));
  const double kept = kind == RadiositySolver::southwell ? 1 : std::min(bounce.closed, 1.0);
  history.remember(0, 0, *iteration);
  curve.push_back({0, 0, 0, brightest > 0 ? factor() * kept : 0});
  if (brightest * kept == 0)
    end = SolverEnd::converged;
  else if (!absorbs(bounce.least) && kind != RadiositySolver::lu)
    end = SolverEnd::diverges;
}

void Solver::Parts::step(Progress& progress) {
  iteration->step(rows, progress);
  ++steps;
  if (const auto standing = iteration->standing()) judge(*standing);
  if (steps % stride != 0) return;
  lap();
  history.remember(steps, seconds, *iteration);
  start();
}

void Solver::Parts::lap() {
  const auto now = std::chrono::steady_clock::now();
  seconds += std::chrono::duration<double>(now - std::exchange(clock, now)).count();
}

void Solver::Parts::judge(const Standing& s) {
  const double bound = s.residual * factor() / std::max(s.brightest, 1e-300);
  const bool may_grow = !absorbs(bounce.closed);
  if (kind == RadiositySolver::lu)
    end = s.grows ? SolverEnd::diverges : SolverEnd::converged;
  else if (!(s.brightest < too_bright) || (may_grow && s.swept && s.grows))
    end = SolverEnd::diverges;
  else if (bound <= target)
    end = SolverEnd::converged;
  else if (s.residual <= digits_of_double * s.brightest)
    end = SolverEnd::rounding;
  if (s.swept || end != SolverEnd::none || steps % stride == 0) note(bound, may_grow && s.swept);
}

void Solver::Parts::note(double bound, bool may_grow) {
  lap();
  curve.push_back({steps, double(steps) / double(iteration->steps_a_sweep()), seconds, bound});
  if (curve.size() > most_points) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < curve.size(); i += 2) curve[kept++] = curve[i];
    curve.resize(kept);
  }
  if (!may_grow || end != SolverEnd::none) return;
  int patient = 0;
  for (std::size_t i = curve.size(); i-- > 1 && curve[i].error_bound >= curve[i - 1].error_bound;) ++patient;
  if (patient >= patience) end = SolverEnd::diverges;
}

void Solver::Parts::restore(const SolverHistory::State& state) {
  iteration = state.iteration->copy();
  steps = state.step;
  seconds = state.seconds;
  while (curve.size() > 1 && curve.back().step > steps) curve.pop_back();
  end = SolverEnd::none;
}

void Solver::Parts::tell(Progress& progress) const {
  const double first = std::max(curve.front().error_bound, target), now = std::max(curve.back().error_bound, target);
  const double way = std::log(first / target);
  progress.fraction.store(way > 0 ? float(std::log(first / now) / way) : 0.0f, std::memory_order_relaxed);
}

Solver::Solver(RadiositySystem system, const Radiosity& options, int threads, const Progress* progress)
    : parts_(std::make_unique<Parts>(std::move(system), options, threads, progress)) {}
Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

const RadiositySystem& Solver::system() const { return parts_->data->system; }
RadiositySolver Solver::kind() const { return parts_->kind; }
std::size_t Solver::steps() const { return parts_->steps; }
std::size_t Solver::steps_a_sweep() const { return parts_->iteration->steps_a_sweep(); }
SolverEnd Solver::end() const { return parts_->end; }
const std::vector<ResidualPoint>& Solver::curve() const { return parts_->curve; }
glm::dvec3 Solver::ambient() const {
  return parts_->end == SolverEnd::none ? parts_->iteration->ambient() : glm::dvec3(0);
}
double Solver::error_factor() const { return parts_->factor(); }

std::optional<std::size_t> Solver::active() const {
  return parts_->end == SolverEnd::none ? parts_->iteration->active() : std::nullopt;
}

void Solver::step(Progress& progress) {
  if (parts_->end != SolverEnd::none) return;
  parts_->check(progress);
  parts_->start();
  parts_->step(progress);
  parts_->lap();
  parts_->history.remember(parts_->steps, parts_->seconds, *parts_->iteration);
}

void Solver::sweep(Progress& progress) {
  constexpr std::size_t unasked = 16;
  parts_->start();
  const std::size_t to = (steps() / std::max<std::size_t>(steps_a_sweep(), 1) + 1) * steps_a_sweep();
  while (steps() < to && parts_->end == SolverEnd::none) {
    if (steps() % unasked == 0) parts_->check(progress);
    parts_->step(progress);
  }
  parts_->lap();
}

void Solver::run(Progress& progress) {
  while (parts_->end == SolverEnd::none) {
    sweep(progress);
    if (kind() != RadiositySolver::lu) parts_->tell(progress);
  }
}

void Solver::forget_states() { parts_->history.close(); }

void Solver::go_to(std::size_t step, Progress& progress) {
  assert(step >= steps() || parts_->history.nearest(step));
  if (step < steps()) parts_->restore(*parts_->history.nearest(step));
  parts_->start();
  while (steps() < step && parts_->end == SolverEnd::none) {
    parts_->check(progress);
    parts_->step(progress);
  }
  parts_->lap();
}

}  // namespace cg
