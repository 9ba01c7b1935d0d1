#include "ui/solver_race.h"

#include <chrono>

#include "params/input_error.h"
#include "ui/solver_desk.h"
#include "workbench/job.h"

namespace cg {

namespace {

// The quick ones first, so that there is soon something to see.
constexpr RadiositySolver order[] = {RadiositySolver::gauss_seidel, RadiositySolver::jacobi,
                                     RadiositySolver::progressive, RadiositySolver::southwell, RadiositySolver::lu};
constexpr std::size_t most_sweeps = 2000;  // of one that hardly comes down

}  // namespace

bool SolverRace::large() const {
  return solution_->patches->patches.size() > most_patches || !solution_->matrix->whole();
}

void SolverRace::run(const SolutionHandle& solution, const Radiosity& options) {
  const bool same = solution_ && solution && same_system(*solution_, *solution) &&
                    options_.residual == options.residual && options_.memory == options.memory;
  if (same || (!solution_ && !solution)) return;
  const bool same_patches = solution_ && solution && solution_->matrix == solution->matrix;
  solution_ = solution, options_ = options;
  allowed_ = allowed_ && same_patches;
  {
    const std::lock_guard lock(mutex_);
    running_ = solution;
    entries_ = std::make_shared<const Entries>();
  }
  if (solution && !needs_leave()) return start();
  if (worker_.busy()) worker_.submit([](Progress&) {}, true);
}

void SolverRace::allow() {
  if (!needs_leave()) return;
  allowed_ = true;
  start();
}

void SolverRace::start() {
  worker_.submit(
      [this, solution = solution_, options = options_](Progress& progress) {
        for (const RadiositySolver kind : order) run_one(solution, options, kind, progress);
      },
      true);
}

void SolverRace::run_one(const SolutionHandle& solution, Radiosity options, RadiositySolver kind, Progress& progress) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds often{200};
  options.solver = kind;
  Entry entry;
  // The window's own solution was solved like this: its curve is there.
  if (solution->options.solver == kind && solution->options.residual == options.residual && !solution->curve.empty())
    return put(solution, kind, {solution->curve, solution->figures.end, {}});
  try {
    Solver solver(system_of(*solution->patches, solution->matrix), options, drawing_threads());
    auto told = Clock::now();
    while (solver.end() == SolverEnd::none && solver.sweeps() < double(most_sweeps)) {
      solver.sweep(progress);
      if (Clock::now() - told < often) continue;
      told = Clock::now();
      put(solution, kind, {solver.curve(), solver.end(), {}});
    }
    entry.curve = solver.curve(), entry.end = solver.end();
  } catch (const InputError& e) {
    entry.problem = Text(e.message(Language::english), e.message(Language::japanese));
  } catch (const std::bad_alloc&) {
    entry.problem = Words{"There is not enough memory for this solver", "この解法に必要なメモリが足りない"};
  }
  put(solution, kind, std::move(entry));
}

void SolverRace::put(const SolutionHandle& solution, RadiositySolver kind, Entry entry) {
  {
    const std::lock_guard lock(mutex_);
    if (running_ != solution) return;
    auto next = std::make_shared<Entries>(*entries_);
    (*next)[std::size_t(kind)] = std::move(entry);
    entries_ = std::move(next);
  }
  if (wake_) wake_();
}

std::shared_ptr<const SolverRace::Entries> SolverRace::entries() const {
  const std::lock_guard lock(mutex_);
  return entries_;
}

}  // namespace cg
