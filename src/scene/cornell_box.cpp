#include "scene/cornell_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "math/vec.h"
#include "scene/polygon.h"

namespace cg {

namespace {

using Spectrum = std::array<double, 76>;  // at 400, 404, ... 700 nm

constexpr Spectrum white{0.343, 0.445, 0.551, 0.624, 0.665, 0.687, 0.708, 0.723, 0.715, 0.710, 0.745, 0.758, 0.739,
                         0.767, 0.777, 0.765, 0.751, 0.745, 0.748, 0.729, 0.745, 0.757, 0.753, 0.750, 0.746, 0.747,
                         0.735, 0.732, 0.739, 0.734, 0.725, 0.721, 0.733, 0.725, 0.732, 0.743, 0.744, 0.748, 0.728,
                         0.716, 0.733, 0.726, 0.713, 0.740, 0.754, 0.764, 0.752, 0.736, 0.734, 0.741, 0.740, 0.732,
                         0.745, 0.755, 0.751, 0.744, 0.731, 0.733, 0.744, 0.731, 0.712, 0.708, 0.729, 0.730, 0.727,
                         0.707, 0.703, 0.729, 0.750, 0.760, 0.751, 0.739, 0.724, 0.730, 0.740, 0.737};
constexpr Spectrum green{0.092, 0.096, 0.098, 0.097, 0.098, 0.095, 0.095, 0.097, 0.095, 0.094, 0.097, 0.098, 0.096,
                         0.101, 0.103, 0.104, 0.107, 0.109, 0.112, 0.115, 0.125, 0.140, 0.160, 0.187, 0.229, 0.285,
                         0.343, 0.390, 0.435, 0.464, 0.472, 0.476, 0.481, 0.462, 0.447, 0.441, 0.426, 0.406, 0.373,
                         0.347, 0.337, 0.314, 0.285, 0.277, 0.266, 0.250, 0.230, 0.207, 0.186, 0.171, 0.160, 0.148,
                         0.141, 0.136, 0.130, 0.126, 0.123, 0.121, 0.122, 0.119, 0.114, 0.115, 0.117, 0.117, 0.118,
                         0.120, 0.122, 0.128, 0.132, 0.139, 0.144, 0.146, 0.150, 0.152, 0.157, 0.159};
constexpr Spectrum red{0.040, 0.046, 0.048, 0.053, 0.049, 0.050, 0.053, 0.055, 0.057, 0.056, 0.059, 0.057, 0.061,
                       0.061, 0.060, 0.062, 0.062, 0.062, 0.061, 0.062, 0.060, 0.059, 0.057, 0.058, 0.058, 0.058,
                       0.056, 0.055, 0.056, 0.059, 0.057, 0.055, 0.059, 0.059, 0.058, 0.059, 0.061, 0.061, 0.063,
                       0.063, 0.067, 0.068, 0.072, 0.080, 0.090, 0.099, 0.124, 0.154, 0.192, 0.255, 0.287, 0.349,
                       0.402, 0.443, 0.487, 0.513, 0.558, 0.584, 0.620, 0.606, 0.609, 0.651, 0.612, 0.610, 0.650,
                       0.638, 0.627, 0.620, 0.630, 0.628, 0.642, 0.639, 0.657, 0.639, 0.635, 0.642};

constexpr double wavelength(std::size_t i) { return 400 + 4 * double(i); }

// Published at 400, 500, 600 and 700 nm.
constexpr Spectrum light_spectrum() {
  constexpr std::array<double, 4> given{0, 8, 15.6, 18.4};
  Spectrum out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double x = (wavelength(i) - 400) / 100;
    const std::size_t k = std::min<std::size_t>(std::size_t(x), 2);
    out[i] = given[k] + (given[k + 1] - given[k]) * (x - double(k));
  }
  return out;
}

// One lobe of Wyman, Sloan and Shirley's fit: a Gaussian with a width for each side.
double lobe(double lambda, double mean, double left, double right) {
  const double x = (lambda - mean) / (lambda < mean ? left : right);
  return std::exp(-0.5 * x * x);
}

// The matching functions of linear sRGB's primaries.
glm::dvec3 matching(double l) {
  const double x =
      1.056 * lobe(l, 599.8, 37.9, 31.0) + 0.362 * lobe(l, 442.0, 16.0, 26.7) - 0.065 * lobe(l, 501.1, 20.4, 26.2);
  const double y = 0.821 * lobe(l, 568.8, 46.9, 40.5) + 0.286 * lobe(l, 530.9, 16.3, 31.1);
  const double z = 1.217 * lobe(l, 437.0, 11.8, 36.0) + 0.681 * lobe(l, 459.0, 26.0, 13.8);
  return {3.2404542 * x - 1.5371385 * y - 0.4985314 * z, -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
          0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
}

glm::dvec3 weighted_mean(const Spectrum& spectrum) {
  glm::dvec3 sum(0), weight(0);
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    const glm::dvec3 m = matching(wavelength(i));
    sum += m * spectrum[i];
    weight += m;
  }
  const glm::dvec3 mean = sum / weight;
  return glm::round(mean * 1000.0) / 1000.0;
}

// A polygon in the published millimetres, its corners as published or, where those turn the other way, reversed.
// Published x points to the left seen through the open side, and z into the box: half a turn about y.
void add_polygon(MeshData& mesh, std::vector<glm::dvec3> corners, const glm::dvec3& towards) {
  for (glm::dvec3& p : corners) p = glm::dvec3(-p.x, p.y, -p.z) / 1000.0;
  const glm::dvec3 side(-towards.x, towards.y, -towards.z);
  if (glm::dot(vector_area(corners), side) < 0) std::reverse(corners.begin(), corners.end());
  mesh.normals.push_back(unit(vector_area(corners)));
  std::vector<Corner> face;
  for (const glm::dvec3& p : corners) {
    const auto found = std::find(mesh.positions.begin(), mesh.positions.end(), p);
    face.push_back({std::uint32_t(found - mesh.positions.begin()), std::uint32_t(mesh.normals.size() - 1), no_index});
    if (found == mesh.positions.end()) mesh.positions.push_back(p);
  }
  mesh.add_face(face.data(), face.data() + face.size());
}

MeshData wall(std::vector<glm::dvec3> corners, const glm::dvec3& towards) {
  MeshData mesh;
  add_polygon(mesh, std::move(corners), towards);
  return mesh;
}

// A block on the floor under the given top; it has no underside, as published.
MeshData block(const std::array<glm::dvec3, 4>& top) {
  MeshData mesh;
  add_polygon(mesh, {top.begin(), top.end()}, {0, 1, 0});
  const glm::dvec3 centre = 0.25 * (top[0] + top[1] + top[2] + top[3]);
  for (int i = 0; i < 4; ++i) {
    const glm::dvec3 a = top[i], b = top[(i + 1) % 4];
    add_polygon(mesh, {{a.x, 0, a.z}, a, b, {b.x, 0, b.z}}, 0.5 * (a + b) - centre);
  }
  return mesh;
}

// The ceiling around the light, which lies in its plane: four quads from the ceiling's corners to the light's.
MeshData ceiling(const std::array<glm::dvec3, 4>& outer, const std::array<glm::dvec3, 4>& hole) {
  MeshData mesh;
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    add_polygon(mesh, {outer[i], outer[j], hole[j], hole[i]}, {0, -1, 0});
  }
  mesh.normals.resize(1);
  for (Corner& c : mesh.corners) c.normal = 0;
  return mesh;
}

}  // namespace

std::vector<BundledPart> cornell_parts() {
  const std::array<glm::dvec3, 4> light{{{343, 548.8, 227}, {343, 548.8, 332}, {213, 548.8, 332}, {213, 548.8, 227}}};
  const std::array<glm::dvec3, 4> above{{{556, 548.8, 0}, {556, 548.8, 559.2}, {0, 548.8, 559.2}, {0, 548.8, 0}}};
  return {
      {"floor", "white", wall({{552.8, 0, 0}, {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2}}, {0, 1, 0})},
      {"ceiling", "white", ceiling(above, light)},
      {"back-wall", "white",
       wall({{549.6, 0, 559.2}, {0, 0, 559.2}, {0, 548.8, 559.2}, {556, 548.8, 559.2}}, {0, 0, -1})},
      {"left-wall", "red", wall({{552.8, 0, 0}, {549.6, 0, 559.2}, {556, 548.8, 559.2}, {556, 548.8, 0}}, {-1, 0, 0})},
      {"right-wall", "green", wall({{0, 0, 559.2}, {0, 0, 0}, {0, 548.8, 0}, {0, 548.8, 559.2}}, {1, 0, 0})},
      {"short-block", "white", block({{{130, 165, 65}, {82, 165, 225}, {240, 165, 272}, {290, 165, 114}}})},
      {"tall-block", "white", block({{{423, 330, 247}, {265, 330, 296}, {314, 330, 456}, {472, 330, 406}}})},
      {"light", "light", wall({light.begin(), light.end()}, {0, -1, 0})},
  };
}

std::vector<BundledMaterial> cornell_materials() {
  return {{"white", weighted_mean(white), glm::dvec3(0)},
          {"red", weighted_mean(red), glm::dvec3(0)},
          {"green", weighted_mean(green), glm::dvec3(0)},
          {"light", glm::dvec3(0.78), weighted_mean(light_spectrum())}};
}

}  // namespace cg
