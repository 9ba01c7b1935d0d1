// A square that fills the picture and pictures to lay on it.
#pragma once
#include <random>

#include "pictures.h"
#include "shading/layers.h"

namespace cg::testing {

inline constexpr int side = 64;

inline View view_of(int width, int height, int threads = 1) {
  View view;
  view.width = width, view.height = height, view.threads = threads;
  return view;
}

// uv 0..1 over the square from -1 to 1, at the height z.
inline MeshHandle mapped_square(double z = 0) {
  MeshData d;
  d.positions = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
  d.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Corner quad[4];
  for (std::uint32_t i = 0; i < 4; ++i) quad[i] = {i, no_index, i};
  d.add_face(quad, quad + 4);
  return Mesh::make(std::move(d));
}

// The square fills the picture, seen from the front; it gives off `light` and nothing else.
inline Scene glowing_scene(const glm::dvec3& light) {
  Scene s = scene_of(mapped_square());
  s.camera.position = {0, 0, 3};
  s.camera.projection = Projection::orthographic;
  s.camera.height = 2;
  s.lights.clear();
  s.material.k_a = {0, 0, 0};
  s.material.emission = light;
  s.shading.mode = ShadingMode::phong;
  return s;
}

inline TextureLayer layer_of(TextureHandle picture, LayerTarget target = LayerTarget::colour) {
  TextureLayer l;
  l.texture = std::move(picture);
  l.target = target;
  l.sampling.mag_filter = MagFilter::nearest;
  l.sampling.min_filter = MinFilter::nearest;
  return l;
}

inline TextureHandle constant(const glm::vec4& v) {
  return TextureImage::make(Image<glm::vec4>(1, 1, v), Encoding::as_stored);
}

inline TextureHandle noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image<glm::u8vec4> texels(width, height);
  for (glm::u8vec4& t : texels.pixels())
    for (int c = 0; c < 4; ++c) t[c] = std::uint8_t(random() % 256);
  return TextureImage::make(std::move(texels), Encoding::as_stored);
}

// Between the two texels' centres the colour is (u - 1/4) / (1/2), and v in the same way.
inline TextureHandle ramp() {
  Image<glm::vec4> texels(2, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x) texels.at(x, y) = {x, y, 0, 1};
  return TextureImage::make(std::move(texels), Encoding::as_stored);
}

inline double largest_difference(const Frame& a, const Frame& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.colour.pixels().size(); ++i)
    for (int c = 0; c < 3; ++c)
      most = std::max(most, double(std::abs(a.colour.pixels()[i][c] - b.colour.pixels()[i][c])));
  return most;
}

}  // namespace cg::testing
