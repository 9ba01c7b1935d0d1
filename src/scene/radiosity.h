// How a radiosity solution is computed: patches, form factors, the linear system.
#pragma once
#include "params/field.h"

namespace cg {

// Where the form factors come from.
enum class FormFactors { closed_form, nusselt, hemicube, monte_carlo };
template <>
inline constexpr std::array<Name, 4> names_of<FormFactors>{
    {{"closed-form", {"Closed form (nothing between)", "閉じた式（遮蔽なし）"}},
     {"nusselt", {"Nusselt projection", "ヌッセルト投影"}},
     {"hemicube", {"Hemicube", "ヘミキューブ"}},
     {"monte-carlo", {"Monte Carlo rays", "モンテカルロ法（光線）"}}}};

// Who draws a hemicube's item buffers.
enum class ItemBuffer { software, gl };
template <>
inline constexpr std::array<Name, 2> names_of<ItemBuffer>{
    {{"software", {"Software", "ソフトウェア"}}, {"gl", {"OpenGL", "OpenGL"}}}};

// Where on a patch the hemicubes stand.
enum class Placement { grid, gauss };
template <>
inline constexpr std::array<Name, 2> names_of<Placement>{
    {{"grid", {"Uniform grid", "等間隔"}}, {"gauss", {"Gauss points", "ガウス点"}}}};

// What a pixel of the hemicube counts: the lecture's delta form factor at its centre, or the same integrated over the
// pixel, so that all of them sum to exactly 1. The others are wrong: they keep a row's sum at 1 and miss each factor.
enum class PixelWeight { delta_form_factor, integrated, unweighted, solid_angle, r_squared };
template <>
inline constexpr std::array<Name, 5> names_of<PixelWeight>{
    {{"delta-form-factor", {"ΔF (right)", "ΔF（正しい）"}},
     {"integrated", {"ΔF over the pixel (right)", "画素内で積分した ΔF（正しい）"}},
     {"unweighted", {"All pixels alike", "どの画素も同じ"}},
     {"solid-angle", {"Solid angle only", "立体角だけ"}},
     {"r-squared", {"r² for r⁴", "r⁴ でなく r²"}}}};

// What is done to rows of a closed scene, whose sums are known to be 1.
enum class Normalise { none, rows, reciprocal };
template <>
inline constexpr std::array<Name, 3> names_of<Normalise>{
    {{"none", {"No", "しない"}, "false"},
     {"rows", {"Each row sums to 1", "各行の和を 1 に"}, "true"},
     {"reciprocal", {"Rows, and A_i F_ij = A_j F_ji", "和を 1 に、相反則も"}}}};

enum class RadiositySolver { jacobi, gauss_seidel, southwell, progressive, lu };
template <>
inline constexpr std::array<Name, 5> names_of<RadiositySolver>{
    {{"jacobi", {"Jacobi", "ヤコビ法"}},
     {"gauss-seidel", {"Gauss–Seidel", "ガウス・ザイデル法"}},
     {"southwell", {"Southwell (shooting)", "サウスウェル法（放出）"}},
     {"progressive", {"Progressive refinement", "漸進法（環境光の推定つき）"}},
     {"lu", {"LU (direct)", "LU 分解（直接法）"}}}};

struct Radiosity {
  double patch_size = 0.25;
  int adaptive_levels = 0;
  double gradient = 0.1;
  FormFactors form_factors = FormFactors::hemicube;
  ItemBuffer item_buffer = ItemBuffer::software;
  int resolution = 128;
  int samples = 2;
  Placement placement = Placement::gauss;
  int rays = 1024;
  PixelWeight weight = PixelWeight::delta_form_factor;
  Normalise normalise = Normalise::rows;
  RadiositySolver solver = RadiositySolver::gauss_seidel;
  double residual = 1e-6;
  double memory = 2048;
  friend bool operator==(const Radiosity&, const Radiosity&) = default;
};

template <>
inline constexpr auto fields_of<Radiosity> = std::tuple{
    field(&Radiosity::patch_size,
          {.name = "patch_size",
           .unit = "m",
           .range = {1e-6, 1e6},
           .slider = Range{0.02, 1},
           .scale = Scale::logarithmic,
           .label = {"Patch size", "パッチの大きさ"},
           .help = {"The longest side that a patch may have. Half of it makes four times the patches and sixteen times "
                    "the form factors.",
                    "パッチの辺の上限。半分にするとパッチは 4 倍、形態係数は 16 倍になる。"}}),
    field(
        &Radiosity::adaptive_levels,
        {.name = "adaptive_levels",
         .range = {0, 6},
         .label = {"Element levels", "要素の分割回数"},
         .help = {"How often a patch is cut in four elements where the radiosity changes fast. Patches shoot, elements "
                  "receive.",
                  "明るさの変化が急な所でパッチを 4 つの要素に分ける回数。放出はパッチ、受け取りは要素。"}}),
    field(&Radiosity::gradient,
          {.name = "gradient",
           .range = {0, 1e3},
           .slider = Range{0.01, 1},
           .scale = Scale::logarithmic,
           .label = {"Gradient", "勾配のしきい値"},
           .help = {"An element is cut where its corners differ by more than this share of the mean radiosity.",
                    "角どうしの差が平均ラジオシティのこの割合を超える要素を分ける。"}}),
    field(&Radiosity::form_factors, {.name = "form_factors",
                                     .symbol = "F_ij",
                                     .label = {"Form factors", "形態係数"},
                                     .help = {"The share of the light leaving patch i that falls on patch j.",
                                              "パッチ i を出た光のうちパッチ j に届く割合。"}}),
    field(&Radiosity::item_buffer, {.name = "item_buffer",
                                    .label = {"Hemicube drawn by", "ヘミキューブの描画"},
                                    .help = {"Who draws which patch each pixel of the hemicube sees.",
                                             "ヘミキューブの各画素に見えるパッチを誰が描くか。"}}),
    field(&Radiosity::resolution, {.name = "resolution",
                                   .symbol = "R",
                                   .unit = "px",
                                   .range = {16, 1024},
                                   .scale = Scale::logarithmic,
                                   .label = {"Hemicube resolution", "ヘミキューブの解像度"},
                                   .help = {"Pixels a side of the top face; even. The sides have half of it in height.",
                                            "上面の一辺の画素数（偶数）。側面の高さはその半分。"}}),
    field(&Radiosity::samples,
          {.name = "samples",
           .symbol = "S",
           .range = {1, 16},
           .label = {"Positions a side", "位置の数（一辺）"},
           .help = {"S × S hemicubes a patch. Accuracy comes from these, hardly from the resolution.",
                    "パッチごとに S × S 個のヘミキューブを置く。精度を決めるのは解像度よりこの数。"}}),
    field(&Radiosity::placement,
          {.name = "placement",
           .label = {"Placement", "位置の取り方"},
           .help = {"On a uniform grid the error falls as 1/S²; Gauss points reach the same with fewer positions.",
                    "等間隔では誤差は 1/S² で減る。ガウス点はより少ない位置で同じ精度になる。"}}),
    field(&Radiosity::rays, {.name = "rays",
                             .range = {1, 1e7},
                             .slider = Range{16, 65536},
                             .scale = Scale::logarithmic,
                             .label = {"Rays a patch", "パッチごとの光線数"},
                             .help = {"Of the Monte Carlo form factors; the error falls as one over the root of it.",
                                      "モンテカルロ法で使う。誤差は光線数の平方根に反比例する。"}}),
    field(
        &Radiosity::weight,
        {.name = "weight",
         .symbol = "ΔF",
         .label = {"A pixel counts", "画素の重み"},
         .help =
             {"ΔF at the pixel's centre, or integrated over the pixel. The others are broken on purpose: they keep the "
              "sum of a row near 1 and miss every factor.",
              "画素の中心での ΔF か、画素内で積分した ΔF。ほかの重みはわざと間違えたもので、"
              "行の和は 1 に近いのに係数は全部外れる。"}}),
    field(&Radiosity::normalise,
          {.name = "normalise",
           .label = {"Normalise rows", "行の和を 1 にする"},
           .help = {"In a closed scene each row of F sums to 1. A sum of 1 + δ multiplies the error to "
                    "ρδ/(1 − ρ − ρδ), and at ρ(1 + δ) ≥ 1 nothing converges. Where A_i F_ij = A_j F_ji holds too, no "
                    "light is lost between patches of different size.",
                    "閉じたシーンでは F の各行の和は 1。和が 1 + δ だと誤差は ρδ/(1 − ρ − ρδ) に増え、"
                    "ρ(1 + δ) ≥ 1 では収束しない。相反則 A_i F_ij = A_j F_ji も成り立たせると、"
                    "大きさの違うパッチの間で光が失われない。"}}),
    field(&Radiosity::solver, {.name = "solver",
                               .label = {"Solver", "解法"},
                               .help = {"How B = E + ρ F B is solved.", "B = E + ρ F B の解き方。"}}),
    field(&Radiosity::residual,
          {.name = "residual",
           .range = {1e-14, 1},
           .slider = Range{1e-10, 1e-1},
           .scale = Scale::logarithmic,
           .label = {"Residual", "残差"},
           .help = {"It stops where the residual over 1 − ρ_max is below this share of the brightest patch: then no B "
                    "is further off than that.",
                    "残差 ÷（1 − ρ の最大値）が B の最大値のこの割合を下回ると止まる。B の誤差はそれ以下になる。"}}),
    field(&Radiosity::memory, {.name = "memory",
                               .unit = "MiB",
                               .range = {1, 1e6},
                               .slider = Range{64, 16384},
                               .scale = Scale::logarithmic,
                               .label = {"Memory for form factors", "形態係数のメモリ"},
                               .help = {"Rows that do not fit are not kept but computed again.",
                                        "入りきらない行は保存せず、計算し直す。"}}),
};
static_assert(well_described<Radiosity>());

}  // namespace cg
