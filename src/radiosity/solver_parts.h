// What Solver holds: for its own files.
#pragma once
#include <chrono>

#include "radiosity/solver_history.h"

namespace cg {

// Of rho_i times the row's sum over all rows and channels: what a bounce keeps of the light, at most and at least, and
// at most where rows count as 1 that sum to less.
struct Bounce {
  double most = 0, least = 1e300, closed = 0;
};

// 1 to the last digits is 1.
inline bool absorbs(double bounce) { return bounce < 1 - 1e-13; }

struct Solver::Parts {
  RadiositySolver kind;
  double target;
  Bounce bounce;
  std::shared_ptr<const SolverData> data;
  RowSource rows;
  std::unique_ptr<Iteration> iteration;
  std::size_t stride;  // between two states that are remembered, and between two points of a shooting solver's curve
  SolverHistory history;
  std::vector<ResidualPoint> curve;
  std::size_t steps = 0;
  double seconds = 0;  // of the steps until `clock`
  std::chrono::steady_clock::time_point clock;
  SolverEnd end = SolverEnd::none;

  Parts(RadiositySystem system, const Radiosity& options, int threads, const Progress* progress);

  std::size_t size() const { return data->emission.size(); }
  double factor() const;
  void begin();
  // The clock runs from start() on; lap() brings `seconds` up to now. (A step may take less than asking for the time.)
  void start() { clock = std::chrono::steady_clock::now(); }
  void lap();
  void step(Progress& progress);
  void judge(const Standing& s);
  void note(double bound, bool may_grow);
  void restore(const SolverHistory::State& state);
  // How far it has come, on the way of logarithms that a residual goes.
  void tell(Progress& progress) const;
  void check(const Progress& progress) const {
    if (progress.cancelled.load(std::memory_order_relaxed)) throw Cancelled{};
  }
  // F x, by patch.
  std::vector<glm::dvec3> received(const Channels& x, Progress& progress);
};

}  // namespace cg
