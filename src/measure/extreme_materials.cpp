// Reflectances and the exponent at their ends, in closed form: a face under a directional light has one colour.
#include <cmath>

#include "measure/extreme_scenes.h"
#include "measure/extreme_tables.h"
#include "params/numbers.h"

namespace cg {

namespace {

// Where cos^n is one half: the exponent's own angle, so that no n is too large to see.
double half_maximum(double n) { return std::acos(std::pow(0.5, 1 / n)); }

PictureRow material_row(std::string id, Words name, std::string parameter, std::string value, Text right, double theta,
                        Change change) {
  PictureRow row{"material-" + std::move(id), "materials",      name,
                 std::move(parameter),        std::move(value), std::move(right)};
  row.start = [theta] { return even_square(theta); };
  row.change = std::move(change);
  row.check = colour_is([theta](const Scene& s) { return even_colour(s, theta); });
  row.tolerance = 5e-5;
  return row;
}

Change exponent(double n) {
  return [n](Scene& s) { s.material.n = n; };
}

void add_exponents(ExtremeTable& all) {
  const Words name{"Shininess", "鏡面反射の鋭さ"};
  PictureRow zero = material_row(
      "n-0", name, "material.n", "0",
      Words{"(N·H)^0 = 1: k_s everywhere that N·L > 0.", "(N·H)^0 = 1。N·L > 0 なら一面に k_s。"}, 1.2, exponent(0));
  all.push_back(picture_case(std::move(zero)));
  for (const double n : {1e-9, 1.0, 128.0, 129.0, 1e3, 1e4, 1e6}) {
    const std::string value = number_text(n);
    const double theta = n <= 1 ? 1.2 : 2 * half_maximum(n);
    PictureRow row = material_row(
        "n-" + value, name, "material.n", value,
        n <= 1 ? Text(Words{"cos(θ/2)^n, where θ is the angle of N and L.", "N と L の角を θ として cos(θ/2)^n。"})
        : n > 128 ? Text(Words{"N·H is 2^(-1/n), so that the highlight is k_s/2; the fixed function ends at n = 128.",
                               "N·H = 2^(-1/n) なのでハイライトは k_s/2。固定機能は n = 128 まで。"})
                  : Text(Words{"N·H is 2^(-1/n), so that the highlight is k_s/2.",
                               "N·H = 2^(-1/n) なのでハイライトは k_s/2。"}),
        theta, exponent(n));
    if (n > 128) {
      row.check = by_technique(colour_is([theta](const Scene& s) {
                                 Scene limited = s;
                                 limited.material.n = 128;
                                 return even_colour(limited, theta);
                               }),
                               row.check);
      row.fixed_note = "ends at 128";
    }
    all.push_back(picture_case(std::move(row)));
  }
  for (const double n : {0.0, 1e6}) {  // R.V: the angle itself, not its half
    const double theta = n == 0 ? 1.2 : half_maximum(n);
    PictureRow row =
        material_row("reflection-n-" + number_text(n), {"Shininess, with (R·V)^n", "鏡面反射の鋭さ（R·V）"},
                     "material.n", number_text(n),
                     n == 0 ? Text(Words{"(R·V)^0 = 1.", "(R·V)^0 = 1。"})
                            : Text(Words{"R·V is 2^(-1/n), so that the highlight is k_s/2.",
                                         "R·V = 2^(-1/n) なのでハイライトは k_s/2。"}),
                     theta, [n](Scene& s) { s.material.n = n, s.shading.reflection = Reflection::reflection_vector; });
    row.check = colour_is([theta, n](const Scene& s) {
      Scene diffuse = s;
      diffuse.material.k_s = glm::dvec3(0);
      return even_colour(diffuse, theta) + s.material.k_s * (n == 0 ? 1.0 : 0.5);
    });
    all.push_back(picture_case(std::move(row)));
  }
}

// On the sphere, where the highlight's shape is seen too.
void add_highlights(ExtremeTable& all) {
  for (const double n : {0.0, 129.0, 1e6}) {
    PictureRow row{"material-sphere-n-" + number_text(n),
                   "materials",
                   {"The highlight on a sphere", "球の上のハイライト"},
                   "material.n",
                   number_text(n),
                   as_the_reference()};
    row.change = exponent(n);
    if (n > 128) row.fixed_same = exponent(128);
    all.push_back(picture_case(std::move(row)));
  }
  PictureRow attenuated{"material-n-0-attenuated",
                        "materials",
                        {"n = 0 under an attenuated light", "減衰する光源と n = 0"},
                        "material.n",
                        "0, k_1 = 0.5",
                        Words{"(N·H)^0 = 1, attenuated like the rest.", "(N·H)^0 = 1 で、他の項と同じく減衰する。"}};
  attenuated.change = both(exponent(0), [](Scene& s) { s.lights[0].k_1 = 0.5, s.lights[0].position = {2, 2, 3}; });
  attenuated.fixed_note = "n = 0";
  // Mesa's ffvertex_prog.c would give (N.L)^(N.L) for an exponent of 0 there: it is sent as 1e-6.
  all.push_back(picture_case(std::move(attenuated)));
}

void add_reflectances(ExtremeTable& all) {
  for (const double k : {0.0, 0.999, 1.0}) {
    all.push_back(picture_case(material_row(
        "k-" + number_text(k), {"All reflectances at once", "すべての反射率"}, "material.k_a, k_d, k_s", number_text(k),
        k > 0 ? Text(Words{"k_d + k_s > 1 is allowed here: the sum, limited to 1 at the end.",
                           "k_d + k_s > 1 でもよい。和を最後に 1 に制限する。"})
              : Text(Words{"Black.", "黒。"}),
        0.5, [k](Scene& s) {
          s.material.k_a = s.material.k_d = s.material.k_s = glm::dvec3(k), s.shading.ambient = {1, 0.5, 0};
        })));
  }
  all.push_back(picture_case(material_row("emission-1e6", {"Emission", "自己発光"}, "material.emission", "1e6",
                                          Words{"The sum as it is; clamped, 1.", "和のまま。制限すると 1。"}, 0.5,
                                          [](Scene& s) { s.material.emission = glm::dvec3(1e6); })));
  PictureRow ambient = material_row(
      "ambient-nan", {"Ambient light that is NaN", "NaN の環境光"}, "shading.ambient", "0.2, nan, 0.2",
      Words{"NaN becomes 0 in that channel, never white.", "NaN はその成分だけ 0 になり、白にはならない。"}, 0.5,
      [](Scene& s) { s.shading.ambient.g = std::nan(""), unlit(s); });
  ambient.check = colour_is([](const Scene& s) {
    glm::dvec3 c = s.shading.ambient * s.material.k_a;
    c.g = 0;
    return c;
  });
  ambient.variants = {{ShadingMode::flat}, {ShadingMode::gouraud}, {ShadingMode::phong}};
  all.push_back(picture_case(std::move(ambient)));
}

// Not clamped, a NaN is black, and each of its pixels is counted.
void add_counted_nan(ExtremeTable& all) {
  PictureRow row = material_row("emission-nan", {"Emission that is NaN", "NaN の自己発光"}, "material.emission", "nan",
                                Words{"Black, and every such pixel is counted where nothing clamps it away.",
                                      "黒になる。制限しないときは、その画素がすべて数えられる。"},
                                0.5, [](Scene& s) { s.material.emission = glm::dvec3(std::nan("")); });
  row.check = both_checks(colour_is([](const Scene&) { return glm::dvec3(0); }), [](const ExtremePicture& p) {
    std::size_t covered = 0;
    for (const std::uint8_t c : p.frame.covered.pixels()) covered += c;
    const std::size_t right = p.variant.clamp ? 0 : covered, counted = p.frame.nan_pixels;
    const std::string n = std::to_string(counted);
    return ExtremeError{counted == right ? 0.0 : 1.0, {n + " pixels counted", n + " 画素を数えた"}};
  });
  ExtremeCase c = picture_case(std::move(row));
  c.scene->counts_nan = true;
  all.push_back(std::move(c));
}

}  // namespace

void add_material_extremes(ExtremeTable& all) {
  add_exponents(all);
  add_highlights(all);
  add_reflectances(all);
  add_counted_nan(all);
}

}  // namespace cg
