// What the two OpenGL techniques draw, against the light model in double at the pixels of their own triangles.
#include <gtest/gtest.h>

#include <thread>

#include "gl_scenes.h"

namespace cg {
namespace {

// Vertices are snapped to 1/256 pixel, so a pixel's weights differ by as much: at most this much colour on scenes
// whose colours change slowly.
constexpr double tolerance = 2.0 / 255;

struct Case {
  const char* name;
  std::function<void(Scene&)> change;
};

std::vector<Case> cases() {
  return {
      {"default", [](Scene&) {}},
      {"directional", [](Scene& s) { s.lights[0].kind = LightKind::directional; }},
      {"w", [](Scene& s) { s.lights[0].w = 2.5; }},
      {"negative w", [](Scene& s) { s.lights[0].w = -5; }},
      {"attenuation",
       [](Scene& s) {
         s.lights[0].k_1 = 0.1, s.lights[0].k_2 = 0.01, s.lights[0].position = {2, 2, 2};
       }},
      {"spot",
       [](Scene& s) {
         s.lights[0].kind = LightKind::spot, s.lights[0].cutoff = 60, s.lights[0].exponent = 3;
         s.lights[0].position = {2, 2, 3}, s.lights[0].direction = {-2, -2, -3};
       }},
      {"local viewer", [](Scene& s) { s.shading.local_viewer = true; }},
      {"no clamp",
       [](Scene& s) {
         s.shading.clamp = false, s.material.emission = {0.5, 0.1, 0};
       }},
      {"three lights",
       [](Scene& s) {
         s.lights.push_back({.kind = LightKind::directional, .position = {-1, 0, 1}, .diffuse = {0.5, 0, 0}});
         s.lights.push_back({.position = {0, -3, 3}, .ambient = {0.1, 0.1, 0}, .diffuse = {0, 0, 0.5}});
       }},
      {"scaled, normals as they come",
       [](Scene& s) {
         s.shading.normal_length = NormalLength::off;
         s.objects[0].transform.scale = {0.7, 0.7, 0.7};
       }},
      {"scaled, rescaled normals",
       [](Scene& s) {
         s.shading.normal_length = NormalLength::rescale;
         s.objects[0].transform.scale = {0.7, 0.7, 0.7};
       }},
      {"stretched and turned",
       [](Scene& s) {
         s.objects[0].transform.scale = {0.4, 1.1, 0.7};
         s.objects[0].transform.rotate = {20, 30, 40};
         s.objects[0].transform.translate = {0.1, 0.2, -0.3};
       }},
      {"mirrored",
       [](Scene& s) {
         s.objects[0].transform.scale = {-1, 1, 1};
       }},
      {"mirrored, two sides",
       [](Scene& s) {
         s.objects[0].transform.scale = {-1, 1, 1}, s.shading.two_sided = true;
       }},
      {"colour material",
       [](Scene& s) {
         s.shading.color_material = ColorMaterial::ambient_and_diffuse;
         s.material.color = {0.2, 0.6, 0.3};
       }},
      {"orthographic", [](Scene& s) { s.camera.projection = Projection::orthographic; }},
  };
}

class Techniques : public testing::TestWithParam<const char*> {
 protected:
  const std::vector<Technique> all_ = gl_techniques();
  const Technique& technique() const { return find(all_, GetParam()); }
};

TEST_P(Techniques, DrawTheLightModel) {
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
    for (const Case& c : cases()) {
      Scene scene = scene_with(sphere_mesh());
      scene.material.n = 8;
      scene.shading.mode = mode;
      c.change(scene);
      if (technique().unsupported(scene)) continue;
      const Frame frame = draw(technique(), scene, view_of(96, 96, true));
      const ReferenceError e = against_reference(scene, frame);
      EXPECT_GT(e.pixels, 100) << c.name;
      EXPECT_LT(e.largest, tolerance) << c.name << ", mode " << int(mode);
      EXPECT_EQ(frame.nan_pixels, 0u) << c.name;
    }
}

TEST_P(Techniques, BothSidesOfASquare) {
  for (const bool two : {false, true}) {
    Scene scene = scene_with(square_mesh());
    scene.camera.position = {0.5, 0.4, -3};
    scene.lights[0].position = {1, 2, -5};
    scene.shading.two_sided = two;
    const Frame frame = draw(technique(), scene, view_of(64, 64, true));
    EXPECT_LT(against_reference(scene, frame).largest, 1e-3);
    EXPECT_EQ(frame.colour.at(32, 32).r > 0.5f, two);
  }
}

TEST_P(Techniques, LayersAgree) {
  Scene scene = scene_with(sphere_mesh());
  scene.objects.push_back(scene.objects[0]);
  scene.objects[1].mesh = square_mesh();
  scene.objects[1].transform.translate = {0, 0, 0.5};
  scene.display.background = {0.25, -1, 3};
  const Frame frame = draw(technique(), scene, view_of(80, 60, true));
  int seen[2] = {0, 0};
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x) {
      const bool covered = frame.covered.at(x, y);
      ASSERT_EQ(covered, frame.depth.at(x, y) < 1);
      ASSERT_EQ(covered, frame.object.at(x, y) != nothing);
      ASSERT_EQ(covered, frame.triangle.at(x, y) != nothing);
      ASSERT_EQ(covered, frame.normal.at(x, y) != glm::vec3(0));
      if (covered)
        ++seen[frame.object.at(x, y)];
      else
        ASSERT_EQ(frame.colour.at(x, y), glm::vec3(0.25f, -1, 3));
      if (covered && frame.object.at(x, y) == 1) {
        ASSERT_NEAR(frame.normal.at(x, y).z, 1, 1e-6);
      }
    }
  EXPECT_GT(seen[0], 50);
  EXPECT_GT(seen[1], 50);
}

TEST_P(Techniques, TheTopRowIsRowZero) {
  Scene scene = scene_with(square_mesh());
  scene.objects[0].transform.translate = {0, 1, 0};
  scene.camera.position = {0, 0, 5};
  const Frame frame = draw(technique(), scene, view_of(32, 32));
  EXPECT_TRUE(frame.covered.at(16, 12));
  EXPECT_FALSE(frame.covered.at(16, 20));
}

TEST_P(Techniques, RepeatsToTheBitWhateverCameBetween) {
  Scene scene = scene_with(sphere_mesh());
  const Frame first = draw(technique(), scene, view_of(64, 64, true));
  for (const Case& c : cases()) {
    Scene other = scene_with(square_mesh());
    c.change(other);
    draw(technique(), other, view_of(33, 17, true));
    draw(technique(), other, view_of(64, 64));
  }
  const Frame again = draw(technique(), scene, view_of(64, 64, true));
  EXPECT_EQ(first.colour, again.colour);
  EXPECT_EQ(first.depth, again.depth);
  EXPECT_EQ(first.triangle, again.triangle);
  EXPECT_EQ(first.normal, again.normal);
}

TEST_P(Techniques, CancelledWorkEnds) {
  const Scene scene = scene_with(sphere_mesh());
  const View view = view_of(32, 32);
  Progress progress;
  progress.cancelled = true;
  EXPECT_THROW(technique().render(scene, technique().plan(scene, view), view, progress), Cancelled);
  EXPECT_FALSE(draw(technique(), scene, view).colour.empty());
}

TEST_P(Techniques, SizesAtTheEdges) {
  const Scene scene = scene_with(sphere_mesh());
  EXPECT_TRUE(draw(technique(), scene, view_of(0, 0)).colour.empty());
  EXPECT_TRUE(draw(technique(), scene, view_of(0, 5, true)).colour.empty());
  EXPECT_EQ(draw(technique(), scene, view_of(1, 1, true)).colour.size(), 1u);
  EXPECT_THROW(draw(technique(), scene, view_of(20000, 20000)), InputError);
  EXPECT_THROW(draw(technique(), scene, view_of(1000000, 1)), InputError);
  EXPECT_EQ(draw(technique(), scene, view_of(40, 30)).colour.size(), 1200u);
}

TEST_P(Techniques, NothingToDraw) {
  Scene scene = scene_with(nullptr);
  scene.display.background = {0.5, 0.5, 0.5};
  const Frame frame = draw(technique(), scene, view_of(8, 8, true));
  EXPECT_EQ(frame.colour.at(3, 3), glm::vec3(0.5f));
  EXPECT_EQ(frame.object.at(3, 3), nothing);
  EXPECT_TRUE(draw(technique(), Scene{}, view_of(8, 8)).covered == Image<std::uint8_t>(8, 8));
}

INSTANTIATE_TEST_SUITE_P(OpenGL, Techniques, testing::Values("gl-fixed", "gl"),
                         [](const auto& info) { return std::string(info.param) == "gl" ? "gl" : "gl_fixed"; });

TEST(Techniques, CoverTheSamePixelsAtTheSameDepth) {
  const auto all = gl_techniques();
  Scene scene = scene_with(sphere_mesh());
  scene.camera.position = {0.37, 1.1, 3.3};
  scene.objects[0].transform.rotate = {11, 23, 5};
  const Frame fixed = draw(find(all, "gl-fixed"), scene, view_of(200, 150, true));
  const Frame glsl = draw(find(all, "gl"), scene, view_of(200, 150, true));
  EXPECT_EQ(fixed.covered, glsl.covered);
  EXPECT_EQ(fixed.depth, glsl.depth);
  EXPECT_EQ(fixed.triangle, glsl.triangle);
}

TEST(Techniques, DrawAtOnceOnTwoThreads) {
  const auto all = gl_techniques();
  const Scene scene = scene_with(sphere_mesh());
  const Frame expected[2] = {draw(all[0], scene, view_of(64, 64)), draw(all[1], scene, view_of(64, 64))};
  std::atomic<int> same{0};
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 2; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 30; ++i) same += draw(all[t], scene, view_of(64, 64)).colour == expected[t].colour;
    });
  for (std::thread& t : threads) t.join();
  EXPECT_EQ(same, 60);
}

TEST(FixedFunction, SaysWhatItCannotDraw) {
  const auto all = gl_techniques();
  Scene scene = scene_with(sphere_mesh());
  EXPECT_FALSE(find(all, "gl-fixed").unsupported(scene));
  scene.shading.reflection = Reflection::reflection_vector;
  EXPECT_TRUE(find(all, "gl-fixed").unsupported(scene));
  EXPECT_FALSE(find(all, "gl").unsupported(scene));
  EXPECT_THROW(draw(find(all, "gl-fixed"), scene, view_of(8, 8)), InputError);
  scene.shading.reflection = Reflection::half_vector;
  scene.shading.mode = ShadingMode::phong;
  EXPECT_TRUE(find(all, "gl-fixed").unsupported(scene));
}

TEST(Glsl, DrawsTheReflectionVector) {
  const auto all = gl_techniques();
  for (const ShadingMode mode : {ShadingMode::gouraud, ShadingMode::phong}) {
    Scene scene = scene_with(sphere_mesh());
    scene.shading.reflection = Reflection::reflection_vector;
    scene.shading.mode = mode;
    scene.material.n = 4;
    const Frame frame = draw(find(all, "gl"), scene, view_of(96, 96, true));
    EXPECT_LT(against_reference(scene, frame).largest, tolerance);
  }
}

}  // namespace
}  // namespace cg
