// The list of extreme scenes (extreme_cases.cpp), drawn by every technique: the software in float and double, OpenGL's
// fixed function and GLSL, flat, Gouraud and Phong. Each picture is finite and is that of the double reference
// (tests/gl/gl_scenes.h) or of another, ordinary scene; where a technique cannot draw it so, its plan says it.
//
// What is extreme, and where it is asserted:
//   lights, cones, materials, surfaces, cameras,
//   pictures' sizes, NaN, in every technique       here
//   random states of everything                    extremes_test.cpp, storm_main.cpp, gl/lighting_oracle_test.cpp
//   the same in numbers: how thin, how near        software_extremes_test.cpp, gl/extremes_test.cpp
//   slivers, odd and concave faces                 scene/mesh_test.cpp, scene/connectivity_test.cpp
//   normals of any length                          shading/surface_test.cpp
//   the powers of thin highlights                  shading/light_model_test.cpp
//   NaN and too large numbers in files             scene/read_*_test.cpp, scene/bad_files_test.cpp
//   clipping at the eye                            raster/clip_test.cpp
//   cameras that a gesture can reach               workbench/camera_control_test.cpp
//   windows of size 0, time that stands still      ui/widgets_test.cpp
//   ranges, refusals, decimal commas               workbench/parameters_test.cpp
//   texts of numbers                               params/json_test.cpp
#include <gtest/gtest.h>

#include "params/slots.h"
#include "raster/software.h"
#include "tests/extremes/extreme_cases.h"
#include "tests/gl/gl_scenes.h"

namespace cg {
namespace {

constexpr double tolerance = 2.0 / 255;

// The techniques live as long as the program: each has a context of its own.
const Technique& technique(const std::string& id) {
  static const std::vector<Technique> all = [] {
    std::vector<Technique> list = gl_techniques();
    for (Technique& t : list) find_availability(t);
    list.push_back(software_technique());
    return list;
  }();
  return find(all, id);
}

// The largest difference of colour where both cover, and how many pixels only one covers.
std::pair<double, int> difference(const Frame& a, const Frame& b) {
  double largest = 0;
  int edge = 0;
  for (std::size_t i = 0; i < a.colour.size(); ++i) {
    edge += a.covered.pixels()[i] != b.covered.pixels()[i];
    if (!a.covered.pixels()[i] || !b.covered.pixels()[i]) continue;
    for (int c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(double(a.colour.pixels()[i][c]) - double(b.colour.pixels()[i][c])));
  }
  return {largest, edge};
}

struct Drawn {
  const char *name, *id;
  Precision precision;
};

class EveryTechnique : public testing::TestWithParam<Drawn> {
 protected:
  void SetUp() override {
    if (const auto& why = technique(GetParam().id).unavailable) GTEST_SKIP() << why->en;
  }
  const Technique& drawing() const { return technique(GetParam().id); }

  Scene scene_of(const Change& change, ShadingMode mode) const {
    Scene s = scene_with(sphere_mesh());
    s.material.n = 5, s.shading.mode = mode;
    change(s);
    s.shading.precision = GetParam().precision;
    return s;
  }

  void check(const ExtremeCase& c, ShadingMode mode) const {
    SCOPED_TRACE(c.name + ", " + std::string(names_of<ShadingMode>[std::size_t(mode)].id));
    const bool fixed = drawing().id == "gl-fixed";
    const View view = view_of(64, 64, true);
    Scene scene = scene_of(c.change, mode);
    if (const auto why = drawing().unsupported(scene)) {
      EXPECT_TRUE(fixed && mode == ShadingMode::phong) << why->en;
      return;
    }
    const Frame frame = draw(drawing(), scene, view);
    EXPECT_EQ(frame.nan_pixels, 0u);
    if (c.denormal && drawing().id == "gl") return;
    if (const Change& other = fixed ? c.fixed_same_as : c.same_as) {
      const auto [largest, edge] = difference(frame, draw(drawing(), scene_of(other, mode), view));
      EXPECT_LE(largest, 1.0 / 255);
      EXPECT_LE(edge, 3);
    } else {
      EXPECT_LT(against_reference(scene, frame).largest, tolerance);
      scene.shading.precision = Precision::double_precision;
      EXPECT_LE(difference(frame, draw(technique("software"), scene, view)).second, 3);
    }
    bool noted = false;
    const std::string& note = fixed ? c.fixed_note : c.note;
    for (const Text& said : drawing().plan(scene, view).notes) noted = noted || said.en.find(note) != said.en.npos;
    EXPECT_TRUE(noted || note.empty()) << note;
  }

  void check(const std::vector<ExtremeCase>& all) const {
    for (const ExtremeCase& c : all)
      for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
        if (c.flat || mode != ShadingMode::flat) check(c, mode);
  }
};

TEST_P(EveryTechnique, Lights) { check(extreme_lights()); }
TEST_P(EveryTechnique, Cones) { check(extreme_cones()); }
TEST_P(EveryTechnique, Materials) { check(extreme_materials()); }
TEST_P(EveryTechnique, Surfaces) { check(extreme_surfaces()); }
TEST_P(EveryTechnique, Cameras) { check(extreme_cameras()); }

TEST_P(EveryTechnique, NoLightIsTheAmbientTermAlone) {
  const Frame f = draw(drawing(), scene_of(unlit, ShadingMode::gouraud), view_of(16, 16));
  EXPECT_NEAR(f.colour.at(8, 8).r, 0.2 * 0.2, 1e-6);
}

TEST_P(EveryTechnique, TheEyeInsideSeesNothingElse) {
  const Scene scene = scene_of([](Scene& s) { s.camera.position = {0, 0, 0.1}; }, ShadingMode::gouraud);
  const Frame frame = draw(drawing(), scene, view_of(32, 32));
  for (const std::uint8_t covered : frame.covered.pixels()) ASSERT_TRUE(covered);
}

// Without the clamp a NaN is made black, and counted.
TEST_P(EveryTechnique, NanIsBlackAndCounted) {
  for (const ShadingMode mode : {ShadingMode::gouraud, ShadingMode::phong}) {
    const auto nan = [](Scene& s) { s.material.emission = glm::dvec3(std::nan("")), s.shading.clamp = false; };
    const Scene scene = scene_of(nan, mode);
    if (drawing().unsupported(scene)) continue;
    const Frame f = draw(drawing(), scene, view_of(32, 32));
    std::size_t covered = 0;
    for (const std::uint8_t c : f.covered.pixels()) covered += c;
    EXPECT_EQ(f.nan_pixels, covered);
    EXPECT_EQ(f.colour.at(16, 16), glm::vec3(0));
  }
}

TEST_P(EveryTechnique, PicturesOfAnySize) {
  const Scene scene = scene_of([](Scene&) {}, ShadingMode::gouraud);
  const Frame before = draw(drawing(), scene, view_of(40, 30));
  for (const auto& [w, h] : {std::pair(0, 0), {0, 5}, {5, 0}, {1, 1}, {64, 1}, {1, 64}}) {
    const Frame f = draw(drawing(), scene, view_of(w, h, true));
    EXPECT_EQ(f.colour.size(), std::size_t(w * h));
    EXPECT_EQ(f.nan_pixels, 0u);
  }
  try {
    draw(drawing(), scene, view_of(20000, 20000));
    ADD_FAILURE() << "a picture of 20000x20000 was drawn";
  } catch (const InputError& e) {
    for (const Language l : {Language::english, Language::japanese}) {
      EXPECT_NE(e.message(l).find("20000x20000"), std::string::npos);
      EXPECT_FALSE(e.accepted.in(l).empty());
    }
  }
  EXPECT_EQ(draw(drawing(), scene, view_of(40, 30)).colour, before.colour);
}

INSTANTIATE_TEST_SUITE_P(Techniques, EveryTechnique,
                         testing::Values(Drawn{"double", "software", Precision::double_precision},
                                         Drawn{"float", "software", Precision::single_precision},
                                         Drawn{"gl_fixed", "gl-fixed", Precision::double_precision},
                                         Drawn{"gl", "gl", Precision::double_precision}),
                         [](const auto& drawn) { return drawn.param.name; });

// What no technique is ever given: the description refuses it, and says what would work.
TEST(ExtremesRefused, ByTheDescription) {
  const std::pair<const char*, const char*> refused[] = {
      {"material.k_a", "-0.1"},    {"material.k_d", "1.001"},   {"material.k_s", "nan"},
      {"material.n", "-1"},        {"material.n", "1000001"},   {"lights.0.k_0", "-1"},
      {"lights.0.k_1", "-1e-9"},   {"lights.0.k_2", "-1"},      {"lights.0.cutoff", "90.001"},
      {"lights.0.cutoff", "120"},  {"lights.0.cutoff", "-1"},   {"lights.0.exponent", "129"},
      {"lights.0.exponent", "-1"}, {"lights.0.diffuse", "nan"}, {"lights.0.position", "inf"},
      {"camera.fov", "0"},         {"camera.fov", "180"},       {"camera.near", "0"},
      {"camera.far", "inf"},       {"camera.height", "0"},
  };
  Scene scene;
  const Slots all = slots(scene);
  for (const auto& [path, text] : refused) try {
      assign_text(find_slot(all, path), text);
      ADD_FAILURE() << path << " took " << text;
    } catch (const InputError& e) {
      EXPECT_FALSE(e.accepted.en.empty() || e.accepted.ja.empty()) << path;
    }
  EXPECT_EQ(scene, Scene{});
}

}  // namespace
}  // namespace cg
