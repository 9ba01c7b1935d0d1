// A knob: something a user turns to trade speed for accuracy, as a value. It knows its ladder of settings, what each is
// compared with, and the order of convergence that theory predicts. A new knob is one file and one line in knobs.cpp.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/technique.h"

namespace cg {

// How what was drawn becomes the picture that is compared.
enum class Resampling {
  none,    // it is that picture
  box,     // drawn larger by a whole factor; a pixel is the mean of its samples
  tent,    // the same, weighted by a tent two pixels wide
  nearest  // drawn smaller by a whole factor; a pixel is repeated
};

// One step of a knob, or what steps are compared with.
struct Setting {
  std::string id;          // "gouraud-16": unique among its trade's settings
  Text label;              // beside its point: "16"
  std::size_t series = 0;  // index into Knob::series
  double x = 0;            // in Knob::abscissa, > 0
  Scene scene;             // to be drawn, or taken by the window; load_meshes() before drawing
  std::string technique;   // the id
  View view;               // as it is drawn
  Resampling resampling = Resampling::none;
  int factor = 1;             // of the resampling: view's size over the picture's (box, tent), or the reverse (nearest)
  std::size_t reference = 0;  // index into Ladder::references
};

struct Ladder {
  std::vector<Setting> settings;    // by series, each in the order of x
  std::vector<Setting> references;  // series, x and reference mean nothing
  std::vector<Text> notes;          // what a user should know: "this driver offers 4 samples at most"
};

// What a ladder is made for.
struct TradeRequest {
  const Scene& scene;  // meshes loaded
  std::span<const Technique> techniques;
  std::string technique;      // the one to use where the knob leaves a choice; empty: the knob's own
  int width = 0, height = 0;  // of the compared picture; 0: the knob's own
  int threads = 1;            // of the software techniques, for the settings
};

// How far a setting is off, in Knob::error_unit.
struct Errors {
  double rmse = 0, max = 0;
  double confidence = 0;    // half the width of the 95 % interval of rmse; 0 where nothing is random
  std::size_t samples = 0;  // pixels, or corners, that were compared
};

enum class ErrorKind { rmse, max };

// What theory says about one series: error ~ x^order.
struct Prediction {
  std::size_t series = 0;
  ErrorKind of = ErrorKind::rmse;
  double order = 0;
  double band = 0.15;       // so far a measured slope may be off and still agree
  std::string_view law;     // "h^2", in the notation of ui's formulas
  Words why;                // one sentence
  Words otherwise = {};     // one sentence: what scenes have that the theory leaves out, where the slope is another
  std::string_view source;  // author, title, year
};

struct Series {
  std::string_view id;
  Words name;
};

struct Abscissa {
  std::string_view letter;  // "h"
  Words name;
  std::string_view unit = "1";
};

struct Knob {
  std::string_view id;
  Words name;
  Words help;                   // what is turned and what one sees, a sentence or two
  std::string_view parameter;   // the path that it turns ("objects.0.tessellation"), or the choice ("--size")
  std::string_view scene = {};  // what it is shown with where none is named; empty: whatever is usual
  Abscissa abscissa;
  Words labels = {};  // what the numbers at the points are; empty: x
  Words reference;    // what a setting is compared with
  Words error;        // what the error is: "RMSE over the pixels that both cover"
  std::string_view error_unit = "1";
  ErrorKind plotted = ErrorKind::rmse;
  std::vector<Series> series;
  std::vector<Prediction> predictions;
  // What a bend of the curve at small x, and at large x, comes from: what follows "From h = 0.01 on the curve bends: ".
  Words bend_low, bend_high;
  // Throws InputError that says which scenes would work where this one does not.
  Ladder (*ladder)(const TradeRequest&) = nullptr;
  // Draws a setting; Frame::cpu_ms is what it cost. Null: draw_setting().
  Frame (*draw)(const Setting&, std::span<const Technique>, Progress&) = nullptr;
  // Null: colour_errors().
  Errors (*errors)(const Setting&, const Frame&, const Setting& reference, const Frame&) = nullptr;
};

// All of them, in the order of the lecture.
std::span<const Knob> knobs();

// Throws InputError that lists those there are.
const Knob& find_knob(std::string_view id);

// By the setting's technique, then resampled; Frame::cpu_ms is the sum of both. Frame::depth and the rest stay as
// drawn. Throws InputError and Cancelled.
Frame draw_setting(const Setting& setting, std::span<const Technique> techniques, Progress& progress);

// Of linear colour: over the pixels that both cover, or over all.
Errors colour_errors(const Setting&, const Frame& frame, const Setting& reference, const Frame& reference_frame);
Errors colour_errors_everywhere(const Setting&, const Frame& frame, const Setting& reference,
                                const Frame& reference_frame);

}  // namespace cg
