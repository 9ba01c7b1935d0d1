// Layers against OpenGL's table by hand.
#include "shading/layers.h"

#include <gtest/gtest.h>

#include <random>

namespace cg {
namespace {

using Vec = Vec3<double>;

const Vec4<double> C(0.8, 0.5, 0.2, 0.75), T(0.25, 1, 0.5, 0.4);
const Vec C_c(1, 0, 0.5);

void expect_near(const Vec4<double>& a, const Vec4<double>& b) {
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], 1e-15) << i;
}

TEST(LayersTest, TheTableOfTextureEnvironments) {
  expect_near(blended(LayerBlend::replace, C, T, C_c), T);
  expect_near(blended(LayerBlend::modulate, C, T, C_c), {0.2, 0.5, 0.1, 0.3});
  expect_near(blended(LayerBlend::decal, C, T, C_c), {0.8 * 0.6 + 0.1, 0.3 + 0.4, 0.12 + 0.2, 0.75});
  expect_near(blended(LayerBlend::blend, C, T, C_c), {0.6 + 0.25, 0, 0.1 + 0.25, 0.3});
  expect_near(blended(LayerBlend::add, C, T, C_c), {1.05, 1.5, 0.7, 0.3});
}

TEST(LayersTest, AmountGoesFromNothingToAll) {
  TextureLayer layer;
  for (const double amount : {0.0, 0.3, 1.0}) {
    layer.amount = amount;
    expect_near(layered(layer, C, T), C + (C * T - C) * amount);
  }
}

TEST(LayersTest, EachTargetChangesItsNumberAlone) {
  const SurfaceNumbers<double> before{{Vec(0.1), Vec(0.2), Vec(0.3), Vec(0.4), 32}, Vec(0.5), Vec(0.6), 0.7};
  const Vec4<double> half(0.5, 0.5, 0.5, 0.5);
  for (int target = 0; target < int(names_of<LayerTarget>.size()); ++target) {
    TextureLayer layer;
    layer.target = LayerTarget(target);
    SurfaceNumbers<double> s = before;
    apply(layer, half, s);
    const auto numbers = [](const SurfaceNumbers<double>& x) {
      return std::vector{x.material.k_a.x, x.material.k_d.x, x.material.k_s.x,      x.material.n,
                         x.k_r.x,          x.k_t.x,          x.material.emission.x, x.opacity};
    };
    const std::vector<double> was = numbers(before), is = numbers(s);
    int changed = 0;
    for (std::size_t i = 0; i < was.size(); ++i)
      if (is[i] != was[i]) {
        ++changed;
        EXPECT_NEAR(is[i], was[i] / 2, 1e-15) << target;
      }
    const bool among = LayerTarget(target) != LayerTarget::colour && LayerTarget(target) != LayerTarget::normal;
    EXPECT_EQ(changed, among ? 1 : 0) << target;
  }
}

TEST(LayersTest, SixteenLayersAreTheirFormula) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  double c = 0.6;
  Vec4<double> composed(c, c, c, 1);
  for (std::size_t i = 0; i < most_layers; ++i) {
    TextureLayer layer;
    layer.blend = LayerBlend(random() % names_of<LayerBlend>.size());
    layer.amount = unit(random), layer.scale = 0.5 + unit(random);
    layer.blend_colour = Vec(unit(random));
    const double t = unit(random), a = unit(random), s = t * layer.scale;
    const double all = layer.blend == LayerBlend::replace    ? s
                       : layer.blend == LayerBlend::modulate ? c * s
                       : layer.blend == LayerBlend::decal    ? c * (1 - a) + s * a
                       : layer.blend == LayerBlend::blend    ? c * (1 - s) + layer.blend_colour.x * s
                                                             : c + s;
    c += (all - c) * layer.amount;
    composed = layered(layer, composed, Vec4<double>(t, t, t, a));
    EXPECT_NEAR(composed.x, c, 1e-13) << i;
  }
}

TEST(LayersTest, SoloAndMute) {
  std::vector<TextureLayer> layers(4);
  for (TextureLayer& l : layers) l.texture = TextureImage::placeholder();
  layers[1].visible = false;
  EXPECT_EQ(counting(layers).size(), 3u);
  layers[2].solo = true;
  ASSERT_EQ(counting(layers).size(), 1u);
  EXPECT_EQ(counting(layers)[0], &layers[2]);
  layers[2].texture.reset();  // no picture: it is not there, and its solo neither
  EXPECT_EQ(counting(layers).size(), 2u);
}

TEST(LayersTest, TheTextureMatrix) {
  TextureMatrix m;
  m.repeat_u = 2, m.repeat_v = 3, m.turn = 90, m.offset_u = 0.25, m.offset_v = -1;
  const TextureTransform<double> t(m);
  const Vec2<double> p = t.point({0.5, 0.1});
  EXPECT_NEAR(p.x, -0.3 + 0.25, 1e-15);
  EXPECT_NEAR(p.y, 1 - 1, 1e-15);
  EXPECT_EQ(TextureTransform<double>(TextureMatrix{}).point({0.3, 0.7}), Vec2<double>(0.3, 0.7));
  const auto f = t.footprint({{0, 0}, {0.1, 0}, {0, 0.1}});
  EXPECT_NEAR(f.dx.y, 0.2, 1e-15);
  EXPECT_NEAR(f.dy.x, -0.3, 1e-15);
}

}  // namespace
}  // namespace cg
