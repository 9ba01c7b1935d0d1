// Radiosity's numbers where the printed formula, or float, loses them.
// This work is based on: John Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-11.
#include <array>
#include <cmath>

#include "math/transform.h"
#include "measure/arithmetic.h"
#include "measure/extreme_tables.h"
#include "params/numbers.h"
#include "radiosity/closed_form.h"
#include "radiosity/sample_positions.h"

namespace cg {

namespace {

// C-11 as it stands in the books, for two squares of side x, 1 apart.
double opposite_as_printed(double x) {
  const double h = std::sqrt(1 + x * x);
  return 2 / (pi * x * x) *
         (std::log(std::sqrt(h * h * h * h / (1 + 2 * x * x))) + 2 * x * h * std::atan(x / h) - 2 * x * std::atan(x));
}

// The same as a smooth integral, by 8 x 8 Gauss points: 4/x^2 times that of (x - u)(x - v)/(pi (u^2 + v^2 + 1)^2).
double opposite_by_integral(double x) {
  double sum = 0;
  for (const RulePoint& p : gauss_rule(8, 0))
    for (const RulePoint& q : gauss_rule(8, 0)) {
      const double u = p.x * x, v = q.x * x, r = u * u + v * v + 1;
      sum += p.weight * q.weight * (x - u) * (x - v) / (pi * r * r);
    }
  return 4 * sum;
}

std::vector<Naive::Row> opposite_rows() {
  const glm::dvec3 o(0), along(1, 0, 0), across(0, 1, 0), up(0, 0, 1);
  std::vector<Naive::Row> rows;
  for (const double x : {0.3, 0.03, 1e-3, 1e-4, 1e-6}) {
    const std::array lower{o, x * along, x * (along + across), x * across};
    const std::array upper{up, up + x * across, up + x * (along + across), up + x * along};
    const double ours = polygon_form_factor(lower, upper);
    rows.push_back({"x = " + number_text(x), opposite_as_printed(x), ours, opposite_by_integral(x)});
  }
  return rows;
}

// The light of n patches that all see each other alike, after sweeps enough for 1e-9 (Gauss and Seidel).
template <class Real>
double furnace_by(double rho) {
  constexpr std::size_t n = 1000;
  const Real factor = Real(1) / Real(n - 1);
  std::vector<Real> b(n, Real(1));
  for (auto sweep = int(std::log(1e-9) / std::log(rho) / 1.5); sweep >= 0; --sweep)
    for (std::size_t i = 0; i < n; ++i) {
      Real sum = 0;
      for (std::size_t j = 0; j < n; ++j)
        if (j != i) sum += factor * b[j];
      b[i] = Real(1) + Real(rho) * sum;
    }
  return double(b[0]);
}

std::vector<Naive::Row> furnace_rows() {
  std::vector<Naive::Row> rows;
  for (const double rho : {0.5, 0.9})
    rows.push_back({"ρ = " + number_text(rho), furnace_by<float>(rho), furnace_by<double>(rho), 1 / (1 - rho)});
  return rows;
}

}  // namespace

void add_radiosity_arithmetic(ExtremeTable& all) {
  all.push_back(naive_case(
      "opposite-squares", {"The form factor of small squares, 1 apart", "距離 1 で向かい合う小さな正方形の形態係数"},
      "side", "0.3 … 1e-6", {"x²/π as x goes to 0.", "x が 0 に近づくと x²/π。"}, 1e-9,
      {"double: 2/(π x²) (ln √((1+x²)²/(1+2x²)) + 2x√(1+x²) atan(x/√(1+x²)) − 2x atan x)",
       "double: 1/(2π A) ∮∮ ln r dl·dl",
       {"The printed form is a difference of terms of size x² that cancel down to x⁴: double has 16 digits.",
        "本に載っている式は x² の大きさの項どうしが打ち消し合って x⁴ だけが残り、double の 16 桁では足りないため。"},
       opposite_rows}));
  all.push_back(
      naive_case("furnace-float", {"The light of 1000 patches added up", "1000 パッチの光の和"}, "ρ", "0.5, 0.9",
                 {"1/(1 − ρ).", "1/(1 − ρ)。"}, 2e-8,
                 {"float: b = 1 + ρ Σ f b",
                  "double: b = 1 + ρ Σ f b",
                  {"Each of a thousand additions rounds by 6e-8, and every bounce adds that again: 1/(1 − ρ) times.",
                   "千回の足し算のたびに 6e-8 の丸めが入り、反射のたびに加わって 1/(1 − ρ) 倍になるため。"},
                  furnace_rows}));
}

}  // namespace cg
