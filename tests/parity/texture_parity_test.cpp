// Textured scenes in software and OpenGL: filters, wraps, mipmaps, targets, bumps, holes.
#include <gtest/gtest.h>

#include <random>

#include "params/input_error.h"
#include "tests/parity/parity_cases.h"

namespace cg::parity {
namespace {

class TextureParity : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      comparison_.emplace();
    } catch (const InputError& none) {
      GTEST_SKIP() << none.what();
    }
  }

  // The share of pixels beyond 1/255 (3/255 where `levels`), in thousandths at most; a nearest texel's edge may fall
  // to either side, so that its error has no limit.
  void expect_same(const Scene& scene, const std::string& what, bool edges = false) {
    for (const Result& r : comparison_->compare(scene, what)) {
      std::printf("%s: coverage %zu, beyond 1/255 %zu of %zu, largest %.2f/255\n", r.what.c_str(), r.coverage_mismatch,
                  r.over_1_255, r.covered, r.max_error * 255);
      EXPECT_LE(r.coverage_mismatch, edges ? r.covered / 1000 : 5) << r.what;
      EXPECT_LE(double(r.over_1_255), 0.001 * double(r.covered)) << r.what;
      if (!edges) {
        EXPECT_LE(r.max_error * 255, 2.001) << r.what;
      }
      EXPECT_GT(r.covered, 1000u) << r.what;
    }
  }

  std::optional<Comparison> comparison_;
};

// A picture as pictures are: waves of a few texels and more, their contrast less the shorter they are; alpha too.
// `contrast`: less where two of its numbers are multiplied, each of which a driver knows to 1/255 only.
TextureHandle waves(int width, int height, unsigned seed, double contrast = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Image<glm::u8vec4> texels(width, height);
  for (int c = 0; c < 4; ++c) {
    std::vector<std::array<double, 4>> wave(6);
    for (std::size_t k = 0; k < wave.size(); ++k)
      wave[k] = {std::floor(1 + unit(random) * double(1 << k)), std::floor(1 + unit(random) * double(1 << k)),
                 unit(random) * 6.28, 0.35 * contrast / double(1 + k)};
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        double v = 0.5;
        for (const auto& [fx, fy, phase, height_of] : wave)
          v += height_of * std::sin(6.283185307 * (fx * x / width + fy * y / height) + phase);
        texels.at(x, y)[c] = std::uint8_t(std::clamp(v, 0.0, 1.0) * 255 + 0.5);
      }
  }
  return TextureImage::make(std::move(texels), Encoding::as_stored);
}

TextureLayer layer_with(TextureHandle picture, MinFilter filter) {
  TextureLayer layer;
  layer.texture = std::move(picture);
  layer.uv = UvSource::projector;
  layer.projector.place.rotate = {12, 25, 7};
  layer.sampling.min_filter = filter;
  layer.sampling.mag_filter = is_linear_within(filter) ? MagFilter::linear : MagFilter::nearest;
  layer.matrix.repeat_u = 1.7, layer.matrix.repeat_v = 1.3, layer.matrix.offset_u = 0.123;
  return layer;
}

Scene textured(const char* shape, const TextureLayer& layer, ShadingMode mode = ShadingMode::phong, int camera = 0) {
  Scene scene = scene_of(shape_model(shape), {camera, LightKind::point, mode, Reflection::half_vector});
  scene.material.layers = {layer};
  return scene;
}

TEST_F(TextureParity, NearestAndLinearWithEachWrap) {
  const TextureHandle picture = waves(128, 96, 1);
  for (const MinFilter filter : {MinFilter::nearest, MinFilter::linear})
    for (int wrap = 0; wrap < 4; ++wrap) {
      TextureLayer layer = layer_with(picture, filter);
      layer.sampling.wrap_s = layer.sampling.wrap_t = Wrap(wrap);
      layer.sampling.border = {0.6, 0.6, 0.6};
      layer.target = LayerTarget::k_d;
      const std::string what = "teapot " + std::string(names_of<Wrap>[std::size_t(wrap)].id) + " " +
                               std::string(names_of<MinFilter>[std::size_t(filter)].id);
      expect_same(textured("teapot", layer), what, filter == MinFilter::nearest);
    }
}

TEST_F(TextureParity, TheLitColourInEveryShading) {
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
    for (int blend = 0; blend < 5; ++blend) {
      TextureLayer layer = layer_with(waves(64, 64, 2, 0.3), MinFilter::linear);
      layer.blend = LayerBlend(blend), layer.blend_colour = {0.9, 0.3, 0.1};
      expect_same(textured("torus-knot", layer, mode, blend % 3),
                  "blend " + std::to_string(blend) + " mode " + std::to_string(int(mode)));
    }
}

TEST_F(TextureParity, EachTargetInEveryShading) {
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
    for (const LayerTarget target :
         {LayerTarget::k_a, LayerTarget::k_d, LayerTarget::k_s, LayerTarget::n, LayerTarget::emission}) {
      TextureLayer layer = layer_with(waves(64, 64, 3), MinFilter::linear);
      layer.target = target, layer.blend = LayerBlend::replace, layer.amount = 0.7;
      if (target == LayerTarget::n) layer.scale = 40;
      expect_same(textured("teapot", layer, mode), "mode " + std::to_string(int(mode)) + " " +
                                                       std::string(names_of<LayerTarget>[std::size_t(target)].id));
    }
}

TEST_F(TextureParity, BumpsAndNormalMaps) {
  for (const BumpKind kind : {BumpKind::height, BumpKind::normal_map}) {
    TextureLayer layer = layer_with(waves(64, 64, 4), MinFilter::linear);
    layer.target = LayerTarget::normal, layer.bump = kind, layer.scale = kind == BumpKind::height ? 0.03 : 0.6;
    for (int camera = 0; camera < 3; ++camera)
      expect_same(textured("teapot", layer, ShadingMode::phong, camera),
                  "bump " + std::to_string(int(kind)) + " camera " + std::to_string(camera));
  }
}

TEST_F(TextureParity, WithoutPerspective) {
  TextureLayer layer = layer_with(waves(64, 64, 5), MinFilter::linear);
  layer.perspective = false;
  layer.uv = UvSource::mesh;
  for (const int camera : {0, 2}) expect_same(textured("plane", layer, ShadingMode::phong, camera), "plane, affine");
}

TEST_F(TextureParity, SeveralLayersAndHoles) {
  TextureLayer first = layer_with(waves(64, 64, 6), MinFilter::linear), second = first, third = first;
  first.target = LayerTarget::k_d;
  second.texture = waves(32, 64, 7), second.blend = LayerBlend::decal, second.amount = 0.5;
  second.projector.shape = ProjectionShape::cylindrical;
  third.target = LayerTarget::opacity, third.blend = LayerBlend::replace;
  Scene scene = textured("teapot", first);
  scene.material.layers = {first, second, third};
  scene.shading.transparency = Transparency::test;
  expect_same(scene, "three layers with holes", true);
}

// At least 99 % within 3/255: a driver may choose its level a little off.
TEST_F(TextureParity, Mipmaps) {
  const TextureHandle picture = waves(512, 512, 8);
  for (const MinFilter filter : {MinFilter::nearest_mipmap_nearest, MinFilter::linear_mipmap_nearest,
                                 MinFilter::nearest_mipmap_linear, MinFilter::linear_mipmap_linear}) {
    TextureLayer layer = layer_with(picture, filter);
    layer.matrix.repeat_u = layer.matrix.repeat_v = 4;
    const Scene scene = textured("teapot", layer);
    for (const Result& r : comparison_->compare(scene, std::string(names_of<MinFilter>[std::size_t(filter)].id))) {
      std::printf("%s: beyond 1/255 %zu, beyond 3/255 %zu of %zu, largest %.2f/255\n", r.what.c_str(), r.over_1_255,
                  r.over_3_255, r.covered, r.max_error * 255);
      EXPECT_LE(r.over_3_255, r.covered / 100) << r.what;
    }
  }
}

}  // namespace
}  // namespace cg::parity
