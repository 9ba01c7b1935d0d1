// Extreme cases checked beside the window, on threads of their own.
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "measure/extreme_run.h"
#include "workbench/worker.h"

namespace cg {

struct App;

class ExtremesDesk {
 public:
  // `wake` is called on another thread when there is something new.
  explicit ExtremesDesk(std::function<void()> wake) : wake_(wake ? std::move(wake) : [] {}) {}

  // Checks those that have not been checked, in the table's order; again all of them where all have been.
  void check_all(const App& app);
  // One, unless it has been checked or all are being checked.
  void check(const App& app, const ExtremeCase& subject);
  void stop();
  bool checking_all() const;
  float fraction() const;  // of all of the table

  // What each technique gave; empty before it was checked.
  std::vector<ExtremeResult> of(const ExtremeCase& subject) const;
  std::optional<Verdict> verdict(const ExtremeCase& subject) const;
  // The naive form beside the robust one, computed soon after the first call for a case; null before.
  std::shared_ptr<const std::vector<Naive::Row>> rows(const ExtremeCase& subject);

  // The case's scene in place of the one in hand, as one step of undo, as soon as it is made.
  void apply(App& app, const ExtremeCase& subject);

  std::optional<Scene> before;  // the scene in hand before the first case was applied: what the session keeps

 private:
  void run(const App& app, std::vector<const ExtremeCase*> subjects, bool all);

  std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards what follows
  std::map<std::string, std::vector<ExtremeResult>> results_;
  std::map<std::string, std::optional<Verdict>> verdicts_;
  std::map<std::string, std::shared_ptr<const std::vector<Naive::Row>>> rows_;
  bool all_ = false;
  // Of the window's thread alone.
  std::string rows_asked_;
  Worker checker_, computer_;  // last: they use what stands above
};

// The window's own, made at the first call.
ExtremesDesk& extremes_of(App& app);

// Whether the scene can be opened again from what a preset keeps: the meshes of a case are in no file.
bool can_be_kept(const Scene& scene);

}  // namespace cg
