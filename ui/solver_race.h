// How fast each solver comes down on the same system: all of them run to their end beside the window, one after the
// other, once.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "radiosity/solution.h"
#include "workbench/worker.h"

namespace cg {

inline constexpr std::size_t solver_count = names_of<RadiositySolver>.size();

class SolverRace {
 public:
  struct Entry {
    std::vector<ResidualPoint> curve;  // as far as it has come; empty: it has not begun
    SolverEnd end = SolverEnd::none;
    std::optional<Text> problem;  // why it does not run
  };
  using Entries = std::array<Entry, solver_count>;  // by RadiositySolver

  // `wake` is called on another thread when there is something new.
  explicit SolverRace(std::function<void()> wake) : wake_(std::move(wake)) {}

  // Once a frame: runs them where this system, the residual or the memory is another than before. Above
  // `most_patches`, or where rows are computed anew whenever they are asked for, nothing runs before allow().
  static constexpr std::size_t most_patches = 5000;
  void run(const SolutionHandle& solution, const Radiosity& options);
  bool needs_leave() const { return solution_ && !allowed_ && large(); }
  void allow();
  bool busy() const { return worker_.busy(); }
  // Never null; never changed once it is given out.
  std::shared_ptr<const Entries> entries() const;

 private:
  bool large() const;
  void start();
  void run_one(const SolutionHandle& solution, Radiosity options, RadiositySolver kind, Progress& progress);
  void put(const SolutionHandle& solution, RadiositySolver kind, Entry entry);

  const std::function<void()> wake_;
  SolutionHandle solution_;  // of the window's thread, as the next two
  Radiosity options_;
  bool allowed_ = false;
  mutable std::mutex mutex_;  // guards what follows
  SolutionHandle running_;
  std::shared_ptr<const Entries> entries_ = std::make_shared<const Entries>();
  Worker worker_;  // last: it uses what stands above
};

}  // namespace cg
