#include "mapping/layout_drawing.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "params/numbers.h"

namespace cg {

std::vector<LayoutLine> layout_lines(const UvLayout& layout) {
  const UnwrapSurface surface(layout.mesh, "");
  const EdgeCuts cuts = layout_cuts(layout, surface);
  std::vector<LayoutLine> out;
  for (std::uint32_t c = 0; c < cuts.size(); ++c)
    if (surface.has_area(surface.face_of(c)) && (cuts[c] || c < surface.across(c)))
      out.push_back({layout.uv[c], layout.uv[surface.next(c)], surface.face_of(c), cuts[c] != 0});
  return out;
}

namespace {

// "M1 2L3 4": the lines of one kind, in hundredths of a pixel.
std::string path_of(const std::vector<LayoutLine>& lines, bool border, int size) {
  const auto text = [&](double v) { return number_text(std::round(v * size * 100) / 100); };
  const auto point = [&](const glm::dvec2& p) { return text(p.x) + " " + text(1 - p.y); };
  std::string out;
  glm::dvec2 last(-1);
  for (const LayoutLine& line : lines) {
    if (line.border != border) continue;
    out += line.a == last ? "L" + point(line.b) : "M" + point(line.a) + "L" + point(line.b);
    last = line.b;
  }
  return out;
}

}  // namespace

std::string layout_svg(const UvLayout& layout, int size) {
  const std::vector<LayoutLine> lines = layout_lines(layout);
  const std::string side = std::to_string(size);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + side + "\" height=\"" + side +
                    "\" viewBox=\"0 0 " + side + " " + side + "\" fill=\"none\" stroke-linecap=\"round\">\n";
  out += "<path id=\"edges\" stroke=\"#808080\" stroke-width=\"0.5\" d=\"" + path_of(lines, false, size) + "\"/>\n";
  out += "<path id=\"borders\" stroke=\"#000000\" stroke-width=\"1.5\" d=\"" + path_of(lines, true, size) + "\"/>\n";
  return out + "</svg>\n";
}

namespace {

// Darkens the pixels that a line of that width covers, by how much of each it covers about.
void draw_line(const glm::dvec2& a, const glm::dvec2& b, double width, double grey, Image<float>& out) {
  const double reach = 0.5 * width + 1;
  const auto index = [](double v, int n) { return int(std::clamp(v, 0.0, double(n))); };
  const glm::dvec2 low = glm::min(a, b) - reach, high = glm::max(a, b) + reach, along = b - a;
  const double square = std::max(glm::dot(along, along), 1e-12);
  for (int y = index(low.y, out.height()); y < index(high.y + 1, out.height()); ++y)
    for (int x = index(low.x, out.width()); x < index(high.x + 1, out.width()); ++x) {
      const glm::dvec2 p = glm::dvec2(x + 0.5, y + 0.5) - a;
      const double t = std::clamp(glm::dot(p, along) / square, 0.0, 1.0);
      const double cover = std::clamp(0.5 * width + 0.5 - glm::length(p - t * along), 0.0, std::min(width, 1.0));
      float& pixel = out.at(x, y);
      pixel = std::min(pixel, float(1 - cover * (1 - grey)));
    }
}

}  // namespace

Picture layout_picture(const UvLayout& layout, int size) {
  Image<float> brightness(size, size, 1.0f);
  const auto place = [&](const glm::dvec2& p) { return glm::dvec2(p.x, 1 - p.y) * double(size); };
  for (const LayoutLine& line : layout_lines(layout))
    draw_line(place(line.a), place(line.b), line.border ? 1.5 : 0.5, line.border ? 0 : 0.5, brightness);
  Picture out(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      out.at(x, y) = glm::u8vec4(glm::u8vec3(std::uint8_t(255 * brightness.at(x, y) + 0.5f)), 255);
  return out;
}

}  // namespace cg
