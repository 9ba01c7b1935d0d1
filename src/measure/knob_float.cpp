// float against double in radiosity: the form factors that are kept, their sum, and the light that is added up.
#include <cmath>
#include <limits>

#include "measure/knob_list.h"
#include "measure/ladder_parts.h"
#include "measure/radiosity_parts.h"
#include "params/numbers.h"
#include "radiosity/closed_form.h"
#include "radiosity/solver.h"
#include "scene/cpu_clock.h"

namespace cg {

namespace {

enum Precisions { rounded_rows, scaled_rows, float_sums, all_double };

// Closed forms of all pairs, each row divided by its sum.
std::vector<double> factors_in_double(const Patches& patches) {
  const std::size_t n = patches.patches.size();
  const auto corners = [](const Patch& p) { return std::span(p.corner.data(), std::size_t(p.corners)); };
  std::vector<double> out(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j)
      if (j != i) sum += out[i * n + j] = polygon_form_factor(corners(patches.patches[i]), corners(patches.patches[j]));
    if (patches.closed && sum > 0)
      for (std::size_t j = 0; j < n; ++j) out[i * n + j] /= sum;
  }
  return out;
}

std::vector<double> areas_of(const Patches& patches) {
  std::vector<double> area;
  for (const Patch& p : patches.patches) area.push_back(p.area);
  return area;
}

// Kept as float, each row's sum as it comes or made 1 by a factor in double.
std::shared_ptr<const FormFactorMatrix> in_float(const Patches& patches, const std::vector<double>& factors,
                                                 bool scaled, Progress& progress) {
  const std::size_t n = patches.patches.size();
  const auto row = [&factors, n](std::uint32_t i, const Progress&) {
    FormFactorRow out;
    for (std::size_t j = 0; j < n; ++j)
      if (const auto f = float(factors[i * n + j]); f > 0) out.factors.push_back({std::uint32_t(j), f});
    out.sum = 1;
    return out;
  };
  return FormFactorMatrix::make({.rows = n, .kept_rows = n}, {row, {}}, areas_of(patches), scaled, 1, progress);
}

// Gauss and Seidel's iteration with nothing but floats, until no digit changes any more or none should.
std::vector<glm::dvec3> gauss_seidel_in_float(const RadiositySystem& system, const std::vector<double>& factors,
                                              const Progress& progress) {
  const std::size_t n = system.emission.size();
  std::vector<float> f(factors.begin(), factors.end());
  std::vector<glm::vec3> b(system.emission.begin(), system.emission.end());
  const double rho = std::min(system.reflectance.front().x, 1 - 1e-6);
  const auto enough = long(std::log(double(std::numeric_limits<float>::epsilon()) / 16) / std::log(rho));
  for (long sweep = 0; sweep < enough; ++sweep) {
    if (progress.cancelled) throw Cancelled{};
    for (std::size_t i = 0; i < n; ++i) {
      glm::vec3 sum(0);
      for (std::size_t j = 0; j < n; ++j) sum += f[i * n + j] * b[j];
      b[i] = glm::vec3(system.emission[i]) + glm::vec3(system.reflectance[i]) * sum;
    }
  }
  return {b.begin(), b.end()};
}

// B as two rows of floats, the second what the first left: together they hold what double does, nearly.
ColourImage in_two_rows(const std::vector<glm::dvec3>& b) {
  ColourImage out(int(b.size()), 2);
  for (std::size_t i = 0; i < b.size(); ++i) {
    const glm::vec3 rounded(b[i]);
    out.at(int(i), 0) = rounded;
    out.at(int(i), 1) = glm::vec3(b[i] - glm::dvec3(rounded));
  }
  return out;
}

// As relative_errors(), of both rows together.
Errors errors_of_light(const Setting&, const Frame& frame, const Setting&, const Frame& reference) {
  const auto at = [](const Frame& f, int x) { return glm::dvec3(f.colour.at(x, 0)) + glm::dvec3(f.colour.at(x, 1)); };
  RelativeErrors sums;
  for (int x = 0; x < frame.colour.width(); ++x) sums.add(at(frame, x), at(reference, x));
  return sums.errors();
}

// What it cost is the solution alone.
Frame light_in(const Setting& setting, std::span<const Technique>, Progress& progress) {
  const Patches patches = make_patches(setting.scene, setting.scene.radiosity, progress);
  const std::vector<double> factors = factors_in_double(patches);
  const bool floats = setting.series == rounded_rows || setting.series == scaled_rows;
  const RadiositySystem system =
      system_of(patches, floats ? in_float(patches, factors, setting.series == scaled_rows, progress)
                                : FormFactorMatrix::of(factors, areas_of(patches)));
  Frame frame;
  CpuClock clock;
  if (setting.series == float_sums) {
    const std::vector<glm::dvec3> b = gauss_seidel_in_float(system, factors, progress);
    frame.cpu_ms = clock.lap_ms();
    frame.colour = in_two_rows(b);
    return frame;
  }
  Solver solver(system, setting.scene.radiosity);
  solver.run(progress);
  frame.cpu_ms = clock.lap_ms();
  frame.colour = in_two_rows(solver.radiosity());
  return frame;
}

Ladder ladder(const TradeRequest& request) {
  constexpr double absorbed[] = {0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4};
  constexpr double least_in_float = 1e-3;  // below, its sweeps take seconds
  constexpr const char* names[] = {"rows", "scaled", "sums", "double"};
  Ladder out;
  Scene scene = scene_of_few_patches(request);
  const auto with = [&](double a, Precisions precision) {
    change_materials(scene, [a](Material& m) { m.k_d = glm::dvec3(1 - a); });
    scene.radiosity.solver = precision == float_sums ? RadiositySolver::gauss_seidel : RadiositySolver::lu;
    Setting s = radiosity_setting(scene, names[precision] + ("-" + number_text(1 - a)), 1 / a, std::size_t(precision));
    s.label = {number_text(1 - a), number_text(1 - a)};
    return s;
  };
  for (const Precisions precision : {rounded_rows, scaled_rows, float_sums})
    for (std::size_t i = 0; i < std::size(absorbed); ++i) {
      if (precision == float_sums && absorbed[i] < least_in_float) break;
      out.settings.push_back(with(absorbed[i], precision));
      out.settings.back().reference = i;
    }
  for (const double a : absorbed) out.references.push_back(with(a, all_double));
  return out;
}

}  // namespace

Knob radiosity_float_knob() {
  Knob k;
  k.id = "radiosity-float";
  k.scene = "models/closed-cube.json";
  k.name = {"Form factors as float or double", "形態係数の float と double"};
  k.help = {
      "Form factors are kept as floats, half the memory. What that costs as ρ comes near 1: with rows as they are "
      "rounded, with rows scaled to sum 1 in double (as it is done here), and with the light added up in float "
      "too.",
      "形態係数を float で保存するとメモリは半分になる。ρ が 1 に近づくと何が失われるか。行を丸めたまま、行の和を "
      "double で 1 に直す（このプログラムの方法）、光の和も float で計算する、の三つを比べる。"};
  k.parameter = "material.k_d";
  k.abscissa = {"κ", {"1/(1 − ρ)", "1/(1 − ρ)"}};
  k.labels = {"ρ", "ρ"};
  k.reference = {"the same factors in double, by LU", "同じ形態係数を double で、LU 分解で解いた解"};
  k.error = {"largest error of B, over the largest B", "B の最大誤差 ÷ B の最大値"};
  k.plotted = ErrorKind::max;
  k.errors = errors_of_light;
  k.draw = light_in;
  k.series = {{"rows", {"Rows as rounded", "行を丸めたまま"}},
              {"scaled", {"Rows scaled in double", "行の和を double で 1 に直す"}},
              {"sums", {"Light summed in float", "光の和も float"}}};
  constexpr std::string_view higham = "Nicholas Higham, Accuracy and Stability of Numerical Algorithms, 2002";
  k.predictions = {
      {.series = 0,
       .of = ErrorKind::max,
       .order = 1,
       .law = "κ^1",
       .why = {"A row's sum is off by the floats' rounding δ, and every bounce adds it: δρ/(1 − ρ).",
               "行の和が丸めで δ だけずれ、反射のたびに加わるので δρ/(1 − ρ) になる。"},
       .source = higham},
      {.series = 1,
       .of = ErrorKind::max,
       .order = -1,
       .law = "κ^(-1)",
       .why = {"Each sum is 1 and A_i F_ij = A_j F_ji stays: even light, which alone grows with ρ, is met exactly.",
               "和が 1 で相反則 A_i F_ij = A_j F_ji も残るので、ρ とともに増える一様な光は正確に求まる。"},
       .otherwise = {"Where patches differ in size, rounding breaks A_i F_ij = A_j F_ji, and the error stays level.",
                     "パッチの大きさが違うと丸めで相反則が崩れ、誤差は減らない。"},
       .source = higham},
      {.series = 2,
       .of = ErrorKind::max,
       .order = 1,
       .law = "κ^1",
       .why = {"Every sweep rounds the light anew by some 2^(-24), and 1/(1 − ρ) of such errors come together.",
               "スイープごとに 2^(-24) ほどの丸めが入り、1/(1 − ρ) 回分たまる。"},
       .source = higham}};
  k.bend_low = {"there the rounding of each factor is what is left.", "残るのは係数一つ一つの丸め。"};
  k.bend_high = {"there the light stops changing before its last digits are right.",
                 "最後の桁が正しくなる前に、光の値が変わらなくなる。"};
  k.ladder = ladder;
  return k;
}

}  // namespace cg
