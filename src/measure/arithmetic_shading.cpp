// The formulas of the light model as textbooks write them, beside the forms that survive their extremes, in float.
// This work is based on: Nicholas Higham, Accuracy and Stability of Numerical Algorithms, 2nd edition, 2002.
#include <cmath>

#include "measure/arithmetic.h"
#include "measure/extreme_tables.h"
#include "params/numbers.h"
#include "shading/light_model.h"

namespace cg {

namespace {

using V = Vec3<float>;
using Rows = std::vector<Naive::Row>;

const V up{0, 0, 1};

// A unit vector beside (0, 0, 1) where cos^n is one half.
V at_half(double n) {
  const double theta = std::acos(std::pow(0.5, 1 / n));
  return V(float(std::sin(theta)), 0.0f, float(std::cos(theta)));
}

Rows thin_highlights() {
  Rows rows;
  for (const double n : {1e2, 1e4, 1e5, 1e6}) {
    const V H = at_half(n);
    const float cosine = glm::dot(up, H);
    rows.push_back({"n = " + number_text(n), std::pow(cosine, float(n)), lobe_power(up, H, cosine, float(n)), 0.5});
  }
  return rows;
}

// As graphics processors compute a power: 2^(n log2 c).
Rows powers_of_nothing() {
  Rows rows;
  const auto add = [&](double cosine, float n, double right) {
    const float c = float(cosine);
    const V H(std::sqrt(1 - c * c), 0.0f, c);
    rows.push_back({"c = " + number_text(cosine) + ", n = " + number_text(n), std::exp2(n * std::log2(c)),
                    lobe_power(up, H, positive(c), n), right});
  };
  add(0, 0, 1), add(-0.5, 2, 0), add(-1e-25, 3, 0), add(0.5, 2, 0.25);
  return rows;
}

// Two equal vectors whose product of lengths rounds to a little over 1.
V with_dot_over_1() {
  V v(0);
  for (int i = 1; i < 1000 && !(glm::dot(v, v) > 1); ++i) v = unit(V(float(i), 3.0f, 7.0f));
  return v;
}

Rows powers_over_1() {
  Rows rows;
  const V v = with_dot_over_1();
  for (const float n : {1e3f, 1e4f, 1e6f})
    rows.push_back({"N·H = 1 + 2^-23, n = " + number_text(n), std::pow(glm::dot(v, v), n),
                    lobe_power(v, v, glm::dot(v, v), n), 1});
  return rows;
}

Rows angles() {
  Rows rows;
  const auto add = [&](const std::string& input, const V& a, const V& b, double right) {
    rows.push_back(
        {input, std::acos(glm::dot(a, b)), std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)), right});
  };
  const V v = with_dot_over_1();
  add("a = b, a·b = 1 + 2^-23", v, v, 0);
  for (const double angle : {1e-5, 1e-4, 1e-2, 1.0})
    add(number_text(angle) + " rad", up, V(float(std::sin(angle)), 0.0f, float(std::cos(angle))), angle);
  return rows;
}

Rows unit_lengths() {
  Rows rows;
  for (const double size : {0.0, 1e-30, 1e-25, 1.0, 1e20, 3e37}) {
    const V v(float(3 * size), 0.0f, float(4 * size));
    const V naive = v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    rows.push_back({"(3, 0, 4) times " + number_text(size), naive.z, unit(v).z, size == 0 ? 0 : 0.8});
  }
  return rows;
}

Rows half_vectors() {
  Rows rows;
  for (const double off : {0.0, 0.5}) {
    const V V_(0, 0, 1), L(float(std::sin(off)), 0.0f, float(off == 0 ? -1 : std::cos(off)));
    const V sum = L + V_;
    rows.push_back({off == 0 ? "L = -V" : "L beside V", (sum / std::sqrt(glm::dot(sum, sum))).z, half_vector(L, V_).z,
                    off == 0 ? 0 : std::cos(off / 2)});
  }
  return rows;
}

EyeLight<float> light_at(float z) {
  EyeLight<float> light{};
  light.position = {0, 0, z};
  light.spot_cosine = -2;
  return light;
}

Rows attenuations() {
  Rows rows;
  for (const double distance : {1.0, 1e10, 1e20, 1e30}) {
    const float r = float(distance);
    EyeLight<float> light = light_at(r);
    light.k_0 = 2;
    rows.push_back({"r = " + number_text(distance) + ", k_2 = 0", 1 / (light.k_0 + light.k_1 * r + light.k_2 * (r * r)),
                    light_factors(light, Reflection::half_vector, 1.0f, V(0), up, up).attenuation, 0.5});
  }
  return rows;
}

// Points at and just behind a spot whose cone is a half-space.
Rows half_space_spots() {
  Rows rows;
  for (const double behind : {3e-8, 1e-8, 0.0, -1e-3}) {
    EyeLight<float> light = light_at(0);
    light.spot_direction = {0, 0, 1};
    light.spot_cosine = float(std::cos(pi / 2));  // -4.4e-8 in float
    const V P(1.0f, 0.0f, float(-behind));
    const float c = glm::dot(unit(P), light.spot_direction);
    rows.push_back({"cos = " + number_text(0 - behind), c >= std::cos(float(pi) / 2) ? 1.0 : 0.0,
                    light_factors(light, Reflection::half_vector, 1.0f, P, up, up).spot, behind < 0 ? 1.0 : 0.0});
  }
  return rows;
}

// max(NaN, 0) is NaN or 0, as the arguments stand.
Rows clamped_nan() {
  const float nan = std::nanf("");
  return {{"NaN", std::max(nan, 0.0f), positive(nan), 0}, {"-1", std::max(-1.0f, 0.0f), positive(-1.0f), 0}};
}

}  // namespace

void add_shading_arithmetic(ExtremeTable& all) {
  all.push_back(naive_case("thin-highlight", {"A thin highlight at half its height", "細いハイライトの半分の高さ"},
                           "material.n", "up to 1e6", {"1/2: N·H is 2^(-1/n).", "1/2。N·H = 2^(-1/n) なので。"}, 2e-4,
                           {"pow(N·H, n)",
                            "exp(n/2 log1p(-|N×H|²))",
                            {"Near 1 float has steps of 6e-8, and the power multiplies a cosine's error by n.",
                             "1 の近くの float は 6e-8 刻みで、冪は余弦の誤差を n 倍にするため。"},
                            thin_highlights}));
  all.push_back(naive_case("power-of-nothing", {"A power of 0, or of less", "0 以下の数の冪"}, "material.n",
                           "0, or N·H ≤ 0", {"0^0 = 1, and 0 where N·H ≤ 0.", "0^0 = 1、N·H ≤ 0 なら 0。"}, 1e-6,
                           {"exp2(n log2(c))",
                            "c > 0 ? pow(c, n) : n == 0",
                            {"log2(0) is -∞ and 0 times that is NaN; of a negative number there is no logarithm.",
                             "log2(0) は -∞ で、その 0 倍は NaN。負の数には対数がないため。"},
                            powers_of_nothing}));
  all.push_back(naive_case("power-over-1", {"A cosine that rounds to over 1", "丸めで 1 を超える余弦"}, "material.n",
                           "up to 1e6", {"1: both vectors are the same.", "1。二つのベクトルは等しい。"}, 1e-5,
                           {"pow(N·H, n)",
                            "exp(n/2 log1p(-|N×H|²))",
                            {"Unit vectors round to 1 ± 1e-7 in length, and (1 + 1e-7)^n grows with n.",
                             "単位ベクトルも丸めで長さが 1 ± 1e-7 になり、(1 + 1e-7)^n は n とともに大きくなるため。"},
                            powers_over_1}));
  all.push_back(naive_case("acos", {"The angle between two directions", "二つの方向のなす角"}, "angle", "0 … 1 rad",
                           {"The angle itself.", "角度そのもの。"}, 1e-6,
                           {"acos(a·b)",
                            "atan2(|a×b|, a·b)",
                            {"A cosine says nothing of angles below 3e-4 in float, and over 1 it has no angle: NaN.",
                             "float の余弦では 3e-4 未満の角を区別できず、1 を超えると角がなく NaN になるため。"},
                            angles}));
  all.push_back(
      naive_case("normalize", {"A vector of any length made unit", "任意の長さのベクトルの正規化"}, "|v|", "0 … 1.5e38",
                 {"0.8 of (3, 0, 4)/5; 0 where there is no direction.", "(3, 0, 4)/5 の 0.8。向きがなければ 0。"}, 1e-6,
                 {"v / sqrt(v·v)",
                  "s = v / max|v_i|; s / sqrt(s·s)",
                  {"The squares of 1e-25 and 1e20 leave float's range: 0 or ∞ is divided by.",
                   "1e-25 や 1e20 の二乗は float の範囲を出るので、0 や ∞ で割ることになる。"},
                  unit_lengths}));
  all.push_back(naive_case("half-vector",
                           {"The half vector of a light behind the eye's ray", "視線と正反対の光のハーフベクトル"}, "L",
                           "-V", {"No direction: 0; else cos(θ/2).", "向きがないので 0。ほかは cos(θ/2)。"}, 1e-6,
                           {"(L + V) / |L + V|",
                            "unit(L + V), 0 of 0",
                            {"L + V is 0 there, and 0/0 is NaN.", "L + V が 0 になり、0/0 は NaN になるため。"},
                            half_vectors}));
  all.push_back(
      naive_case("attenuation", {"Attenuation of a far light", "遠い光源の減衰"}, "r", "1e20, k_2 = 0",
                 {"1/k_0 = 0.5.", "1/k_0 = 0.5。"}, 1e-6,
                 {"1 / (k_0 + k_1 r + k_2 r²)",
                  "1 / (k_0 + r (k_1 + r k_2))",
                  {"r² is over 3.4e38, and 0 times ∞ is NaN.", "r² が 3.4e38 を超え、0 × ∞ は NaN になるため。"},
                  attenuations}));
  all.push_back(naive_case("spot-90", {"The edge of a spot of 90°", "90° のスポットの境界"}, "lights.0.cutoff", "90°",
                           {"Dark at and behind the half-space's edge.", "半空間の境界とその裏は照らさない。"}, 0,
                           {"c >= cos(90°)",
                            "c >= cos(90°) && c > 0",
                            {"cos(π/2) is -4.4e-8 in float, as π is rounded: a strip behind the spot is lit.",
                             "π の丸めで cos(π/2) は float では -4.4e-8 になり、裏側の帯まで照らすため。"},
                            half_space_spots}));
  all.push_back(naive_case("max-nan", {"Clamping a NaN", "NaN の下限"}, "colour", "nan", {"0.", "0。"}, 0,
                           {"max(x, 0)",
                            "x > 0 ? x : 0",
                            {"max compares x < 0, which no NaN is: it keeps the NaN.",
                             "max は x < 0 を比べるが、NaN ではつねに偽なので NaN が残る。"},
                            clamped_nan}));
}

}  // namespace cg
