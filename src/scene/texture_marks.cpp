// Pictures that show where they are: a grid with letters, a checker, a globe with its graticule, a room's six faces.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/texture_makers.h"
#include "scene/texture_noise.h"

namespace cg {

namespace {

constexpr double pi = std::numbers::pi;

// Five columns a row, the leftmost the highest bit; seven rows from the top.
struct Glyph {
  char sign;
  std::array<unsigned char, 7> rows;
};
constexpr Glyph glyphs[] = {
    {'A', {14, 17, 17, 31, 17, 17, 17}}, {'B', {30, 17, 17, 30, 17, 17, 30}}, {'C', {14, 17, 16, 16, 16, 17, 14}},
    {'D', {30, 17, 17, 17, 17, 17, 30}}, {'E', {31, 16, 16, 30, 16, 16, 31}}, {'F', {31, 16, 16, 30, 16, 16, 16}},
    {'G', {14, 17, 16, 23, 17, 17, 14}}, {'H', {17, 17, 17, 31, 17, 17, 17}}, {'X', {17, 17, 10, 4, 10, 17, 17}},
    {'Y', {17, 17, 10, 4, 4, 4, 4}},     {'Z', {31, 1, 2, 4, 8, 16, 31}},     {'+', {0, 4, 4, 31, 4, 4, 0}},
    {'-', {0, 0, 0, 31, 0, 0, 0}},       {'1', {4, 12, 4, 4, 4, 4, 14}},      {'2', {14, 17, 1, 2, 4, 8, 31}},
    {'3', {31, 2, 4, 2, 1, 17, 14}},     {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},
    {'6', {6, 8, 16, 30, 17, 17, 14}},   {'7', {31, 1, 2, 4, 8, 8, 8}},       {'8', {14, 17, 17, 14, 17, 17, 14}},
};

// Whether (x, y), from the top left of a text whose dots are one wide, lies on it.
bool on_text(std::string_view text, double x, double y) {
  if (x < 0 || y < 0 || y >= 7) return false;
  const std::size_t place = std::size_t(x / 6);
  const int column = int(x) - int(place) * 6;
  if (place >= text.size() || column >= 5) return false;
  for (const Glyph& g : glyphs)
    if (g.sign == text[place]) return (g.rows[std::size_t(y)] >> (4 - column) & 1) != 0;
  return false;
}

glm::dvec3 hue(double h) {
  const auto channel = [&](double shift) { return 0.5 + 0.5 * std::cos(2 * pi * (h - shift)); };
  return {channel(0), channel(1.0 / 3), channel(2.0 / 3)};
}

}  // namespace

// Columns A to H from the left, rows 1 to 8 from below: where u and v grow can be read off anywhere.
glm::dvec4 uv_grid(double u, double v) {
  const int column = int(u * 8), row = int(v * 8);
  const double x = u * 8 - column, y = v * 8 - row;
  const bool edge = x < 0.03 || y < 0.03 || x > 0.97 || y > 0.97;
  const std::string text{char('A' + column), char('1' + row)};
  const bool letter = on_text(text, (x - 0.2) * 18, (0.69 - y) * 18);
  const glm::dvec3 ground = glm::mix(glm::dvec3(0.92), hue(u), 0.45) * ((column + row) % 2 == 0 ? 1.0 : 0.78);
  if (edge) return glm::dvec4(ground * 0.35, 1);
  return glm::dvec4(letter ? glm::dvec3(0.08) : ground, 1);
}

glm::dvec4 checker(double u, double v) { return glm::dvec4(glm::dvec3((int(u * 8) + int(v * 8)) % 2), 1); }

// A planet that nobody knows, in longitude and latitude: lines every 15 degrees, the equator and the first meridian
// drawn stronger. Made in space, so that it has no seam and its poles do not smear.
glm::dvec4 globe(double u, double v) {
  const double longitude = 2 * pi * (u - 0.5), latitude = pi * (v - 0.5);
  const glm::dvec3 p{std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                     std::cos(latitude) * std::cos(longitude)};
  const double height = turbulence(p * 1.7 + 8.0, 64, 6, 11) - 0.5;
  const double cold = std::abs(latitude) / (pi / 2) + 0.6 * (turbulence(p * 6.0 + 8.0, 64, 3, 12) - 0.5);
  glm::dvec3 c = height < 0
                     ? glm::mix(glm::dvec3(0.10, 0.33, 0.55), glm::dvec3(0.03, 0.10, 0.32), std::min(-9 * height, 1.0))
                     : glm::mix(glm::dvec3(0.25, 0.50, 0.18), glm::dvec3(0.55, 0.44, 0.28), std::min(9 * height, 1.0));
  if (cold > 0.84) c = glm::dvec3(0.93, 0.95, 0.97);
  const auto line = [](double angle, double width) {
    const double step = pi / 12, off = std::abs(angle / step - std::round(angle / step)) * step;
    return off < width;
  };
  const bool meridian = line(longitude, 0.006 / std::max(std::cos(latitude), 0.05)), parallel = line(latitude, 0.006);
  const bool first = std::abs(longitude) < 0.02 || std::abs(latitude) < 0.02;
  if (first) return glm::dvec4(0.85, 0.25, 0.12, 1);
  return glm::dvec4(meridian || parallel ? c * 0.55 : c, 1);
}

// What is seen from the middle of a room of 2 x 2 x 2 along the unit direction `d`: tiles below, a lamp above, four
// walls of four colours, a window on one, each with its sign.
glm::dvec4 room(const glm::dvec3& d, const std::string& sign, double s, double t) {
  const double most = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  const glm::dvec3 p = d / most;
  const double dim = 0.55 + 0.45 * (p.y + 1) / 2;  // the lamp hangs above
  glm::dvec3 c{0.8};
  if (p.y <= -0.999999) {
    const bool dark = (int(std::floor(p.x * 4)) + int(std::floor(p.z * 4))) % 2 != 0;
    c = dark ? glm::dvec3(0.35, 0.25, 0.18) : glm::dvec3(0.72, 0.62, 0.48);
  } else if (p.y >= 0.999999) {
    const double r = std::hypot(p.x, p.z);
    c = r < 0.35 ? glm::dvec3(1) : glm::dvec3(0.85) / (0.7 + r * r * 0.5);
  } else if (std::abs(p.x) >= 0.999999) {
    c = (p.x > 0 ? glm::dvec3(0.78, 0.25, 0.20) : glm::dvec3(0.22, 0.58, 0.30)) * dim;
  } else {
    c = (p.z > 0 ? glm::dvec3(0.80, 0.72, 0.45) : glm::dvec3(0.35, 0.45, 0.72)) * dim;
    const bool window = p.z < 0 && std::abs(p.x) < 0.55 && p.y > -0.15 && p.y < 0.65;
    const bool bar = std::abs(p.x) < 0.03 || std::abs(p.y - 0.25) < 0.03;
    if (window) c = bar ? glm::dvec3(0.95) : glm::mix(glm::dvec3(0.75, 0.88, 1.0), glm::dvec3(1), (p.y + 0.15) / 0.8);
  }
  if (on_text(sign, (s - 0.05) * 48, (t - 0.05) * 48)) c = glm::dvec3(0.05);
  return glm::dvec4(c, 1);
}

}  // namespace cg
