// A square that fills the picture, seen from the front without perspective, and what its layers of textures make of
// each pixel by shading/layers.h, texture_lookup.h and bump.h in double.
#pragma once
#include <random>

#include "gl_scenes.h"
#include "shading/bump.h"
#include "shading/layers.h"

namespace cg {

inline constexpr int quad_side = 256;

// uv 0..1 over the square from -1 to 1.
inline MeshHandle mapped_square_mesh() {
  MeshData d;
  d.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  d.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Corner quad[4];
  for (std::uint32_t i = 0; i < 4; ++i) quad[i] = {i, no_index, i};
  d.add_face(quad, quad + 4);
  return Mesh::make(std::move(d));
}

// Random numbers low..high of 255, alpha too.
inline TextureHandle noise_picture(int width, int height, unsigned seed, int low = 0, int high = 255) {
  std::mt19937 random(seed);
  Image<glm::u8vec4> texels(width, height);
  for (glm::u8vec4& t : texels.pixels())
    for (int c = 0; c < 4; ++c) t[c] = std::uint8_t(low + int(random() % unsigned(high - low + 1)));
  return TextureImage::make(std::move(texels), Encoding::as_stored);
}

inline Scene quad_scene() {
  Scene s = scene_with(mapped_square_mesh());
  s.camera.position = {0, 0, 3};
  s.camera.projection = Projection::orthographic;
  s.camera.height = 2;
  s.lights[0].kind = LightKind::directional;
  s.lights[0].position = {0.4, 0.3, 1};
  s.lights[0].ambient = {0.1, 0.1, 0.1};
  s.lights[0].diffuse = {0.6, 0.5, 0.4};
  s.lights[0].specular = {0.3, 0.3, 0.3};
  s.material.n = 4;
  s.shading.mode = ShadingMode::phong;
  return s;
}

// Nearest within a level, so that every number is a texel's; turned, so that no pixel's centre lies between two.
inline TextureLayer quad_layer(TextureHandle picture) {
  TextureLayer layer;
  layer.texture = std::move(picture);
  layer.sampling.mag_filter = MagFilter::nearest;
  layer.sampling.min_filter = MinFilter::nearest;
  layer.matrix.turn = 17.3;
  layer.matrix.offset_u = 0.0137;
  layer.matrix.offset_v = -0.0219;
  return layer;
}

// Of the pixel (x, y), y from the bottom: light and alpha.
inline glm::dvec4 quad_colour(const Scene& scene, int x, int y) {
  using Real = double;
  const EyeLighting<Real> lighting = lighting_in_eye_space<Real>(scene, view_matrix(scene.camera));
  SurfaceNumbers<Real> s{eye_material<Real>(scene.material, scene.shading.color_material)};
  const glm::dvec2 uv = (glm::dvec2(x, y) + 0.5) / double(quad_side);
  const Footprint<Real> pixel{uv, {1.0 / quad_side, 0}, {0, 1.0 / quad_side}};
  glm::dvec3 N(0, 0, 1);
  const auto texel = [&](const TextureLayer& l) {
    return texture_colour(*l.texture, l.sampling, TextureTransform<Real>(l.matrix).footprint(pixel));
  };
  const std::vector<const TextureLayer*> layers = counting(scene.material.layers);
  for (const TextureLayer* l : layers) {
    apply(*l, texel(*l), s);
    if (l->target != LayerTarget::normal) continue;
    const TextureTransform<Real> t(l->matrix);
    const std::array<glm::dvec3, 3> P{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
    const auto frame = tangent_frame<Real>(P, {t.point({0, 0}), t.point({1, 0}), t.point({0, 1})});
    const Real strength = l->scale * l->amount;
    if (l->bump == BumpKind::height)
      N = bumped_normal(N, *frame, height_gradient(*l->texture, l->sampling, t.point(uv)) * strength);
    else
      N = mapped_normal(N, *frame, Vec3<Real>(texel(*l)), strength);
  }
  const glm::dvec3 P((uv.x - 0.5) * 2, (uv.y - 0.5) * 2, -3);
  glm::dvec4 C(light_point(lighting, s.material, P, N), s.opacity);
  for (const TextureLayer* l : layers)
    if (l->target == LayerTarget::colour) C = layered(*l, C, texel(*l));
  return C;
}

struct QuadError {
  double largest = 0;
  int over_1 = 0, over_3 = 0, compared = 0;  // beyond 1/255 and 3/255
};

// After the display's clamp, as a screen shows it. `where`, if given: the pixels that count.
template <class Where>
QuadError against_quad(const Scene& scene, const Frame& frame, const Where& where) {
  QuadError e;
  for (int y = 0; y < quad_side; ++y)
    for (int x = 0; x < quad_side; ++x) {
      if (!where(x, y)) continue;
      const glm::dvec4 want = quad_colour(scene, x, y);
      const glm::vec3 is = frame.colour.at(x, quad_side - 1 - y);
      double off = 0;
      for (int c = 0; c < 3; ++c) off = std::max(off, std::abs(saturate(double(is[c])) - saturate(want[c])));
      e.largest = std::max(e.largest, off);
      e.over_1 += off > 1.0 / 255, e.over_3 += off > 3.0 / 255, ++e.compared;
    }
  return e;
}

inline QuadError against_quad(const Scene& scene, const Frame& frame) {
  return against_quad(scene, frame, [](int, int) { return true; });
}

}  // namespace cg
