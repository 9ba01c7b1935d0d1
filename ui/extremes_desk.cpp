#include "ui/extremes_desk.h"

#include <algorithm>

#include "params/input_error.h"
#include "raster/software.h"
#include "ui/app.h"
#include "ui/trade_desk.h"
#include "ui/verdict_mark.h"

namespace cg {

void ExtremesDesk::check_all(const App& app) {
  std::vector<const ExtremeCase*> open, every;
  for (const ExtremeCase& c : extreme_cases()) {
    every.push_back(&c);
    if (!verdict(c)) open.push_back(&c);
  }
  if (open.empty()) {
    const std::lock_guard lock(mutex_);
    results_.clear(), verdicts_.clear();
    open = every;
  }
  run(app, std::move(open), true);
}

void ExtremesDesk::check(const App& app, const ExtremeCase& subject) {
  if (checking_all() || verdict(subject)) return;
  run(app, {&subject}, false);
}

void ExtremesDesk::run(const App& app, std::vector<const ExtremeCase*> subjects, bool all) {
  std::vector<Technique> techniques = app.techniques;
  for (Technique& t : techniques)
    if (t.id == "software") t = software_technique();  // it needs no turn of its own
  {
    const std::lock_guard lock(mutex_);
    all_ = all;
  }
  checker_.submit(
      [this, subjects = std::move(subjects), techniques = std::move(techniques)](Progress& progress) {
        const auto take = [&](std::span<const ExtremeResult> results) {
          if (results.empty()) return;
          {
            const std::lock_guard lock(mutex_);
            const std::string& id = results[0].subject->id;
            results_[id].assign(results.begin(), results.end());
            verdicts_[id] = worst_of(results);
          }
          wake_();
        };
        try {
          run_extremes(subjects, techniques, progress, take);
        } catch (const Cancelled&) {
        }
        {
          const std::lock_guard lock(mutex_);
          if (!progress.cancelled) all_ = false;
        }
        wake_();
      },
      true);
}

void ExtremesDesk::stop() {
  checker_.submit([](Progress&) {}, true);
  const std::lock_guard lock(mutex_);
  all_ = false;
}

bool ExtremesDesk::checking_all() const {
  const std::lock_guard lock(mutex_);
  return all_;
}

float ExtremesDesk::fraction() const {
  const std::lock_guard lock(mutex_);
  return float(verdicts_.size()) / float(std::max<std::size_t>(extreme_cases().size(), 1));
}

std::vector<ExtremeResult> ExtremesDesk::of(const ExtremeCase& subject) const {
  const std::lock_guard lock(mutex_);
  const auto found = results_.find(subject.id);
  return found == results_.end() ? std::vector<ExtremeResult>{} : found->second;
}

std::optional<Verdict> ExtremesDesk::verdict(const ExtremeCase& subject) const {
  const std::lock_guard lock(mutex_);
  const auto found = verdicts_.find(subject.id);
  return found == verdicts_.end() ? std::nullopt : found->second;
}

std::shared_ptr<const std::vector<Naive::Row>> ExtremesDesk::rows(const ExtremeCase& subject) {
  if (!subject.naive) return nullptr;
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = rows_.find(subject.id); found != rows_.end()) return found->second;
  }
  if (std::exchange(rows_asked_, subject.id) == subject.id) return nullptr;
  computer_.submit([this, &subject](Progress&) {
    auto rows = std::make_shared<const std::vector<Naive::Row>>(subject.naive->rows());
    {
      const std::lock_guard lock(mutex_);
      rows_[subject.id] = rows;
    }
    wake_();
  });
  return nullptr;
}

void ExtremesDesk::apply(App& app, const ExtremeCase& subject) {
  if (!subject.scene) return;
  app.errands->run(app, [&subject]() -> Errands::Done {
    auto scene = std::make_shared<Scene>(subject.scene->make());
    return [scene](App& a) {
      ExtremesDesk& desk = extremes_of(a);
      if (can_be_kept(a.scene)) desk.before = a.scene;
      stop_measuring(a);
      a.history.end_gesture();
      a.scene = std::move(*scene);
      a.history.change(a.scene);
      a.light = a.object = 0;
      a.isolated = {};
      a.probing = {};
    };
  });
}

ExtremesDesk& extremes_of(App& app) {
  if (!app.extremes) app.extremes = std::make_shared<ExtremesDesk>(app.wake);
  return *app.extremes;
}

bool can_be_kept(const Scene& scene) {
  return std::all_of(scene.objects.begin(), scene.objects.end(), [](const Object& o) { return !o.model.empty(); });
}

}  // namespace cg
