// Radiosity at its ends: reflectances, rows whose sums are off 1, rooms that are open or apart, patches that touch, lie
// on one another, are thin, tiny or alone. What is right is known in closed form.
// This work is based on: John Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-11 and C-14.
#include <cmath>

#include "measure/extreme_scenes.h"
#include "measure/extreme_tables.h"
#include "params/input_error.h"
#include "params/numbers.h"
#include "radiosity/hemicube.h"
#include "radiosity/solution.h"

namespace cg {

namespace {

const glm::dvec3 x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);

// An object of rectangles corner, corner + u, corner + u + v, corner + v, whose front is where u x v points.
struct Rectangle {
  glm::dvec3 corner, u, v;
};
Object object_of(const std::vector<Rectangle>& rectangles, double reflectance, double emission) {
  std::vector<glm::dvec3> positions;
  std::vector<std::vector<std::uint32_t>> polygons;
  for (const Rectangle& r : rectangles) {
    const auto first = std::uint32_t(positions.size());
    for (const glm::dvec3& p : {r.corner, r.corner + r.u, r.corner + r.u + r.v, r.corner + r.v}) positions.push_back(p);
    polygons.push_back({first, first + 1, first + 2, first + 3});
  }
  Object out;
  out.name = "walls";
  out.own_material = true;
  out.material.k_d = glm::dvec3(reflectance), out.material.emission = glm::dvec3(emission);
  out.mesh = mesh_of_faces(std::move(positions), polygons);
  return out;
}

// The six walls of a box, seen from inside.
std::vector<Rectangle> walls(const glm::dvec3& at, const glm::dvec3& size) {
  const glm::dvec3 x = size.x * x_axis, y = size.y * y_axis, z = size.z * z_axis;
  return {{at, z, x}, {at + y, x, z}, {at, x, y}, {at + z, y, x}, {at, y, z}, {at + x, z, y}};
}

Scene scene_of(std::vector<Object> objects, double patch_size) {
  Scene s;
  s.objects = std::move(objects);
  s.radiosity.patch_size = patch_size * (1 + 1e-9);
  s.radiosity.resolution = 64, s.radiosity.residual = 1e-10;
  return s;
}

// All walls emit 1 and reflect rho: B is 1/(1 - rho) everywhere, whatever the shape.
Scene furnace(double rho, const glm::dvec3& size = glm::dvec3(1), double patch_size = 0.5) {
  return scene_of({object_of(walls(glm::dvec3(0), size), rho, 1)}, patch_size);
}

using Right = std::function<double(const Patch&)>;

// The largest error of a patch's B, over the greatest B that is right.
ExtremeError light_error(const Scene& scene, const Right& right) {
  Progress progress;
  const SolutionHandle s = solve_radiosity(scene, scene.radiosity, nullptr, progress);
  ExtremeError out;
  double brightest = 0;
  for (const Patch& p : s->patches->patches) brightest = std::max(brightest, right(p));
  for (std::size_t i = 0; i < s->radiosity.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double b = s->radiosity[i][c], error = std::abs(b - right(s->patches->patches[i])) / brightest;
      if (!is_worse(error, out.error) && i + std::size_t(c) > 0) continue;
      const std::string n = std::to_string(i), value = number_text(b);
      out = {error, {"patch " + n + " has " + value, "パッチ " + n + " は " + value}};
    }
  return out;
}

struct Adding {
  ExtremeTable& all;
  void operator()(std::string id, Words name, std::string parameter, std::string value, Words right, double tolerance,
                  std::function<ExtremeError()> take) const {
    ExtremeCase c;
    c.id = "radiosity-" + std::move(id), c.group = "radiosity", c.name = name;
    c.parameter = std::move(parameter), c.value = std::move(value), c.right = right;
    c.tolerance = tolerance;
    c.input = ExtremeInput{c.parameter + " = " + c.value, std::move(take)};
    all.push_back(std::move(c));
  }
  void light(std::string id, Words name, std::string parameter, std::string value, Words right, double tolerance,
             std::function<Scene()> make, Right b) const {
    (*this)(std::move(id), name, std::move(parameter), std::move(value), right, tolerance,
            [=] { return light_error(make(), b); });
  }
};

Right everywhere(double b) {
  return [b](const Patch&) { return b; };
}

void add_reflectances(const Adding& add) {
  const Words name{"A closed room that emits everywhere", "どの面も光る閉じた部屋"};
  add.light(
      "rho-0", name, "material.k_d", "0", {"No light comes back: B = E.", "光は返らない。B = E。"}, 0,
      [] { return furnace(0); }, everywhere(1));
  for (const double rho : {0.5, 0.9, 0.99, 0.999})
    add.light(
        "furnace-" + number_text(rho), name, "material.k_d", number_text(rho),
        {"B = E/(1 − ρ) in a room of any shape.", "部屋の形によらず B = E/(1 − ρ)。"}, 1e-4,
        [rho] {
          return furnace(rho, {1, 2, 3}, 1);
        },
        everywhere(1 / (1 - rho)));
  add.light(
      "rho-to-1", name, "material.k_d", "1 − 1e-6",
      {"B = 1e6 E: rows sum to 1 to the last digits, or it would be lost.",
       "B = 1e6 E。行の和が末位まで 1 でなければ失われる。"},
      1e-4,
      [] {
        Scene s = furnace(1 - 1e-6);
        s.radiosity.solver = RadiositySolver::lu;
        return s;
      },
      everywhere(1e6));
  add("rho-1", name, "material.k_d", "1",
      {"No light is absorbed, so there is no solution: it says so and stops.",
       "光がまったく吸収されないので解がない。そう告げて止まる。"},
      0, []() -> ExtremeError {
        Progress progress;
        const Scene scene = furnace(1);
        const SolutionHandle s = solve_radiosity(scene, scene.radiosity, nullptr, progress);
        const bool told = s->figures.end == SolverEnd::diverges && !s->notes.empty();
        return {told ? 0.0 : 1.0, s->notes.empty() ? Text{} : s->notes.front()};
      });
  add("rho-over-1", name, "material.k_d", "1.5",
      {"An error that names the object and the range 0 to 1.", "物体と範囲 0〜1 を示すエラーになる。"}, 0,
      []() -> ExtremeError {
        try {
          light_error(furnace(1.5), everywhere(0));
        } catch (const InputError& e) {
          const Text said{e.message(Language::english), e.message(Language::japanese)};
          return {said.en.find("walls") != said.en.npos && said.en.find("0 to 1") != said.en.npos ? 0.0 : 1.0, said};
        }
        return {1, Words{"it was taken, without an error", "エラーにならず受け取られた"}};
      });
}

// Rows that are not normalised sum to 1 + delta, what the midpoints of the pixels come to.
Scene loose_furnace(double rho, int resolution) {
  Scene s = furnace(rho);
  s.radiosity.normalise = Normalise::none;
  s.radiosity.resolution = resolution, s.radiosity.samples = 1;
  return s;
}

void add_row_sums(const Adding& add) {
  const Words name{"Rows of a closed room that sum to 1 + δ", "和が 1 + δ になる閉じた部屋の行"};
  constexpr int resolution = 32;
  const double delta = PixelWeights(resolution, PixelWeight::delta_form_factor).sum() - 1;
  for (const double rho : {0.5, 0.9, 0.99})
    add.light(
        "row-sum-" + number_text(rho), name, "radiosity.normalise, material.k_d", "none, " + number_text(rho),
        {"E/(1 − ρ(1 + δ)): the error grows to ρδ/(1 − ρ − ρδ).",
         "E/(1 − ρ(1 + δ))。誤差は ρδ/(1 − ρ − ρδ) に増える。"},
        1e-5, [rho] { return loose_furnace(rho, resolution); }, everywhere(1 / (1 - rho * (1 + delta))));
  add("row-sum-diverges", name, "radiosity.normalise, material.k_d", "none, 0.9999",
      {"ρ(1 + δ) ≥ 1: light grows without end. It says so and stops.",
       "ρ(1 + δ) ≥ 1 なので光が際限なく増える。そう告げて止まる。"},
      0, []() -> ExtremeError {
        Progress progress;
        const Scene scene = loose_furnace(0.9999, resolution);
        const SolutionHandle s = solve_radiosity(scene, scene.radiosity, nullptr, progress);
        const bool told = s->figures.end == SolverEnd::diverges && !s->notes.empty();
        return {told ? 0.0 : 1.0, s->notes.empty() ? Text{} : s->notes.back()};
      });
}

// Opposite unit squares, 1 apart, the lower one a light, as one patch each.
Scene two_squares(double rho, double scale = 1) {
  Scene s = scene_of({object_of({{glm::dvec3(0), scale * z_axis, scale * x_axis}}, rho, 1),
                      object_of({{scale * y_axis, scale * x_axis, scale * z_axis}}, rho, 0)},
                     scale);
  s.radiosity.form_factors = FormFactors::closed_form;
  return s;
}
constexpr double opposite_squares = 0.199824895698;  // C-11, X = Y = 1

void add_rooms(const Adding& add) {
  for (const double rho : {0.5, 0.9}) {
    const double lit = 1 / (1 - rho * rho * opposite_squares * opposite_squares), dark = rho * opposite_squares * lit;
    for (const double scale : {1e-15, 1.0, 1e15})
      add.light(
          "open-" + number_text(rho) + "-" + number_text(scale),
          {"Two squares in the open, 1 apart, sums below 1", "開いた空間で向かい合う二つの正方形（行の和は 1 未満）"},
          "material.k_d, size", number_text(rho) + ", " + number_text(scale) + " m",
          {"B_1 = 1/(1 − ρ²F²) and B_2 = ρF B_1, F = 0.199825.", "B_1 = 1/(1 − ρ²F²)、B_2 = ρF B_1、F = 0.199825。"},
          1e-7, [=] { return two_squares(rho, scale); }, [=](const Patch& p) { return p.object == 0 ? lit : dark; });
  }
  add.light(
      "apart", {"Two rooms with nothing between them", "つながっていない二つの部屋"}, "objects", "2",
      {"E/(1 − ρ) in the one that emits, and exactly 0 in the other.",
       "光る部屋では E/(1 − ρ)、もう一方はちょうど 0。"},
      1e-6,
      [] {
        return scene_of({object_of(walls(glm::dvec3(0), glm::dvec3(1)), 0.5, 1),
                         object_of(walls({5, 0, 0}, glm::dvec3(1)), 0.5, 0)},
                        0.5);
      },
      [](const Patch& p) { return p.object == 0 ? 2.0 : 0.0; });
  add.light(
      "one", {"One patch alone", "一つだけのパッチ"}, "objects", "1",
      {"It sees nothing: B = E.", "何も見えないので B = E。"}, 0,
      [] {
        return scene_of({object_of({{glm::dvec3(0), z_axis, x_axis}}, 0.9, 1)}, 1);
      },
      everywhere(1));
  add("none", {"No patch at all", "パッチがないシーン"}, "objects", "0",
      {"An error that says so.", "そう告げるエラーになる。"}, 0, []() -> ExtremeError {
        try {
          light_error(scene_of({}, 1), everywhere(0));
        } catch (const InputError& e) {
          const Text said{e.message(Language::english), e.message(Language::japanese)};
          return {e.accepted.en.empty() ? 1.0 : 0.0, said};
        }
        return {1, Words{"it was taken, without an error", "エラーにならず受け取られた"}};
      });
}

// The factor from the first to the second object, one patch each, by hemicubes.
double factor_of(Scene scene, int resolution, int samples) {
  Progress progress;
  scene.radiosity.form_factors = FormFactors::hemicube;
  scene.radiosity.resolution = resolution, scene.radiosity.samples = samples;
  const SolutionHandle s = solve_radiosity(scene, scene.radiosity, nullptr, progress);
  return form_factor(*s, 0, 1, progress);
}

void add_patches(const Adding& add) {
  add("touching", {"Two patches with a common edge", "辺で接する二つのパッチ"}, "radiosity.form_factors", "hemicube",
      {"0.200044 (C-14): no near plane cuts off what touches.", "0.200044（C-14）。接している部分が切り落とされない。"},
      5e-4, []() -> ExtremeError {
        const Scene scene = scene_of(
            {object_of({{glm::dvec3(0), z_axis, x_axis}}, 0, 1), object_of({{glm::dvec3(0), x_axis, y_axis}}, 0, 0)},
            1);
        const double f = factor_of(scene, 64, 8);
        return {std::abs(f - 0.200043776075), {number_text(f), number_text(f)}};
      });
  add("coincident", {"Two patches face to face in one place", "同じ場所で向き合う二つのパッチ"},
      "radiosity.form_factors", "hemicube",
      {"All light of one meets the other: F = 1.", "一方の光はすべて他方に届く。F = 1。"}, 2e-4, []() -> ExtremeError {
        const Scene scene = scene_of(
            {object_of({{glm::dvec3(0), z_axis, x_axis}}, 0, 1), object_of({{glm::dvec3(0), x_axis, z_axis}}, 0, 0)},
            1);
        const double f = factor_of(scene, 64, 2);
        return {std::abs(f - 1), {number_text(f), number_text(f)}};
      });
  const Words furnace_right{"B = E/(1 − ρ) everywhere, the odd patches too.",
                            "特殊なパッチも含め、どこでも B = E/(1 − ρ)。"};
  add.light(
      "tiny", {"A patch of 1e-12 square metres in a corner of the floor", "床の隅にある 1e-12 m² のパッチ"},
      "patch area", "1e-12 m²", furnace_right, 1e-4,
      [] {
        constexpr double tiny = 1e-6, rest = 1 - tiny;
        std::vector<Rectangle> room = walls(glm::dvec3(0), glm::dvec3(1));
        room[0] = {glm::dvec3(0), tiny * z_axis, tiny * x_axis};
        room.push_back({tiny * x_axis, tiny * z_axis, rest * x_axis});
        room.push_back({tiny * z_axis, rest * z_axis, x_axis});
        return scene_of({object_of(room, 0.9, 1)}, 1);
      },
      everywhere(10));
  add.light(
      "thin", {"Strips a thousand times longer than wide", "幅の千倍の長さの帯"}, "patch size", "1e-3 m × 1 m",
      furnace_right, 1e-4,
      [] {
        return furnace(0.9, {1e-3, 1, 1}, 1);
      },
      everywhere(10));
}

}  // namespace

void add_radiosity_extremes(ExtremeTable& all) {
  const Adding add{all};
  add_reflectances(add);
  add_row_sums(add);
  add_rooms(add);
  add_patches(add);
}

}  // namespace cg
