// A knob's trade, measured: what each setting costs and how far it is off, the Pareto front of the two, and the order
// of convergence beside the one that theory predicts.
#pragma once
#include <optional>

#include "measure/fit.h"
#include "measure/knob.h"
#include "params/tree.h"

namespace cg {

struct TradeOptions {
  int repeats = 9;            // rounds that are timed, at least 1; each draws every setting once, in a shuffled order
  double seconds = 0;         // and further rounds until the timed ones have taken so long: a machine's pace drifts
  int width = 0, height = 0;  // of the picture; 0: the knob's own
  int threads = 1;
  std::string technique;  // where the knob leaves a choice; empty: the knob's own
};
constexpr double usual_seconds = 10;  // of a trade that a person asks for

// Of the repeats: the median, the least and the greatest. Where the machine stays as it is, the median of nine new
// repeats lies between the least and the greatest of nine others in 97 of 100 runs: it takes five of one nine beyond
// all of the other, C(9,5)/C(18,5) a side. (Between their quartiles it would lie in about half of the runs.) It does
// not stay as it is: a processor's clock and its neighbours move all times of a second together, so that the repeats
// of a fast ladder must be spread over many seconds to say what another run may find.
struct Spread {
  double low = 0, median = 0, high = 0;
};
Spread spread_of(std::vector<double> values);

struct TradePoint {
  Errors errors;
  Spread ms;              // CPU time a call, all threads
  bool on_front = false;  // no other setting is both faster and more accurate
};

// A prediction held against what was measured.
struct PredictionCheck {
  std::size_t prediction = 0;  // index into Knob::predictions
  std::optional<LineFit> fit;  // nothing: too few errors above 0
  bool agrees = false;         // the slope lies within the prediction's band
  Text verdict;                // "measured h^1.98, predicted h^2", and where the curve bends and why
};

struct Machine {
  std::string cpu;
  std::string renderer;  // OpenGL's, where a setting draws with it
};

struct Trade {
  const Knob* knob = nullptr;
  std::string scene;  // as it was named
  int width = 0, height = 0;
  int repeats = 0;  // rounds that were timed
  Machine machine;
  Ladder ladder;                   // without meshes: load_meshes() before drawing
  std::vector<TradePoint> points;  // of ladder.settings
  std::vector<Spread> reference_ms;
  std::vector<PredictionCheck> checks;  // of knob->predictions
  std::vector<Text> notes;
};

// Draws every setting and every reference. `progress` runs once through all. The errors depend on nothing but the
// scene; the times on the machine. Throws InputError where the knob or a technique cannot work with the scene, and
// Cancelled.
Trade run_trade(const Knob& knob, const std::string& scene_name, const Scene& scene,
                std::span<const Technique> techniques, const TradeOptions& options, Progress& progress);

// Which of the points no other one beats in both; the first of equals. An error that is 0 or more and not a number is
// on no front.
std::vector<bool> pareto_front(std::span<const double> ms, std::span<const double> errors);

double error_of(const Errors& errors, ErrorKind kind);

Tree json_of(const Knob& knob);
Tree json_of(const Trade& trade);
// One row a setting, columns named in the first; RFC 4180, numbers as they read back.
std::string csv_of(const Trade& trade);
// For a person: lines, each ended.
std::string text_of(const Trade& trade, Language language);

// The processor's model name; empty where the system does not say.
std::string cpu_name();

}  // namespace cg
