// Attenuation 1/(k_0 + k_1 r + k_2 r^2) and the cones of spots, at their ends.
#include "measure/extreme_scenes.h"
#include "measure/extreme_tables.h"
#include "params/numbers.h"

namespace cg {

namespace {

Change attenuated(double k_0, double k_1, double k_2) {
  return [=](Scene& s) { s.lights[0].k_0 = k_0, s.lights[0].k_1 = k_1, s.lights[0].k_2 = k_2; };
}

Change spot(double cutoff, double exponent, double w = 1, glm::dvec3 axis = {-1, -1.1, -3}) {
  return [=](Scene& s) {
    s.lights[0].kind = LightKind::spot, s.lights[0].position = {1, 1, 3}, s.lights[0].direction = axis;
    s.lights[0].cutoff = cutoff, s.lights[0].exponent = exponent, s.lights[0].w = w;
  };
}

PictureRow row_of(std::string id, const char* group, Words name, std::string parameter, std::string value, Text right,
                  Change change, Change same) {
  PictureRow row{std::move(id), group, name, std::move(parameter), std::move(value), std::move(right)};
  row.change = std::move(change), row.same = std::move(same);
  return row;
}

void add_denormal(ExtremeTable& all) {
  PictureRow row =
      row_of("attenuation-denormal", "attenuation",
             {"Attenuation below float's least normal number", "float の最小の正規化数より小さい減衰"}, "lights.0.k_2",
             "4e-40, light 1e20 away", as_the_reference(), both(light_at({0, 0, 1e20}), attenuated(0, 0, 4e-40)), {});
  ExtremeCase c = picture_case(std::move(row));
  // GLSL 4.60, section 4.7.1: denormal numbers may be taken as 0. Then 0, 0, 0 is a division by zero, taken as 1.
  c.driver_fault = DriverFault{
      "gl",
      Words{
          "The driver takes numbers below 1.2e-38 as 0 (allowed by GLSL 4.60, section 4.7.1): no attenuation is left.",
          "ドライバが 1.2e-38 未満の数を 0 とみなす（GLSL 4.60 の 4.7.1 節で許される）ので、減衰がなくなる。"},
      same_as(sphere_scene, both(light_at({0, 0, 1e20}), attenuated(1, 0, 0)))};
  all.push_back(std::move(c));
}

}  // namespace

void add_attenuation_extremes(ExtremeTable& all) {
  const auto add = [&](std::string id, Words name, std::string parameter, std::string value, Text right, Change change,
                       Change same = {}, std::string note = {}) {
    PictureRow row = row_of("attenuation-" + std::move(id), "attenuation", name, std::move(parameter), std::move(value),
                            std::move(right), std::move(change), std::move(same));
    row.note = std::move(note);
    all.push_back(picture_case(std::move(row)));
  };
  const Words name{"Attenuation", "減衰"};
  add("0", name, "lights.0.k_0, k_1, k_2", "0, 0, 0",
      Words{"A division by zero: taken as 1, 0, 0, and the plan says so.",
            "ゼロ除算になるので 1, 0, 0 とみなし、処理計画がそう告げる。"},
      attenuated(0, 0, 0), attenuated(1, 0, 0), "attenuation 0, 0, 0");
  add("1e20", name, "lights.0.k_0, k_1, k_2", "1e20, 1e20, 1e20", as_without_light(), attenuated(1e20, 1e20, 1e20),
      unlit);
  add("1e-20", name, "lights.0.k_0", "1e-20",
      Words{"1e20 times as bright: each lit pixel is 1 where it is clamped.",
            "1e20 倍明るい。制限すると照らされた画素は 1。"},
      attenuated(1e-20, 0, 0));
  add("quadratic-far", {"k_2 = 1, the light 1e20 away", "k_2 = 1、光源は 1e20 先"}, "lights.0.k_2", "1",
      Words{"r² = 1e40 leaves float; the limit is darkness.", "r² = 1e40 は float を超えるが、極限は真っ暗。"},
      both(light_at({0, 0, 1e20}), attenuated(1, 0, 1)), unlit);
  add("none-far", {"k_1 = k_2 = 0, the light 1e30 away", "k_1 = k_2 = 0、光源は 1e30 先"}, "lights.0.position", "1e30",
      Words{"0 r² is 0, also where r² overflows: as a directional light.",
            "r² があふれても 0 r² は 0。平行光源と同じ。"},
      light_at({0, 0, 1e30}), light_at({0, 0, 1}, 1, LightKind::directional));
  add("least-normal", {"Attenuation of float's least normal numbers", "float の最小の正規化数の減衰"}, "lights.0.k_2",
      "4e-38, light 1e20 away", as_the_reference(), both(light_at({0, 0, 1e20}), attenuated(0, 0, 4e-38)));
  add("far-and-dark", {"k_2 = 1e-36, the light 1e18 away", "k_2 = 1e-36、光源は 1e18 先"}, "lights.0.k_2", "1e-36",
      Words{"1e-36 (1e18)² = 1: as a directional light.", "1e-36 (1e18)² = 1 なので平行光源と同じ。"},
      both(light_at({0, 0, 1e18}), attenuated(0, 0, 1e-36)), light_at({0, 0, 1}, 1, LightKind::directional));
  add_denormal(all);
}

void add_spot_extremes(ExtremeTable& all) {
  const auto add = [&](std::string id, Words name, std::string parameter, std::string value, Text right, Change change,
                       Change same = {}) {
    all.push_back(picture_case(row_of("spot-" + std::move(id), "spots", name, std::move(parameter), std::move(value),
                                      std::move(right), std::move(change), std::move(same))));
  };
  const Words cutoff_name{"A spot's cut-off", "スポットの広がり"},
      parallel{"A directional light with a cone", "円錐を持つ平行光源"};
  const Text dark = Words{"Out of the cone: as without the light.", "円錐の外なので、光源がないのと同じ。"};
  for (const double cutoff : {1e-3, 1.0, 90.0})
    for (const double exponent : {0.0, 1.0, 128.0})
      add(number_text(cutoff) + "-" + number_text(exponent), cutoff_name, "lights.0.cutoff, exponent",
          number_text(cutoff) + "°, " + number_text(exponent), as_the_reference(), spot(cutoff, exponent));
  add("0", cutoff_name, "lights.0.cutoff", "0°",
      Words{"Only the axis itself is lit, and no vertex or pixel's centre lies on it.",
            "軸そのものだけを照らす。軸の上には頂点も画素の中心もない。"},
      spot(0, 0), unlit);
  const Text no_cone =
      Words{"No cone: as a point light, whatever the exponent.", "円錐なし。指数によらず点光源と同じ。"};
  add("180", cutoff_name, "lights.0.cutoff", "180°", no_cone, spot(180, 0), light_at({1, 1, 3}));
  add("180-128", cutoff_name, "lights.0.cutoff, exponent", "180°, 128", no_cone, spot(180, 128), light_at({1, 1, 3}));
  add("no-axis", {"A spot whose axis has no length", "軸の長さが 0 のスポット"}, "lights.0.direction", "0, 0, 0",
      Words{"A cone about no axis is dark: as without the light.",
            "軸のない円錐は何も照らさない。光源がないのと同じ。"},
      spot(90, 0, 1, {0, 0, 0}), unlit);
  for (const double length : {1e-30, 1e30})
    add("axis-" + number_text(length), {"A spot's axis of extreme length", "極端な長さのスポットの軸"},
        "lights.0.direction", number_text(length), Words{"Only its direction counts.", "向きだけが意味を持つ。"},
        spot(30, 8, 1, glm::dvec3(-1, -1.1, -3) * (length / 3.35)), spot(30, 8));
  add("parallel-in", parallel, "lights.0.w", "0, 30°",
      Words{"In the cone: as the directional light.", "円錐の中なので平行光源と同じ。"}, spot(30, 0, 0),
      light_at({1, 1, 3}, 1, LightKind::directional));
  add("parallel-exponent", parallel, "lights.0.w, exponent", "0, 128", as_the_reference(), spot(30, 128, 0));
  add("parallel-out", parallel, "lights.0.w", "0, 30°", dark, spot(30, 0, 0, {1, 0, 0}), unlit);
  add("parallel-behind", parallel, "lights.0.w, cutoff", "0, 90°", dark, spot(90, 0, 0, {1, 1, 3}), unlit);
}

}  // namespace cg
