// Each mistake changes, in what gl-fixed draws, the number that it claims, and leaves nothing behind.
#include <gtest/gtest.h>

#include "gl_scenes.h"
#include "params/slots.h"
#include "workbench/mistake_effects.h"

namespace cg {
namespace {

constexpr double exact = 2e-6;            // of colours that are computed in float
constexpr double opengl_lighting = 5e-5;  // from the light model in double, as lighting_oracle_test finds it
constexpr int side = 96;

class Mistake : public testing::Test {
 protected:
  Frame draw_fixed(const Scene& scene, bool ids = false) const { return draw(fixed_, scene, view_of(side, side, ids)); }
  static double claim(const Scene& scene, std::string_view mistake) {
    const auto effect = mistake_effect(scene, mistake, view_of(side, side));
    EXPECT_TRUE(effect && effect->shows) << mistake;
    EXPECT_FALSE(effect->text.en.empty() || effect->text.ja.empty());
    return effect->value;
  }

  const std::vector<Technique> all_ = gl_techniques();
  const Technique& fixed_ = find(all_, "gl-fixed");
};

// One term alone: white, unclamped, no ambient light, so that a colour is N.L or the highlight.
Scene bare(MeshHandle mesh, const glm::dvec3& k_d, const glm::dvec3& k_s) {
  Scene s = scene_with(std::move(mesh));
  s.shading.ambient = {0, 0, 0};
  s.shading.clamp = false;
  s.material.k_d = k_d, s.material.k_s = k_s;
  s.material.n = 4;
  s.camera.position = {0, 0, 4};
  s.lights[0].kind = LightKind::directional;
  s.lights[0].position = {0, 0, 1};
  return s;
}
Scene diffuse_only(MeshHandle mesh) { return bare(std::move(mesh), {1, 1, 1}, {0, 0, 0}); }

// A square in the plane z = 0 that is `thin` in y: all its corners are alike for a light above the x axis.
MeshHandle strip_mesh(double thin) {
  MeshData d;
  d.positions = {{-1, -thin, 0}, {1, -thin, 0}, {1, thin, 0}, {-1, thin, 0}};
  const Corner quad[4] = {
      {0, no_index, no_index}, {1, no_index, no_index}, {2, no_index, no_index}, {3, no_index, no_index}};
  d.add_face(quad, quad + 4);
  return Mesh::make(std::move(d));
}

float middle(const Frame& f) { return f.colour.at(side / 2, side / 2).r; }

double largest_difference(const Frame& a, const Frame& b) {
  float largest = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const glm::vec3 d = glm::abs(a.colour.at(x, y) - b.colour.at(x, y));
      largest = std::max({largest, d.r, d.g, d.b});
    }
  return largest;
}

std::size_t count(const Image<std::uint8_t>& covered) {
  std::size_t n = 0;
  for (int y = 0; y < covered.height(); ++y)
    for (int x = 0; x < covered.width(); ++x) n += covered.at(x, y);
  return n;
}

TEST_F(Mistake, LeavesNothingBehind) {
  Scene scene = scene_with(sphere_mesh());
  scene.material.k_d = {0.8, 0.3, 0.1};
  scene.material.n = 2;
  scene.lights[0].position = {3, 1, -2};
  scene.objects[0].transform.scale = {0.5, 0.75, 1};
  scene.camera.position = {2, 1, 2.5};
  scene.objects.push_back(scene.objects[0]);
  scene.objects[1].transform.translate = {0.3, 0.4, -0.9};
  for (const ColorMaterial tracked : {ColorMaterial::off, ColorMaterial::diffuse}) {
    scene.shading.color_material = tracked;
    scene.material.color = {0.1, 0.5, 0.9};
    const Frame right = draw_fixed(scene, true);
    for (const Slot& slot : slots(scene.mistakes)) {
      bool& mistake = **std::get_if<bool*>(&slot.value);
      mistake = true;
      EXPECT_GT(largest_difference(draw_fixed(scene, true), right), 0.02) << slot.path;
      mistake = false;
      const Frame again = draw_fixed(scene, true);
      EXPECT_EQ(again.colour, right.colour) << slot.path;
      EXPECT_EQ(again.depth, right.depth) << slot.path;
      EXPECT_EQ(again.triangle, right.triangle) << slot.path;
      EXPECT_EQ(again.normal, right.normal) << slot.path;
    }
  }
}

// What the other techniques draw, and in which light they draw it, is none of a mistake's business.
TEST_F(Mistake, LeavesGlslAsItIs) {
  Scene scene = scene_with(sphere_mesh());
  const Frame right = draw(find(all_, "gl"), scene, view_of(side, side));
  for (const Slot& slot : slots(scene.mistakes)) **std::get_if<bool*>(&slot.value) = true;
  EXPECT_EQ(draw(find(all_, "gl"), scene, view_of(side, side)).colour, right.colour);
}

TEST_F(Mistake, LightBeforeView) {
  Scene scene = diffuse_only(square_mesh());
  EXPECT_FALSE(mistake_effect(scene, "light_before_view", view_of(side, side))->shows);
  scene.camera.position = {4 * std::sin(radians(30)), 0, 4 * std::cos(radians(30))};  // orbited by 30°
  const double angle = claim(scene, "light_before_view");
  EXPECT_NEAR(angle, 30, 1e-9);
  EXPECT_NEAR(middle(draw_fixed(scene)), 1, exact);
  scene.mistakes.light_before_view = true;
  EXPECT_NEAR(middle(draw_fixed(scene)), std::cos(radians(angle)), exact);
}

TEST_F(Mistake, LightBeforeViewIsALightElsewhere) {
  Scene scene = scene_with(sphere_mesh());
  scene.camera.position = {2, 1.5, 2};
  scene.lights[0].position = {2, 1, 3};
  Scene moved = scene;
  scene.mistakes.light_before_view = true;
  moved.lights[0].position =
      glm::dvec3(glm::inverse(view_matrix(scene.camera)) * glm::dvec4(scene.lights[0].position, 1));
  EXPECT_LT(largest_difference(draw_fixed(scene), draw_fixed(moved)), 1e-5);
}

TEST_F(Mistake, DirectionalW) {
  Scene scene = diffuse_only(strip_mesh(0.1));
  scene.lights[0].kind = LightKind::point;
  scene.lights[0].position = {0, 0, 2};
  scene.lights[0].k_0 = 2;
  const double angle = claim(scene, "directional_w");
  const auto text = mistake_effect(scene, "directional_w", view_of(side, side))->text;
  EXPECT_NE(text.en.find("1 instead of 0.5"), std::string::npos) << text.en;
  EXPECT_NEAR(middle(draw_fixed(scene)) * 2, std::cos(radians(angle)), exact);  // at the corners, and so everywhere
  scene.mistakes.directional_w = true;
  EXPECT_NEAR(middle(draw_fixed(scene)), 1, exact);
}

TEST_F(Mistake, NoNormalize) {
  Scene scene = diffuse_only(square_mesh());
  EXPECT_FALSE(mistake_effect(scene, "no_normalize", view_of(side, side))->shows);
  scene.objects[0].transform.scale = {2, 2, 2};
  scene.objects[0].transform.rotate = {10, 20, 30};
  const double length = claim(scene, "no_normalize");
  EXPECT_EQ(length, 0.5);
  const float right = middle(draw_fixed(scene));
  scene.mistakes.no_normalize = true;
  EXPECT_NEAR(middle(draw_fixed(scene)), length * right, exact);
}

TEST_F(Mistake, NoColorMaterial) {
  Scene scene = diffuse_only(square_mesh());
  scene.material.k_d = {0.8, 0.8, 0.8}, scene.material.k_a = {0.2, 0.2, 0.2};
  EXPECT_FALSE(mistake_effect(scene, "no_color_material", view_of(side, side))->shows);
  scene.material.k_d = {0.3, 0.8, 0.8};
  const double off = claim(scene, "no_color_material");
  const float right = middle(draw_fixed(scene));
  scene.mistakes.no_color_material = true;
  EXPECT_NEAR(middle(draw_fixed(scene)) - right, off, exact);
  scene.mistakes = {};
  scene.shading.color_material = ColorMaterial::diffuse;
  scene.material.color = {0.1, 0, 0};
  EXPECT_NEAR(middle(draw_fixed(scene)), 0.1, exact);
  scene.mistakes.no_color_material = true;
  EXPECT_NEAR(middle(draw_fixed(scene)), 0.8, exact);
}

// Ten leaves side by side, turned more and more, lit from one side.
TEST_F(Mistake, FlippedNormals) {
  MeshData d;
  for (std::uint32_t i = 0; i < 10; ++i) {
    const double a = radians(-70 + 140.0 * i / 9), x = -0.95 + 0.2 * i, w = 0.08;
    const glm::dvec3 along(std::cos(a) * w, 0, std::sin(a) * w), centre(x, 0, 0);
    for (const glm::dvec3& p : {centre - along, centre + along}) d.positions.insert(d.positions.end(), {p, p});
    d.positions[4 * i].y = d.positions[4 * i + 2].y = -0.5, d.positions[4 * i + 1].y = d.positions[4 * i + 3].y = 0.5;
    const auto corner = [&](std::uint32_t k) { return Corner{4 * i + k, no_index, no_index}; };
    const Corner quad[4] = {corner(0), corner(2), corner(3), corner(1)};
    d.add_face(quad, quad + 4);
  }
  Scene scene = diffuse_only(Mesh::make(std::move(d)));
  scene.lights[0].position = {1, 0, 0.5};
  const auto lit_triangles = [&] {
    const Frame f = draw_fixed(scene, true);
    std::vector<bool> lit(20, false), seen(20, false);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        if (const int t = f.triangle.at(x, y); t >= 0) {
          seen[std::size_t(t)] = true;
          if (f.colour.at(x, y).r > 0) lit[std::size_t(t)] = true;
        }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 20);
    return double(std::count(lit.begin(), lit.end(), true)) / 20;
  };
  const double share = claim(scene, "flipped_normals"), right = lit_triangles();
  EXPECT_NEAR(share, 1 - right, 1e-12);
  scene.mistakes.flipped_normals = true;
  EXPECT_NEAR(lit_triangles(), share, 1e-12);
  EXPECT_GT(share, 0.05);
  EXPECT_LT(share, 0.95);
}

TEST_F(Mistake, NoNormals) {
  Scene scene = diffuse_only(sphere_mesh());
  scene.lights[0].position = {1, 2, 2};
  scene.objects[0].transform.rotate = {15, 0, 0};
  const double n_dot_l = claim(scene, "no_normals");
  scene.mistakes.no_normals = true;
  const Frame f = draw_fixed(scene);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      if (f.covered.at(x, y)) {
        ASSERT_NEAR(f.colour.at(x, y).r, n_dot_l, exact);
      }
}

TEST_F(Mistake, NoGate) {
  Scene scene = bare(square_mesh(), {1, 1, 1}, {0.5, 0.5, 0.5});
  EXPECT_FALSE(mistake_effect(scene, "no_gate", view_of(side, side))->shows);
  scene.lights[0].position = {1, 0, -0.1};  // behind the square
  const double highlight = claim(scene, "no_gate");
  EXPECT_NEAR(middle(draw_fixed(scene)), 0, exact);
  scene.mistakes.no_gate = true;
  EXPECT_NEAR(middle(draw_fixed(scene)), highlight, exact);
  EXPECT_GT(highlight, 0.05);
}

TEST_F(Mistake, LongLightVector) {
  Scene scene = diffuse_only(square_mesh());
  scene.lights[0].position = {0, 1.5, 2};
  const double length = claim(scene, "long_light_vector");
  EXPECT_NEAR(length, 2.5, 1e-12);
  const float right = middle(draw_fixed(scene));
  scene.mistakes.long_light_vector = true;
  EXPECT_NEAR(middle(draw_fixed(scene)), length * right, exact);
}

// The light model of the program's own, which computes in double, is OpenGL's, where its two mistakes make no
// difference.
TEST_F(Mistake, ByHandIsOpenGlsLightElse) {
  Scene scene = scene_with(sphere_mesh());
  scene.camera.position = {1, 1, 3};
  scene.material.emission = {0.05, 0, 0};
  scene.lights.resize(3);
  scene.lights[0] = {.position = {2, 3, 4}, .w = 2, .ambient = {0.1, 0, 0}, .k_0 = 0.5, .k_1 = 0.1, .k_2 = 0.02};
  scene.lights[1] = {.kind = LightKind::spot, .position = {0, 4, 4}, .cutoff = 40, .exponent = 3};
  scene.lights[1].direction = {0, -1, -1};
  scene.lights[2] = {.kind = LightKind::directional, .position = {-0.6, 0, 0.8}, .diffuse = {0, 0.3, 0}};
  for (const NormalLength length : {NormalLength::normalize, NormalLength::rescale, NormalLength::off})
    for (const bool local : {false, true})
      for (const bool flat : {false, true}) {
        scene.shading.normal_length = length;
        scene.shading.local_viewer = local;
        scene.shading.mode = flat ? ShadingMode::flat : ShadingMode::gouraud;
        scene.objects[0].transform = {{0.1, 0, 0}, {20, 30, 40}, glm::dvec3(0.8)};
        scene.material.k_s = {0, 0, 0};
        scene.mistakes = {};
        const Frame right = draw_fixed(scene);
        scene.mistakes.no_gate = true;
        EXPECT_LT(largest_difference(draw_fixed(scene), right), opengl_lighting);
      }
  scene.lights.erase(scene.lights.begin(), scene.lights.begin() + 2);  // the directional light's position is unit
  scene.material.k_s = {0.5, 0.5, 0.5};
  scene.mistakes = {};
  const Frame right = draw_fixed(scene);
  scene.mistakes.long_light_vector = true;
  EXPECT_LT(largest_difference(draw_fixed(scene), right), opengl_lighting);
}

TEST_F(Mistake, NoDepthTest) {
  Scene scene = scene_with(sphere_mesh());
  scene.objects.push_back(scene.objects[0]);
  scene.objects[1].transform.translate = {0.5, 0, -2};
  scene.objects[1].mesh = square_mesh();
  const double share = claim(scene, "no_depth_test");
  const Frame right = draw_fixed(scene, true);
  scene.mistakes.no_depth_test = true;
  const Frame wrong = draw_fixed(scene, true);
  EXPECT_EQ(right.covered, wrong.covered);
  std::size_t other = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      other += right.triangle.at(x, y) != wrong.triangle.at(x, y) || right.object.at(x, y) != wrong.object.at(x, y);
  EXPECT_NEAR(double(other) / double(count(right.covered)), share, 1e-12);
  EXPECT_GT(share, 0.05);
}

// Two squares side by side, one of which shows its back.
TEST_F(Mistake, SwappedFrontFace) {
  Scene scene = diffuse_only(square_mesh());
  scene.objects.push_back(scene.objects[0]);
  scene.objects[0].transform = {{-0.6, 0, 0}, {0, 0, 0}, glm::dvec3(0.5)};
  scene.objects[1].transform = {{0.6, 0, 0}, {0, 180, 0}, glm::dvec3(0.5)};
  EXPECT_EQ(claim(scene, "swapped_front_face"), 0.5);
  const Frame right = draw_fixed(scene, true);
  scene.mistakes.swapped_front_face = true;
  const Frame wrong = draw_fixed(scene, true);
  EXPECT_NEAR(double(count(wrong.covered)), 0.5 * double(count(right.covered)), 0.01 * double(count(right.covered)));
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) EXPECT_NE(wrong.object.at(x, y), 0);
  // Both sides lit: nothing is culled, and N is reversed on the wrong one.
  scene.shading.two_sided = true;
  scene.mistakes = {};
  const Frame both = draw_fixed(scene);
  scene.mistakes.swapped_front_face = true;
  const Frame reversed = draw_fixed(scene);
  EXPECT_EQ(reversed.covered, both.covered);
  for (const int x : {side * 3 / 10, side * 7 / 10}) {
    EXPECT_NEAR(both.colour.at(x, side / 2).r, 1, exact);
    EXPECT_NEAR(reversed.colour.at(x, side / 2).r, 0, exact);
  }
}

// Whatever the scene, a mistake is drawn without an error and says something.
TEST_F(Mistake, IsDrawnInExtremeScenes) {
  for (const double size : {1e-20, 1e-4, 1e6, 1e20}) {
    Scene scene = scene_with(sphere_mesh(12, 6, size));
    scene.camera.position *= size, scene.camera.near_plane = size, scene.camera.far_plane = 10 * size;
    scene.lights[0].position = glm::dvec3(2, 3, 4) * size;
    for (const Slot& slot : slots(scene.mistakes)) {
      **std::get_if<bool*>(&slot.value) = true;
      EXPECT_EQ(draw_fixed(scene).nan_pixels, 0u) << slot.path << " at " << size;
      EXPECT_FALSE(mistake_effect(scene, slot.about->name, view_of(side, side))->text.en.empty());
      **std::get_if<bool*>(&slot.value) = false;
    }
  }
  EXPECT_FALSE(mistake_effect(Scene{}, "no_gate", view_of(side, side))->shows);
  EXPECT_FALSE(mistake_effect(Scene{}, "no such mistake", view_of(side, side)));
}

}  // namespace
}  // namespace cg
