#include <gtest/gtest.h>

#include "layered_scenes.h"
#include "raster/interpolation.h"
#include "scene/shape.h"
#include "shading/bump.h"

using namespace cg;
using namespace cg::testing;

TEST(Layers, CheckerIsExactAtEveryPixel) {
  Image<glm::u8vec4> checker(8, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      checker.at(x, y) = (x + y) % 2 == 0 ? glm::u8vec4(255, 51, 0, 255) : glm::u8vec4(0, 102, x, 255);
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
    for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
      Scene s = glowing_scene({1, 1, 1});
      s.shading.mode = mode, s.shading.precision = precision;
      s.material.layers = {layer_of(TextureImage::make(checker, Encoding::as_stored))};
      const Frame frame = draw(s, view_of(side, side));
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
          const glm::u8vec4 t = checker.at(x / 8, (side - 1 - y) / 8);
          for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(frame.colour.at(x, y)[c], float(t[c]) / 255.0f);
        }
    }
}

TEST(Layers, UvOverATiltedPlaneFollowTheRay) {
  Scene s = glowing_scene({1, 1, 1});
  s.objects[0].transform.rotate = {-60, 0, 0};
  s.camera.projection = Projection::perspective;
  s.camera.position = {0.2, 0.3, 2.5};
  s.camera.target = {0.2, 0.3, 0};
  TextureLayer l = layer_of(ramp());
  l.sampling.mag_filter = MagFilter::linear, l.sampling.min_filter = MinFilter::linear;
  l.sampling.wrap_s = l.sampling.wrap_t = Wrap::clamp;
  s.material.layers = {l};
  const Frame frame = draw(s, view_of(side, side));
  const glm::dmat4 to_clip = projection_matrix(s.camera, 1) * view_matrix(s.camera) * matrix(s.objects[0].transform);
  // Where the plane (x, y, 0) meets the pixel's ray: clip = to_clip (x, y, 0, 1) and clip.xy = w (X, Y).
  int compared = 0;
  double affine_difference = 0;
  s.material.layers[0].perspective = false;
  const Frame affine = draw(s, view_of(side, side));
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (!frame.covered.at(x, y)) continue;
      const double X = (2.0 * x + 1) / side - 1, Y = 1 - (2.0 * y + 1) / side;
      const auto& m = to_clip;
      const glm::dmat2 A(m[0][0] - X * m[0][3], m[0][1] - Y * m[0][3], m[1][0] - X * m[1][3], m[1][1] - Y * m[1][3]);
      const glm::dvec2 p = glm::inverse(A) * glm::dvec2(X * m[3][3] - m[3][0], Y * m[3][3] - m[3][1]);
      const glm::dvec2 want = glm::clamp(p, -0.5, 0.5) + 0.5;
      for (int c = 0; c < 2; ++c) EXPECT_NEAR(frame.colour.at(x, y)[c], want[c], 2e-5) << x << " " << y;
      for (int c = 0; c < 2; ++c)
        affine_difference = std::max(affine_difference, std::abs(affine.colour.at(x, y)[c] - want[c]));
      ++compared;
    }
  EXPECT_GT(compared, 500);
  EXPECT_GT(affine_difference, 0.1);
}

TEST(Layers, AffineUvAreLinearOverThePicture) {
  MeshData d;
  d.positions = {{-0.9, -0.9, 1}, {0.9, -0.9, 0}, {0, 0.9, -6}};
  d.uvs = {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}};
  const Corner face[3] = {{0, no_index, 0}, {1, no_index, 1}, {2, no_index, 2}};
  d.add_face(face, face + 3);
  Scene s = glowing_scene({1, 1, 1});
  s.objects[0].mesh = Mesh::make(d);
  s.camera.projection = Projection::perspective;
  s.camera.position = {0, 0, 4};
  TextureLayer l = layer_of(ramp());
  l.sampling.mag_filter = MagFilter::linear, l.sampling.min_filter = MinFilter::linear;
  l.perspective = false;
  s.material.layers = {l};
  const Frame frame = draw(s, view_of(side, side));
  std::array<glm::dvec2, 3> window;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec4 c = projection_matrix(s.camera, 1) * view_matrix(s.camera) * glm::dvec4(d.positions[i], 1);
    window[i] = (glm::dvec2(c) / c.w + 1.0) * (side / 2.0);
  }
  const glm::dmat2 edges(window[1] - window[0], window[2] - window[0]);
  int compared = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (!frame.covered.at(x, y)) continue;
      const glm::dvec2 w = glm::inverse(edges) * (glm::dvec2(x + 0.5, side - y - 0.5) - window[0]);
      if (w.x < 0 || w.y < 0 || w.x + w.y > 1) continue;
      for (int c = 0; c < 2; ++c) EXPECT_NEAR(frame.colour.at(x, y)[c], w[c], 2e-5);
      ++compared;
    }
  EXPECT_GT(compared, 200);
}

TEST(Layers, SlopesAreTheDerivativesOfTheWeights) {
  const WindowVertex a{3, 4, 0, 0.5f, 0, 0, 0}, b{60, 9, 0, 2.0f, 0, 0, 0}, c{20, 50, 0, 0.125f, 0, 0, 0};
  const TriangleWeights<double> weights({&a, &b, &c});
  for (const bool perspective : {false, true}) {
    TriangleWeights<double>::Slopes<double> at, left, right, below, above;
    const double h = 1e-4;
    weights.at(25.0, 20.0, perspective, at);
    weights.at(25 - h, 20.0, perspective, left), weights.at(25 + h, 20.0, perspective, right);
    weights.at(25.0, 20 - h, perspective, below), weights.at(25.0, 20 + h, perspective, above);
    EXPECT_NEAR(at.b_dx, (right.b - left.b) / (2 * h), 1e-9);
    EXPECT_NEAR(at.c_dx, (right.c - left.c) / (2 * h), 1e-9);
    EXPECT_NEAR(at.b_dy, (above.b - below.b) / (2 * h), 1e-9);
    EXPECT_NEAR(at.c_dy, (above.c - below.c) / (2 * h), 1e-9);
    const glm::dvec3 w = weights.at(25, 20);
    if (!perspective) continue;
    EXPECT_NEAR(at.b, w.y, 1e-14);
    EXPECT_NEAR(at.c, w.z, 1e-14);
  }
}

TEST(Layers, EachBlendIsItsFormula) {
  const glm::dvec3 C(0.25, 0.5, 0.75), T(0.5, 0.125, 0.875), C_c(1, 0.25, 0.5);
  const double a = 0.625;
  const glm::dvec3 one(1);
  const glm::dvec3 want[] = {T, C * T, C * (1 - a) + T * a, C * (one - T) + C_c * T, glm::min(C + T, 1.0)};
  for (std::size_t how = 0; how < 5; ++how)
    for (const double amount : {1.0, 0.5}) {
      Scene s = glowing_scene(C);
      TextureLayer l = layer_of(constant({T, a}));
      l.blend = LayerBlend(how), l.blend_colour = C_c, l.amount = amount;
      s.material.layers = {l};
      const glm::dvec3 all = LayerBlend(how) == LayerBlend::add ? C + T : want[how];
      const glm::dvec3 expected = glm::min(C + (all - C) * amount, 1.0);
      const glm::vec3 is = draw(s, view_of(8, 8)).colour.at(3, 3);
      for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(is[c], float(expected[c])) << how;
    }
}

TEST(Layers, SixteenLayersAreTheirFormula) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr LayerTarget targets[] = {LayerTarget::k_a, LayerTarget::k_d,      LayerTarget::k_s,
                                     LayerTarget::n,   LayerTarget::emission, LayerTarget::colour};
  Scene s = glowing_scene({0.1, 0.2, 0.1});
  s.shading.clamp = false;
  s.material.k_a = {0.2, 0.3, 0.4}, s.material.k_s = {0.5, 0.5, 0.5}, s.material.n = 10;
  s.lights.resize(1);
  s.lights[0].kind = LightKind::directional;
  s.lights[0].position = {0.4, 0.3, 1};
  for (unsigned i = 0; i < most_layers; ++i) {
    TextureLayer l = layer_of(noise(5, 3, i), targets[random() % 6]);
    l.blend = LayerBlend(random() % 5), l.amount = unit(random), l.scale = l.target == LayerTarget::n ? 20 : 1;
    l.matrix.turn = 360 * unit(random), l.matrix.repeat_u = 3 * unit(random);
    l.blend_colour = {unit(random), unit(random), unit(random)};
    s.material.layers.push_back(l);
  }
  const Frame frame = draw(s, view_of(side, side));
  const auto lighting = lighting_in_eye_space<double>(s, view_matrix(s.camera));
  int different = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      SurfaceNumbers<double> n{eye_material<double>(s.material, ColorMaterial::off)};
      const glm::dvec2 uv((x + 0.5) / side, (side - y - 0.5) / side);
      const auto texel = [&](const TextureLayer& l) {
        return texture_colour<double>(*l.texture, l.sampling, {TextureTransform<double>(l.matrix).point(uv)});
      };
      for (const TextureLayer& l : s.material.layers) apply(l, texel(l), n);
      glm::dvec4 C(light_point(lighting, n.material, {2 * uv.x - 1, 2 * uv.y - 1, -3}, {0, 0, 1}), 1);
      for (const TextureLayer& l : s.material.layers)
        if (l.target == LayerTarget::colour) C = layered(l, C, texel(l));
      // Frame holds floats; a pixel's centre on the line between two texels may go either way.
      double off = 0;
      for (int c = 0; c < 3; ++c) off = std::max(off, std::abs(frame.colour.at(x, y)[c] - C[c]));
      different += off > 1e-6;
    }
  EXPECT_LE(different, 4);
}

TEST(Layers, ABumpOnAPlaneHasTheAnalyticNormal) {
  constexpr int n = 128;
  Image<glm::vec4> heights(n, n);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) heights.at(x, y) = glm::vec4(0.5 + 0.5 * std::sin(2 * pi * (x + 0.5) / n));
  Scene s = glowing_scene({0, 0, 0});
  s.lights.resize(1);
  s.lights[0].kind = LightKind::directional;
  s.lights[0].position = {1, 0, 1};
  s.lights[0].ambient = s.lights[0].specular = {0, 0, 0}, s.lights[0].diffuse = {1, 1, 1};
  s.material.k_d = {1, 1, 1}, s.material.k_s = {0, 0, 0};
  TextureLayer l = layer_of(TextureImage::make(heights, Encoding::as_stored), LayerTarget::normal);
  l.scale = 0.2;
  s.material.layers = {l};
  for (const bool two_sided : {false, true}) {
    s.shading.two_sided = two_sided;
    const Frame frame = draw(s, view_of(n, n));
    for (int x = 1; x < n - 1; ++x) {
      // h(u) = s (1 + sin 2 pi u)/2, u = (x + 1)/2; a difference over a texel to each side sees a wave sin(t)/t too
      // flat.
      const double t = 2 * pi / n;
      const double slope = 0.2 * pi * std::cos(2 * pi * (x + 0.5) / n) * (std::sin(t) / t) / 2;
      const glm::dvec3 N = glm::normalize(glm::dvec3(-slope, 0, 1));
      const double want = std::max(0.0, glm::dot(N, glm::normalize(glm::dvec3(1, 0, 1))));
      EXPECT_NEAR(frame.colour.at(x, n / 2).r, want, 1e-5) << x;
    }
  }
}

TEST(Layers, BumpsNeedPixelsNormals) {
  Scene s = glowing_scene({0, 0, 0});
  s.lights.resize(1);
  s.material.k_d = {1, 1, 1};
  Scene bare = s;
  s.material.layers = {layer_of(noise(16, 16, 3), LayerTarget::normal)};
  EXPECT_GT(largest_difference(draw(s, view_of(side, side)), draw(bare, view_of(side, side))), 0.05);
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud}) {
    s.shading.mode = bare.shading.mode = mode;
    EXPECT_EQ(largest_difference(draw(s, view_of(side, side)), draw(bare, view_of(side, side))), 0);
    EXPECT_FALSE(software_technique().plan(s, view_of(side, side)).notes.empty());
  }
}

TEST(Layers, AConstantTextureIsAnotherMaterial) {
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
    for (const bool two_sided : {false, true}) {
      Scene s = scene_of(make_shape(*find_shape("torus"), 0));
      s.camera.position = {0, 1, 3};
      s.shading.mode = mode, s.shading.two_sided = two_sided;
      Scene bare = s;
      bare.material.k_d = s.material.k_d * glm::dvec3(0.5, 0.25, 0.125);
      bare.material.n = 7, bare.material.k_s = {0.5, 0.5, 0.5};
      TextureLayer n = layer_of(constant(glm::vec4(7)), LayerTarget::n);
      TextureLayer k_s = layer_of(constant(glm::vec4(0.5f)), LayerTarget::k_s);
      n.blend = k_s.blend = LayerBlend::replace;
      s.material.layers = {layer_of(constant({0.5, 0.25, 0.125, 1}), LayerTarget::k_d), n, k_s};
      EXPECT_LT(largest_difference(draw(s, view_of(side, side)), draw(bare, view_of(side, side))), 2e-7);
    }
}

TEST(Layers, AlphaTestCutsTheCircle) {
  Image<glm::u8vec4> disk(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double r = std::hypot(x - side / 2 + 0.5, y - side / 2 + 0.5);
      disk.at(x, y) = {255, 255, 255, r < side * 0.4 ? 200 : 100};
    }
  const TextureHandle picture = TextureImage::make(disk, Encoding::as_stored);
  for (const LayerTarget target : {LayerTarget::opacity, LayerTarget::colour})
    for (const int threads : {1, 3}) {
      Scene s = glowing_scene({1, 0.5, 0.25});
      s.shading.transparency = Transparency::test;
      s.shading.alpha_threshold = 0.5;
      s.objects.push_back(s.objects[0]);  // behind, without a hole
      s.objects[1].mesh = mapped_square(-0.5);
      s.objects[1].own_material = true;
      s.objects[1].material = s.material;
      s.objects[1].material.emission = {0, 0, 1};
      s.material.layers = {layer_of(picture, target)};
      View view = view_of(side, side, threads);
      view.ids = true;
      const auto check = [&](bool front_there, int behind) {
        const Frame frame = draw(s, view);
        for (int y = 0; y < side; ++y)
          for (int x = 0; x < side; ++x) {
            const bool inside = front_there && disk.at(x, side - 1 - y).a == 200;
            EXPECT_EQ(frame.object.at(x, y), inside ? 0 : behind);
            if (inside) {
              EXPECT_EQ(frame.colour.at(x, y), glm::vec3(1, 0.5, 0.25));
            }
          }
      };
      check(true, 1);
      s.objects[1].mesh = mapped_square(0);  // at the same depth the one drawn first stays
      check(true, 1);
      s.objects[1].visible = false;
      check(true, nothing);
      s.shading.alpha_threshold = picture->texel(0, side / 2, side / 2).a;  // not above
      check(false, nothing);
    }
}

TEST(Layers, ThreadsAndPrecisionChangeNothing) {
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong}) {
    Scene s = scene_of(make_shape(*find_shape("uv-sphere"), 0));
    s.camera.position = {0, 0.5, 1.3};  // something is clipped
    s.shading.mode = mode;
    s.shading.transparency = Transparency::test;
    s.shading.alpha_threshold = 0.3;
    Image<glm::u8vec4> texels(64, 32);
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 64; ++x)
        texels.at(x, y) = {127 + 120 * std::sin(x * pi / 16), 8 * y, 127 + 120 * std::cos(y * pi / 4), 255};
    TextureLayer colour = layer_of(TextureImage::make(texels, Encoding::as_stored));
    colour.sampling = {};
    TextureLayer bump = colour;
    bump.target = LayerTarget::normal, bump.scale = 0.02;
    s.material.layers = {colour, bump};
    s.shading.precision = Precision::double_precision;
    const Frame one = draw(s, view_of(200, 150)), three = draw(s, view_of(200, 150, 3));
    EXPECT_EQ(largest_difference(one, three), 0);
    EXPECT_EQ(one.depth.pixels(), three.depth.pixels());
    s.shading.precision = Precision::single_precision;
    const Frame single = draw(s, view_of(200, 150));
    std::size_t far = 0;
    for (std::size_t i = 0; i < one.colour.pixels().size(); ++i)
      far += glm::length(one.colour.pixels()[i] - single.colour.pixels()[i]) > 1e-3f;
    EXPECT_LE(far, 3u);
  }
}

TEST(Layers, NothingOfThemInASceneWithoutAny) {
  Scene s = glowing_scene({1, 1, 1});
  const auto runs = [&](const char* id) { return software_technique().plan(s, view_of(8, 8)).runs(id); };
  const auto ran = [&](const char* id) {
    const Frame frame = draw(s, view_of(8, 8));
    return std::any_of(frame.passes.begin(), frame.passes.end(), [&](const PassRun& p) { return p.id == id; });
  };
  for (const char* id : {"uv", "textures", "layers", "alpha-test"}) EXPECT_FALSE(runs(id) || ran(id)) << id;
  s.material.layers = {layer_of(noise(4, 4, 1))};
  for (const char* id : {"uv", "textures", "layers"}) EXPECT_TRUE(runs(id) && ran(id)) << id;
  EXPECT_FALSE(runs("alpha-test") || ran("alpha-test"));
  s.shading.transparency = Transparency::test;
  EXPECT_TRUE(runs("alpha-test") && ran("alpha-test"));
}

// Where eight texels are read at once they are those that are read one by one, as they are where the amount is not 1.
TEST(Layers, EightTexelsAtOnceAreTheSame) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp})
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(3, 5), glm::ivec2(64, 32)})
      for (const MinFilter filter : {MinFilter::linear, MinFilter::linear_mipmap_linear})
        for (const bool perspective : {true, false}) {
          Scene s = scene_of(make_shape(*find_shape("torus"), 0));
          s.camera.position = {0, 1, 3};
          s.shading.mode = ShadingMode::phong;
          TextureLayer l = layer_of(noise(size.x, size.y, 5));
          l.sampling = {};
          l.sampling.wrap_s = l.sampling.wrap_t = wrap, l.sampling.min_filter = filter;
          l.matrix = {2.7, -1.3, 30, -4.2, 0.3}, l.perspective = perspective;
          for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
            s.shading.precision = precision;
            s.material.layers = {l};
            const Frame eight = draw(s, view_of(100, 80));
            s.material.layers[0].amount = 1 - 1e-12;
            EXPECT_LT(largest_difference(eight, draw(s, view_of(100, 80))), 5e-7);
          }
        }
}
