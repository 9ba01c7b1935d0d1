// Walks extreme cases through the techniques, and says of each: right, off by how much, or broken.
#pragma once
#include "measure/extreme.h"

namespace cg {

enum class Verdict { right, off, broken, driver, not_drawn, unavailable };
template <>
inline constexpr std::array<Name, 6> names_of<Verdict>{
    {{"right", {"right", "正しい"}},
     {"off", {"off", "ずれている"}},
     {"broken", {"broken", "壊れている"}},                  // NaN, an exception, no end
     {"driver", {"the driver's fault", "ドライバの欠陥"}},  // shown: the picture is what the known fault makes of it
     {"not-drawn", {"not drawn", "描けない"}},              // the technique says that it cannot draw it: no case for it
     {"unavailable", {"not available", "利用できない"}}}};  // the technique cannot work on this machine

constexpr bool is_failure(Verdict v) { return v == Verdict::off || v == Verdict::broken; }

struct ExtremeResult {
  const ExtremeCase* subject;  // never null
  // A technique's id; "software-float"; "reader" for an input; "arithmetic" for a formula in float.
  std::string by;
  Verdict verdict = Verdict::right;
  double error = 0;  // the worst, in the case's unit; NaN where there is none
  Text said = {};    // where it is worst, what is wrong, or what was answered
  double ms = 0;     // that it took
};

struct ExtremeLimits {
  double seconds = 20;  // for one picture: then it is cancelled, and broken
};

// One case. `techniques` must not be used by another thread meanwhile. Throws Cancelled, and nothing else.
std::vector<ExtremeResult> run_extreme(const ExtremeCase& subject, std::span<const Technique> techniques,
                                       Progress& progress, const ExtremeLimits& limits = {});

// Many, in order. `done`, if there, is called after each case with its results.
std::vector<ExtremeResult> run_extremes(const std::vector<const ExtremeCase*>& subjects,
                                        std::span<const Technique> techniques, Progress& progress,
                                        const std::function<void(std::span<const ExtremeResult>)>& done = {},
                                        const ExtremeLimits& limits = {});

}  // namespace cg
