// Extremes as one table: each case names the parameter or input, the extreme value, what is right there, and how that
// is checked. The command, the window and the tests walk the same table; a new technique or parameter adds its rows.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "params/field.h"
#include "scene/technique.h"

namespace cg {

// What came out, against what is right.
struct ExtremeError {
  double error = 0;  // in the case's unit: 0 is exactly right; NaN is as wrong as can be
  Text said = {};    // the worst place ("pixel 12,40"), or what a reader answered
};

// Whether `error` is to take the place of the worst so far: NaN is the worst.
constexpr bool is_worse(double error, double worst) { return worst == worst && !(error <= worst); }

// How a picture is drawn, whatever the case changes in its scene.
struct ExtremeVariant {
  ShadingMode mode = ShadingMode::gouraud;
  bool clamp = true;
  Precision precision = Precision::double_precision;
};

// A finished picture, for a check.
struct ExtremePicture {
  const Technique& technique;
  const Scene& scene;
  const Plan& plan;
  const Frame& frame;
  ExtremeVariant variant;
  const Technique& reference;  // the software, or the technique itself where there is none
  View view;
  Progress& progress;
};
using PictureCheck = std::function<ExtremeError(const ExtremePicture&)>;

// A scene that techniques draw.
struct ExtremeScene {
  std::function<Scene()> make;  // meshes loaded
  PictureCheck check;
  std::string note = {};                      // what the plan must say (English), if anything
  std::string fixed_note = {};                // the same of gl-fixed
  std::vector<ExtremeVariant> variants = {};  // empty: flat, Gouraud and Phong, clamped; Gouraud and Phong, not clamped
  int width = 48, height = 48;
  bool counts_nan = false;                  // the check itself looks at Frame::nan_pixels; else one NaN is broken
  std::optional<std::string> refusal = {};  // the picture is refused by an InputError that says this (English)
};

// A file, a preset, an option, a text: what the program makes of it.
struct ExtremeInput {
  std::string text;                    // as it stands in the file, or is typed; the beginning where it is long
  std::function<ExtremeError()> take;  // throws InputError where this machine lacks what it needs
};

// A formula as a textbook writes it beside one that survives, both in float where they do not say double.
struct Naive {
  struct Row {
    std::string input;            // "x = 1e-25"
    double naive, robust, right;  // right: in double, another way, or in closed form
  };
  std::string naive_formula, robust_formula;  // "pow(c, n)", as in a program
  Words why;                                  // one sentence: why the naive form fails
  std::function<std::vector<Row>()> rows;     // computed when called
};

// A fault of a driver that is known: not ours where the picture is what the fault makes of it.
struct DriverFault {
  std::string technique;  // "gl-fixed"
  Text what;              // which driver, which fault
  PictureCheck shown;     // how far the picture is from what that driver draws
};

struct ExtremeCase {
  std::string id;         // "light-w-1e-30"
  std::string group;      // of extreme_groups()
  Text name;              // "A light's w next to 0"
  std::string parameter;  // what is turned: "lights.0.w", "OBJ file"
  std::string value;      // "1e-30"
  Text right;             // a sentence: what is right, and by which closed form or limit
  double tolerance = 0;
  // The kinds of subject; at least one is there.
  std::optional<ExtremeScene> scene = {};
  std::optional<ExtremeInput> input = {};
  std::optional<Naive> naive = {};
  std::vector<std::string_view> techniques = {"software", "gl-fixed", "gl"};  // whom a scene concerns
  std::optional<DriverFault> driver_fault = {};
};

// "lights", "attenuation", "spots", "materials", "normals", "meshes", "places", "cameras", "pictures", "files",
// "values", "radiosity", "arithmetic".
std::span<const Name> extreme_groups();

// In the groups' order. Made once; their scenes are made when asked for.
std::span<const ExtremeCase> extreme_cases();

// Those with that id, or in that group; all where `name` is empty. Throws InputError that lists the groups.
std::vector<const ExtremeCase*> find_extremes(std::string_view name, std::span<const ExtremeCase> all);

}  // namespace cg
