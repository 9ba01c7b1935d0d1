#include "mapping/layout_drawing.h"

#include <cmath>

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

}  // namespace cg
