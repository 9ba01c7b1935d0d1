// A ramp of even steps in OKLab (Björn Ottosson, "A perceptual color space for image processing", 2020).
#include "image/ramp.h"

#include <cmath>
#include <glm/vec3.hpp>

#include "image/display.h"
#include "math/transform.h"
#include "math/vec.h"

namespace cg {

namespace {

// Lightness, chroma, hue in degrees, at equal distances; chosen inside sRGB's gamut, between them straight in OKLab.
constexpr std::array<glm::dvec3, 5> stops{
    {{0.12, 0.06, 270}, {0.33, 0.17, 290}, {0.54, 0.19, 350}, {0.745, 0.14, 55}, {0.95, 0.12, 105}}};

glm::dvec3 oklab(const glm::dvec3& stop) {
  const double h = radians(stop.z);
  return {stop.x, stop.y * std::cos(h), stop.y * std::sin(h)};
}

glm::vec3 linear_from_oklab(const glm::dvec3& c) {
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(c.x + 0.3963377774 * c.y + 0.2158037573 * c.z);
  const double m = cube(c.x - 0.1055613458 * c.y - 0.0638541728 * c.z);
  const double s = cube(c.x - 0.0894841775 * c.y - 1.2914855480 * c.z);
  return {float(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          float(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          float(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

constexpr int last = 255;

std::array<glm::u8vec4, last + 1> make_table() {
  std::array<glm::u8vec4, last + 1> table;
  for (int i = 0; i <= last; ++i) {
    const double at = double(i) / last * double(stops.size() - 1);
    const std::size_t k = std::min(std::size_t(at), stops.size() - 2);
    const double t = at - double(k);
    const glm::vec3 c = linear_from_oklab((1 - t) * oklab(stops[k]) + t * oklab(stops[k + 1]));
    const auto byte = [](float linear) { return to_8bit(srgb_from_linear(linear)); };
    table[std::size_t(i)] = {byte(c.r), byte(c.g), byte(c.b), 255};
  }
  return table;
}

}  // namespace

glm::u8vec4 ramp(double t) {
  static const std::array<glm::u8vec4, last + 1> table = make_table();
  return table[std::size_t(saturate(t) * last + 0.5)];
}

std::array<double, 5> ramp_legend(double full) { return {0, full / 4, full / 2, full * 3 / 4, full}; }

}  // namespace cg
