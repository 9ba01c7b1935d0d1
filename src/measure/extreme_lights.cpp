// Lights at the ends of place, w, number and intensity.
#include <cmath>

#include "measure/extreme_scenes.h"
#include "measure/extreme_tables.h"
#include "params/numbers.h"

namespace cg {

namespace {

constexpr double tilt = 0.5;  // radians between N and L where a closed form is compared

// A light with some ambient colour of its own, which no surface turns away from.
void ambient(Scene& s) { s.lights[0].ambient = {0.6, 0.4, 0.2}, s.lights[0].k_1 = 0.5; }

// Two pages that stand at a right angle, open to the light; the light in a corner of the left.
void light_at_a_vertex(Scene& s) {
  mesh_change(mesh_of_faces({{-1, -1, 1}, {0, -1, 0}, {1, -1, 1}, {-1, 1, 1}, {0, 1, 0}, {1, 1, 1}},
                            {{0, 1, 4, 3}, {1, 2, 5, 4}}))(s);
  s.camera.position = {0, 0, 4};
  s.lights[0].position = {-1, 1, 1};
}

// N.L in closed form; V = (0, 0, 1) plays no part where the light is not in front.
Change direction(double x, double z) { return light_at({x, 0, z}, 1, LightKind::directional); }

PictureRow even_row(std::string id, Text name, std::string parameter, std::string value, Text right, Change change,
                    std::function<glm::dvec3(const Scene&)> colour) {
  PictureRow row;
  row.id = std::move(id), row.group = "lights", row.name = std::move(name);
  row.parameter = std::move(parameter), row.value = std::move(value), row.right = std::move(right);
  row.start = [] { return even_square(tilt); };
  row.change = std::move(change);
  row.check = colour_is(std::move(colour));
  row.tolerance = 5e-5;
  return row;
}

glm::dvec3 ambient_term(const Scene& s) { return s.shading.ambient * s.material.k_a; }

void add_grazing(ExtremeTable& all) {
  for (const double z : {0.0, -0.0, -1e-8, 1e-8}) {
    const std::string text = number_text(z);
    const bool front = z > 0;
    all.push_back(picture_case(
        even_row("light-grazing-" + text, {"A light that grazes the face", "面をかすめる光"}, "lights.0.position",
                 "1, 0, " + text,
                 front ? Text(Words{"I_a k_a + k_d (N·L) + k_s (N·H)^n: nearly nothing of the first, and no leap.",
                                    "I_a k_a + k_d (N·L) + k_s (N·H)^n。拡散項はほぼ 0 で、急な変化はない。"})
                       : Text(Words{"N·L ≤ 0: I_a k_a alone, no diffuse light and no highlight.",
                                    "N·L ≤ 0 なので I_a k_a だけ。拡散光もハイライトもない。"}),
                 direction(1, z), [z](const Scene& s) {
                   if (!(z > 0)) return ambient_term(s);
                   return even_colour(s, std::atan2(1, z));
                 })));
  }
}

void add_places(ExtremeTable& all) {
  const auto add = [&](std::string id, Text name, std::string value, Change change, std::function<Scene()> start) {
    PictureRow row{"light-" + id, "lights", std::move(name), "lights.0.position", std::move(value), as_the_reference()};
    row.start = std::move(start), row.change = std::move(change);
    all.push_back(picture_case(std::move(row)));
  };
  add("in-the-plane", {"A light in the surface's plane, outside it", "面と同じ平面にある光源"}, "3, 0, 0",
      both(ambient, light_at({3, 0, 0})), square_scene);
  add("in-the-surface", {"A light in the surface itself", "面の中にある光源"}, "0.3, 0.2, 0",
      both(ambient, light_at({0.3, 0.2, 0})), square_scene);
  add("behind", {"A light behind the surface", "面の裏にある光源"}, "0, 0, -3", both(ambient, light_at({0, 0, -3})),
      square_scene);
  add("inside", {"A light inside the sphere", "球の中にある光源"}, "0, 0, 0", light_at({0, 0, 0}), sphere_scene);
  add("at-a-vertex", {"A light at a vertex: r = 0", "頂点にある光源（r = 0）"}, "-1, 1, 1", light_at_a_vertex,
      sphere_scene);
  add(
      "at-the-eye", {"A light at the eye", "視点にある光源"}, "camera.position",
      [](Scene& s) { s.lights[0].position = s.camera.position; }, sphere_scene);
  add("near-the-origin", {"A light 1e-20 from the middle", "中心から 1e-20 の光源"}, "1e-20, 2e-20, 3e-20",
      light_at({1e-20, 2e-20, 3e-20}), sphere_scene);
  for (const double d : {1e10, 1e18, 1e20, 1e30}) {
    PictureRow row{"light-" + number_text(d) + "-away",
                   "lights",
                   {"A light far away", "非常に遠い光源"},
                   "lights.0.position",
                   number_text(d),
                   as_directional()};
    row.change = light_at(glm::dvec3(0.6, 0.3, 0.5) * d);
    row.same = light_at({0.6, 0.3, 0.5}, 1, LightKind::directional);
    all.push_back(picture_case(std::move(row)));
  }
}

void add_w(ExtremeTable& all) {
  const auto add = [&](std::string id, const std::string& w, Change change, Change same, Text right, std::string note) {
    PictureRow row{"light-w-" + id, "lights", {"The light's w", "光源の同次座標 w"}, "lights.0.w", w, std::move(right)};
    row.change = std::move(change), row.same = std::move(same), row.note = std::move(note);
    all.push_back(picture_case(std::move(row)));
  };
  const Change directional = light_at({1, 2, 3}, 1, LightKind::directional);
  add("0", "0", light_at({1, 2, 3}, 0), directional, as_directional(), "");
  for (const double w : {1e-30, 1e-7})
    add(number_text(w), number_text(w), light_at({1, 2, 3}, w), directional,
        Words{"Too near 0 to divide by: as a directional light, and the plan says so.",
              "割れないほど 0 に近いので平行光源とみなし、処理計画がそう告げる。"},
        "w next to 0");
  add("-1", "-1", light_at({1, 2, 3}, -1), light_at({-1, -2, -3}),
      Words{"position/w: the light stands at the mirrored point.", "position/w なので、点対称な位置に立つ。"}, "");
  add("1e20", "1e20", light_at({1, 2, 3}, 1e20), light_at({1e-20, 2e-20, 3e-20}),
      Words{"position/w: next to the origin.", "position/w なので原点のすぐそばに立つ。"}, "");
  add("0-at-0", "0, position 0", light_at({0, 0, 0}, 0), unlit,
      Words{"A direction of length 0 is none: as without the light.", "長さ 0 の方向はないので、光源がないのと同じ。"},
      "");
  add("0-spot", "0, spot", light_at({1, 2, 3}, 0, LightKind::spot), directional,
      Words{"A directional light's cone is all or nothing: here all of the sphere.",
            "平行光源の円錐は全体に当たるか当たらないか。ここでは全体。"},
      "");
}

void add_numbers(ExtremeTable& all) {
  all.push_back(picture_case(
      even_row("lights-none", {"No light", "光源なし"}, "lights", "0", as_without_light(), unlit, ambient_term)));
  all.push_back(picture_case(even_row(
      "lights-off", {"All lights switched off", "すべて消灯"}, "lights.0.enabled", "false", as_without_light(),
      [](Scene& s) { s.lights[0].enabled = false; }, ambient_term)));
  for (const int n : {8, 9, 64}) {
    const std::string count = std::to_string(n);
    PictureRow row =
        even_row("lights-" + count, {count + " lights", "光源 " + count + " 個"}, "lights", count,
                 n <= 8 ? Text(Words{"The sum of all eight.", "8 個すべての和。"})
                        : Text(Words{"The sum of all; the fixed function's first eight, and its plan says so.",
                                     "すべての和。固定機能は最初の 8 個だけで、処理計画がそう告げる。"}),
                 [n](Scene& s) {
                   s.lights[0].diffuse = s.lights[0].specular = {0.01, 0.02, 0.03};
                   s.lights.resize(std::size_t(n), s.lights[0]);
                 },
                 {});
    const auto of = [](int lights) {
      return [lights](const Scene& s) {
        return ambient_term(s) + (even_colour(s, tilt) - ambient_term(s)) * double(lights);
      };
    };
    row.check = by_technique(colour_is(of(std::min(n, 8))), colour_is(of(n)));
    if (n > 8) row.fixed_note = "the first 8 of " + count;
    all.push_back(picture_case(std::move(row)));
  }
}

void add_intensities(ExtremeTable& all) {
  const auto add = [&](std::string id, std::string value, Text right, glm::dvec3 diffuse) {
    all.push_back(picture_case(even_row(
        "light-" + id, {"The light's intensity", "光源の強さ"}, "lights.0.diffuse", std::move(value), std::move(right),
        [diffuse](Scene& s) { s.lights[0].diffuse = diffuse; }, [](const Scene& s) { return even_colour(s, tilt); })));
  };
  add("of-1e20", "1e20", Words{"The sum as it is; clamped, 1.", "和のまま。制限すると 1。"}, glm::dvec3(1e20));
  add("of-1e-40", "1e-40",
      Words{"As without diffuse light, to float's precision.", "float の精度では拡散光がないのと同じ。"},
      glm::dvec3(1e-40));
  add("negative", "-0.5, -1e20, 0.5",
      Words{"It darkens: the terms are added as they are; clamped, not below 0.",
            "負の光は暗くする。項はそのまま足し、制限すると 0 より下がらない。"},
      {-0.5, -1e20, 0.5});
  for (const bool nan : {true, false}) {
    PictureRow row = even_row(
        nan ? "light-nan" : "light-infinite", {"The light's intensity", "光源の強さ"},
        nan ? "lights.0.diffuse" : "lights.0.specular", nan ? "nan" : "inf",
        Words{"Such a light is left out: as without it, never white.",
              "そのような光源は除く。ないのと同じで、白くはならない。"},
        [nan](Scene& s) { (nan ? s.lights[0].diffuse.g : s.lights[0].specular.g) = nan ? std::nan("") : HUGE_VAL; },
        ambient_term);
    all.push_back(picture_case(std::move(row)));
  }
  PictureRow place = even_row(
      "light-nan-place", {"A light whose position is NaN", "位置が NaN の光源"}, "lights.0.position", "nan",
      as_without_light(), [](Scene& s) { s.lights[0].position.g = std::nan(""); }, ambient_term);
  all.push_back(picture_case(std::move(place)));
}

}  // namespace

void add_light_extremes(ExtremeTable& all) {
  add_grazing(all);
  add_places(all);
  add_w(all);
  add_numbers(all);
  add_intensities(all);
}

}  // namespace cg
