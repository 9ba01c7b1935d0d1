// Layers of textures as the technique `gl` draws them, against the formulas in double on a square that fills the
// picture.
#include <gtest/gtest.h>

#include <set>

#include "textured_quad.h"

namespace cg {
namespace {

class Drawn : public testing::Test {
 protected:
  explicit Drawn(const char* id) : id_(id) {}
  void SetUp() override {
    Technique t = technique();
    find_availability(t);
    if (t.unavailable) GTEST_SKIP() << t.unavailable->en;
  }
  const Technique& technique() const { return find(all_, id_); }
  Frame drawn(const Scene& scene) const { return draw(technique(), scene, view_of(quad_side, quad_side, true)); }

 private:
  const std::string id_;
  const std::vector<Technique> all_ = gl_techniques();
};

// Where alpha is not above the threshold there is nothing: no colour, no number.
void expect_holes_in(const Scene& scene, const Frame& frame) {
  int holes = 0, wrong = 0;
  for (int y = 0; y < quad_side; ++y)
    for (int x = 0; x < quad_side; ++x) {
      const bool there = frame.covered.at(x, quad_side - 1 - y) != 0;
      ASSERT_EQ(there, frame.object.at(x, quad_side - 1 - y) != nothing) << x << ", " << y;
      ASSERT_EQ(there, frame.normal.at(x, quad_side - 1 - y) != glm::vec3(0)) << x << ", " << y;
      holes += !there;
      wrong += there != (quad_colour(scene, x, y).a > scene.shading.alpha_threshold);
    }
  EXPECT_GT(holes, 1000);
  EXPECT_LE(wrong, 60);  // where a texel ends
}

class TextureLayers : public Drawn {
 protected:
  TextureLayers() : Drawn("gl") {}
};

class FixedTextures : public Drawn {
 protected:
  FixedTextures() : Drawn("gl-fixed") {}
  // Of one vertex is of all: the light is directional, the viewer far away.
  static Scene scene() {
    Scene s = quad_scene();
    s.shading.mode = ShadingMode::gouraud;
    return s;
  }
};

constexpr LayerTarget drawn_targets[] = {LayerTarget::colour, LayerTarget::k_a, LayerTarget::k_d,
                                         LayerTarget::k_s,    LayerTarget::n,   LayerTarget::emission};

TEST_F(TextureLayers, EachTargetByEachBlend) {
  for (const LayerTarget target : drawn_targets)
    for (int blend = 0; blend < 5; ++blend) {
      Scene scene = quad_scene();
      TextureLayer layer = quad_layer(noise_picture(16, 16, 3));
      layer.target = target, layer.blend = LayerBlend(blend);
      layer.blend_colour = {0.9, 0.2, 0.4}, layer.amount = 0.75, layer.scale = target == LayerTarget::n ? 20 : 0.8;
      scene.material.layers = {layer};
      const QuadError e = against_quad(scene, drawn(scene));
      EXPECT_LE(e.over_1, e.compared / 1000) << int(target) << " " << blend;
      EXPECT_LE(e.largest, 2.0 / 255) << int(target) << " " << blend;
    }
}

// A layer brings in what the material has none of.
TEST_F(TextureLayers, ReplaceWhatIsBlack) {
  for (const LayerTarget target : {LayerTarget::k_a, LayerTarget::k_d, LayerTarget::k_s, LayerTarget::emission}) {
    Scene scene = quad_scene();
    scene.material.k_a = scene.material.k_d = scene.material.k_s = {0, 0, 0};
    scene.material.layers = {quad_layer(noise_picture(16, 16, 4))};
    scene.material.layers[0].target = target, scene.material.layers[0].blend = LayerBlend::replace;
    const Frame frame = drawn(scene);
    const QuadError e = against_quad(scene, frame);
    EXPECT_LE(e.largest, 2.0 / 255) << int(target);
    EXPECT_GT(glm::length(frame.colour.at(quad_side / 2, quad_side / 2)), 0.01f) << int(target);
  }
}

// Drivers interpolate 8 bits with weights of 8 bits: between black and white that alone is 1/255, so the contrast of
// what is read linearly is a quarter of that.
TEST_F(TextureLayers, WrapsAndFilters) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::border})
    for (const MagFilter filter : {MagFilter::nearest, MagFilter::linear}) {
      const bool linear = filter == MagFilter::linear;
      Scene scene = quad_scene();
      TextureLayer layer = quad_layer(linear ? noise_picture(7, 5, 5, 96, 159) : noise_picture(7, 5, 5));
      layer.sampling.wrap_s = layer.sampling.wrap_t = wrap;
      layer.sampling.mag_filter = filter;
      layer.sampling.min_filter = linear ? MinFilter::linear : MinFilter::nearest;
      layer.sampling.border = {0.2, 0.7, 0.4}, layer.sampling.border_alpha = 0.5;
      layer.matrix.repeat_u = 3.1, layer.matrix.repeat_v = -2.3, layer.blend = LayerBlend::replace;
      scene.material.layers = {layer};
      const QuadError e = against_quad(scene, drawn(scene));
      EXPECT_LE(e.over_1, e.compared / 1000) << int(wrap) << int(filter);
      // A pixel whose centre is within float's rounding of a texel's border may have either.
      if (linear) {
        EXPECT_LE(e.largest, 2.0 / 255) << int(wrap);
      }
    }
}

// A driver's level is off by up to 0.05, and so shows that much of the difference of two levels.
TEST_F(TextureLayers, Mipmaps) {
  for (const MinFilter filter : {MinFilter::nearest_mipmap_nearest, MinFilter::linear_mipmap_nearest,
                                 MinFilter::nearest_mipmap_linear, MinFilter::linear_mipmap_linear})
    for (const double repeats : {1.3, 3.2, 9.7}) {
      Scene scene = quad_scene();
      TextureLayer layer = quad_layer(noise_picture(256, 256, 6, 96, 159));
      layer.sampling.min_filter = filter, layer.sampling.mag_filter = MagFilter::linear;
      layer.matrix.repeat_u = repeats, layer.matrix.repeat_v = repeats * 0.8, layer.blend = LayerBlend::replace;
      scene.material.layers = {layer};
      const QuadError e = against_quad(scene, drawn(scene));
      EXPECT_LE(e.over_3, e.compared / 100) << int(filter) << " " << repeats;
    }
}

TEST_F(TextureLayers, BumpsAndNormalMaps) {
  for (const BumpKind kind : {BumpKind::height, BumpKind::normal_map})
    for (const double amount : {1.0, 0.4}) {
      Scene scene = quad_scene();
      TextureLayer layer = quad_layer(noise_picture(9, 9, 7));
      layer.sampling.mag_filter = kind == BumpKind::height ? MagFilter::linear : MagFilter::nearest;
      layer.target = LayerTarget::normal, layer.bump = kind;
      layer.scale = kind == BumpKind::height ? 0.1 : 1, layer.amount = amount, layer.matrix.repeat_u = 2;
      scene.material.layers = {layer};
      const QuadError e = against_quad(scene, drawn(scene));
      EXPECT_LE(e.over_1, e.compared / 1000) << int(kind);
      scene.material.layers.clear();
      const Frame flat = drawn(scene);
      EXPECT_EQ(flat.colour.at(3, 3), flat.colour.at(90, 70)) << "there would be nothing to see";
    }
}

TEST_F(TextureLayers, SixteenLayers) {
  Scene scene = quad_scene();
  std::mt19937 random(11);
  for (unsigned i = 0; i < most_layers; ++i) {
    TextureLayer layer = quad_layer(noise_picture(8 + int(i), 8, i));
    layer.target = drawn_targets[random() % 4];
    layer.blend = LayerBlend(random() % 5);
    layer.amount = 0.3, layer.blend_colour = {0.1, 0.5, 0.9};
    layer.matrix.turn = 10.0 * i + 3;
    if (i % 3 == 1) layer.uv = UvSource::projector, layer.projector.shape = ProjectionShape::planar;
    if (i % 3 == 2) layer.perspective = false;
    scene.material.layers.push_back(layer);
  }
  // A planar projector has uv 0..1 over the same square.
  const QuadError e = against_quad(scene, drawn(scene));
  EXPECT_LE(e.over_1, e.compared / 500);
}

// One picture read in two ways at once.
TEST_F(TextureLayers, TwoSamplingsOfOnePicture) {
  Scene scene = quad_scene();
  TextureLayer layer = quad_layer(noise_picture(8, 8, 2));
  scene.material.layers = {layer, layer};
  scene.material.layers[1].sampling.mag_filter = MagFilter::linear;
  scene.material.layers[1].sampling.wrap_s = Wrap::clamp;
  const QuadError e = against_quad(scene, drawn(scene));
  EXPECT_LE(e.over_1, e.compared / 1000);
}

TEST_F(TextureLayers, TheAlphaTestLeavesHoles) {
  Scene scene = quad_scene();
  TextureLayer layer = quad_layer(noise_picture(8, 8, 9));
  layer.target = LayerTarget::opacity, layer.blend = LayerBlend::replace;
  scene.material.layers = {layer};
  for (const double threshold : {0.25, 0.5}) {
    scene.shading.transparency = Transparency::test;
    scene.shading.alpha_threshold = threshold;
    expect_holes_in(scene, drawn(scene));
  }
  scene.shading.transparency = Transparency::opaque;
  const Frame frame = drawn(scene);
  for (const auto covered : frame.covered.pixels()) ASSERT_TRUE(covered);
}

TEST_F(FixedTextures, EachBlend) {
  for (int blend = 0; blend < 5; ++blend)
    for (const MagFilter filter : {MagFilter::nearest, MagFilter::linear}) {
      Scene scene = FixedTextures::scene();
      TextureLayer layer = quad_layer(noise_picture(16, 16, 3, 96, 159));
      layer.sampling.mag_filter = filter, layer.sampling.wrap_s = Wrap::mirror, layer.matrix.repeat_v = 1.7;
      layer.blend = LayerBlend(blend), layer.blend_colour = {0.9, 0.2, 0.4};
      scene.material.layers = {layer};
      const QuadError e = against_quad(scene, drawn(scene));
      EXPECT_LE(e.over_1, e.compared / 1000) << blend << int(filter);
      if (filter == MagFilter::linear) {  // else a pixel on the edge of a texel may have either
        EXPECT_LE(e.largest, 2.0 / 255) << blend;
      }
    }
}

TEST_F(FixedTextures, SeveralUnitsEachItsOwn) {
  Scene scene = FixedTextures::scene();
  const TextureHandle picture = noise_picture(8, 8, 12);
  for (int i = 0; i < 6; ++i) {
    TextureLayer layer = quad_layer(i < 2 ? picture : noise_picture(6 + i, 5, unsigned(i)));
    layer.blend = std::array{LayerBlend::modulate, LayerBlend::decal, LayerBlend::blend}[std::size_t(i % 3)];
    layer.blend_colour = {1, 0.5, 0.1};
    layer.matrix.turn = 31 * i + 2, layer.matrix.repeat_u = i == 4 ? 1 : 2;
    layer.sampling.wrap_s = i == 1 ? Wrap::clamp : Wrap::repeat;
    if (i % 2 == 1) layer.uv = UvSource::projector, layer.projector.shape = ProjectionShape::planar;
    scene.material.layers.push_back(layer);
  }
  const QuadError e = against_quad(scene, drawn(scene));
  EXPECT_LE(e.over_1, e.compared / 500);
}

// A texture's units do not reach the next object, nor the next picture.
TEST_F(FixedTextures, OthersHaveNone) {
  Scene plain = FixedTextures::scene();
  plain.objects.push_back(plain.objects[0]);
  plain.objects[0].transform.translate = {-1, 0, 0}, plain.objects[1].transform.translate = {1, 0, 0};
  plain.objects[0].own_material = true, plain.objects[0].material = plain.material;
  Scene scene = plain;
  const TextureLayer layer = quad_layer(noise_picture(8, 8, 12));
  scene.objects[0].material.layers = {layer, layer};
  const Frame before = drawn(plain), with = drawn(scene), after = drawn(plain);
  EXPECT_EQ(before.colour.at(200, 100), with.colour.at(200, 100));
  EXPECT_NE(before.colour.at(50, 100), with.colour.at(50, 100));
  EXPECT_EQ(before.colour.pixels(), after.colour.pixels());
}

TEST_F(FixedTextures, TheAlphaTestLeavesHoles) {
  Scene scene = FixedTextures::scene();
  scene.material.layers = {quad_layer(noise_picture(8, 8, 9))};
  scene.shading.transparency = Transparency::test, scene.shading.alpha_threshold = 0.4;
  expect_holes_in(scene, drawn(scene));
}

TEST_F(FixedTextures, SaysWhatItHasNot) {
  const auto why = [&](auto change) {
    Scene scene = FixedTextures::scene();
    scene.material.layers = {quad_layer(noise_picture(8, 8, 9))};
    change(scene.material.layers[0]);
    const std::optional<Text> text = technique().unsupported(scene);
    return text ? text->en + " / " + text->ja : "";
  };
  EXPECT_EQ(why([](TextureLayer&) {}), "");
  const std::set<std::string> reasons{
      why([](TextureLayer& l) { l.target = LayerTarget::k_d; }),
      why([](TextureLayer& l) { l.amount = 0.5; }),
      why([](TextureLayer& l) { l.perspective = false; }),
  };
  EXPECT_EQ(reasons.size(), 3u);
  EXPECT_FALSE(reasons.contains(""));
}

}  // namespace
}  // namespace cg
