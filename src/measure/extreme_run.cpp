#include "measure/extreme_run.h"

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <thread>

#include "measure/extreme_check.h"
#include "params/input_error.h"
#include "params/numbers.h"

namespace cg {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Cancels work that takes too long, and work that is asked to stop from outside.
class Watchdog {
 public:
  Watchdog(const Progress& outside, double seconds)
      : outside_(outside),
        until_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))),
        thread_([this] { watch(); }) {}
  ~Watchdog() {
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    wake_.notify_all();
    thread_.join();
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  Progress inside;  // of the work that is watched

 private:
  void watch() {
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, std::chrono::milliseconds(20), [&] { return done_; }))
      if (outside_.cancelled || Clock::now() > until_) inside.cancelled = true;
  }

  const Progress& outside_;
  const Clock::time_point until_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool done_ = false;
  std::thread thread_;  // last: it uses the others
};

std::vector<ExtremeVariant> variants_of(const ExtremeScene& scene, Precision precision) {
  std::vector<ExtremeVariant> all = scene.variants;
  if (all.empty())
    all = {{ShadingMode::flat, true},
           {ShadingMode::gouraud, true},
           {ShadingMode::phong, true},
           {ShadingMode::gouraud, false},
           {ShadingMode::phong, false}};
  for (ExtremeVariant& v : all) v.precision = precision;
  return all;
}

Text of_variant(const ExtremeVariant& v) {
  const Words mode = names_of<ShadingMode>[std::size_t(v.mode)].label;
  return {std::string(mode.en) + (v.clamp ? "" : ", not clamped"),
          std::string(mode.ja) + (v.clamp ? "" : "、制限なし")};
}

Text joined(const Text& a, const Text& b) {
  if (a.en.empty() || b.en.empty()) return a.en.empty() ? b : a;
  return {a.en + ": " + b.en, a.ja + "：" + b.ja};
}

// One technique at one case: the worst of its variants.
class SceneRun {
 public:
  SceneRun(const ExtremeCase& subject, const Technique& technique, const Technique& reference, Progress& progress)
      : case_(subject), subject_(*subject.scene), technique_(technique), reference_(reference), progress_(progress) {}

  ExtremeResult run(Precision precision) {
    ExtremeResult worst = blank(Verdict::not_drawn);
    for (const ExtremeVariant& v : variants_of(subject_, precision)) {
      ExtremeResult result = guarded(v);
      if (result.verdict != Verdict::not_drawn) result.said = joined(of_variant(v), result.said);
      if (counts_more(result, worst)) worst = std::move(result);
    }
    return worst;
  }

 private:
  ExtremeResult blank(Verdict v, Text said = {}) const {
    ExtremeResult r;
    r.subject = &case_, r.by = technique_.id, r.verdict = v, r.said = std::move(said);
    if (v != Verdict::right) r.error = not_a_number;
    return r;
  }

  // A picture that was drawn counts more than one that was not, a broken one most.
  static bool counts_more(const ExtremeResult& a, const ExtremeResult& b) {
    const auto rank = [](Verdict v) {
      constexpr int ranks[] = {2, 4, 5, 3, 1, 6};
      return ranks[std::size_t(v)];
    };
    if (rank(a.verdict) != rank(b.verdict)) return rank(a.verdict) > rank(b.verdict);
    return a.verdict == Verdict::not_drawn ? b.said.en.empty() : a.error > b.error;
  }

  ExtremeResult guarded(const ExtremeVariant& variant) {
    try {
      return picture(variant);
    } catch (const Cancelled&) {
      throw;
    } catch (const InputError& e) {
      const Text said{e.message(Language::english), e.message(Language::japanese)};
      if (technique_.unsupported && technique_.unsupported(subject_.make())) return blank(Verdict::unavailable, said);
      return blank(Verdict::broken, said);
    } catch (const std::exception& e) {
      return blank(Verdict::broken, {std::string("threw: ") + e.what(), std::string("例外：") + e.what()});
    }
  }

  ExtremeResult picture(const ExtremeVariant& variant) {
    Scene scene = subject_.make();
    apply(variant, scene);
    if (technique_.unsupported)
      if (const auto why = technique_.unsupported(scene)) return blank(Verdict::not_drawn, *why);
    View view{subject_.width, subject_.height};
    view.ids = view.normals = true;
    const Plan plan = technique_.plan(scene, view);
    if (subject_.refusal) return refused(scene, plan, view);
    const Frame frame = technique_.render(scene, plan, view, progress_);
    const ExtremePicture made{technique_, scene, plan, frame, variant, reference_, view, progress_};
    ExtremeResult r = judged(made);
    const std::string& note = technique_.id == "gl-fixed" ? subject_.fixed_note : subject_.note;
    if (r.verdict == Verdict::right && !note.empty() && !says(plan, note))
      r = blank(Verdict::off, {"the plan does not say: " + note, "処理計画に注意書きがない：" + note});
    return r;
  }

  ExtremeResult judged(const ExtremePicture& made) const {
    ExtremeResult r = blank(Verdict::right);
    const std::size_t bad = made.frame.nan_pixels;
    const bool nan = bad > 0 && !subject_.counts_nan;
    if (nan) {
      r = blank(Verdict::broken,
                {std::to_string(bad) + " pixels are NaN or infinite", std::to_string(bad) + " 画素が NaN か無限大"});
    } else {
      const ExtremeError e = subject_.check(made);
      r.error = e.error, r.said = e.said;
      if (std::isnan(e.error))
        r.verdict = Verdict::broken;
      else if (e.error > case_.tolerance)
        r.verdict = Verdict::off;
    }
    const auto& fault = case_.driver_fault;
    if (is_failure(r.verdict) && fault && fault->technique == technique_.id)
      if (const ExtremeError e = fault->shown(made); e.error <= case_.tolerance)
        r.verdict = Verdict::driver, r.said = fault->what;
    return r;
  }

  ExtremeResult refused(const Scene& scene, const Plan& plan, const View& view) {
    try {
      technique_.render(scene, plan, view, progress_);
    } catch (const InputError& e) {
      const Text said{e.message(Language::english), e.message(Language::japanese)};
      const bool told = said.en.find(*subject_.refusal) != said.en.npos && !e.accepted.en.empty();
      ExtremeResult r = blank(told ? Verdict::right : Verdict::off, said);
      if (told) r.error = 0;
      return r;
    }
    return blank(Verdict::off, Words{"it was drawn, without an error", "エラーにならず描かれた"});
  }

  static bool says(const Plan& plan, const std::string& note) {
    for (const Text& said : plan.notes)
      if (said.en.find(note) != said.en.npos) return true;
    return false;
  }

  const ExtremeCase& case_;
  const ExtremeScene& subject_;
  const Technique &technique_, &reference_;
  Progress& progress_;
};

const Technique& reference_among(std::span<const Technique> all, const Technique& otherwise) {
  for (const Technique& t : all)
    if (t.id == "software" && !t.unavailable) return t;
  return otherwise;
}

void run_scene(const ExtremeCase& subject, std::span<const Technique> techniques, Progress& progress,
               const ExtremeLimits& limits, std::vector<ExtremeResult>& out) {
  for (const Technique& t : techniques) {
    if (std::find(subject.techniques.begin(), subject.techniques.end(), t.id) == subject.techniques.end()) continue;
    for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
      const bool is_float = precision == Precision::single_precision;
      if (is_float && t.id != "software") continue;  // what the others compute in is theirs
      const auto start = Clock::now();
      ExtremeResult result;
      if (t.unavailable) {
        result = {&subject, t.id, Verdict::unavailable, not_a_number, *t.unavailable};
      } else {
        Watchdog watchdog(progress, limits.seconds);
        try {
          result = SceneRun(subject, t, reference_among(techniques, t), watchdog.inside).run(precision);
        } catch (const Cancelled&) {
          if (progress.cancelled) throw;
          const std::string s = number_text(limits.seconds);
          result = {
              &subject, t.id, Verdict::broken, not_a_number, {"did not end in " + s + " s", s + " 秒で終わらなかった"}};
        }
      }
      if (is_float) result.by = "software-float";
      result.ms = ms_since(start);
      out.push_back(std::move(result));
    }
  }
}

ExtremeResult run_input(const ExtremeCase& subject) {
  ExtremeResult r{&subject, "reader"};
  try {
    const ExtremeError e = subject.input->take();
    r.error = e.error, r.said = e.said;
    r.verdict = std::isnan(e.error) ? Verdict::broken : e.error > subject.tolerance ? Verdict::off : Verdict::right;
  } catch (const InputError& e) {  // what it needs is not on this machine
    r.verdict = Verdict::unavailable, r.error = not_a_number;
    r.said = {e.message(Language::english), e.message(Language::japanese)};
  } catch (const std::exception& e) {
    r.verdict = Verdict::broken, r.error = not_a_number, r.said = {e.what(), e.what()};
  }
  return r;
}

double relative(double value, double right) { return std::abs(value - right) / (right != 0 ? std::abs(right) : 1); }

// The robust form is right in every row, and the naive one is not in some: else the rows show nothing.
ExtremeResult run_naive(const ExtremeCase& subject) {
  ExtremeResult r{&subject, "arithmetic"};
  bool naive_fails = false;
  for (const Naive::Row& row : subject.naive->rows()) {
    const double error = relative(row.robust, row.right);
    if (is_worse(error, r.error)) r.error = error, r.said = {row.input, row.input};
    naive_fails = naive_fails || !(relative(row.naive, row.right) <= subject.tolerance);
  }
  if (std::isnan(r.error))
    r.verdict = Verdict::broken;
  else if (r.error > subject.tolerance)
    r.verdict = Verdict::off;
  else if (!naive_fails)
    r.verdict = Verdict::off, r.said = Words{"the naive form is right in every row", "素朴な式がどの行でも正しい"};
  return r;
}

}  // namespace

std::vector<ExtremeResult> run_extreme(const ExtremeCase& subject, std::span<const Technique> techniques,
                                       Progress& progress, const ExtremeLimits& limits) {
  if (progress.cancelled) throw Cancelled{};
  std::vector<ExtremeResult> out;
  if (subject.scene) run_scene(subject, techniques, progress, limits, out);
  for (const bool input : {true, false}) {
    if (input ? !subject.input : !subject.naive) continue;
    const auto start = Clock::now();
    ExtremeResult result = input ? run_input(subject) : run_naive(subject);
    result.ms = ms_since(start);
    out.push_back(std::move(result));
  }
  return out;
}

std::vector<ExtremeResult> run_extremes(const std::vector<const ExtremeCase*>& subjects,
                                        std::span<const Technique> techniques, Progress& progress,
                                        const std::function<void(std::span<const ExtremeResult>)>& done,
                                        const ExtremeLimits& limits) {
  std::vector<ExtremeResult> all;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const auto results = run_extreme(*subjects[i], techniques, progress, limits);
    all.insert(all.end(), results.begin(), results.end());
    progress.fraction = float(i + 1) / float(subjects.size());
    if (done) done(results);
  }
  return all;
}

}  // namespace cg
