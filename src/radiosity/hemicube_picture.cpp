#include "radiosity/hemicube_picture.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "image/ramp.h"
#include "math/transform.h"

namespace cg {

namespace {

glm::u8vec4 opaque(const glm::dvec3& colour) {
  return {to_8bit(float(colour.r)), to_8bit(float(colour.g)), to_8bit(float(colour.b)), 255};
}

glm::dvec3 from_hue(double hue, double saturation, double value) {
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + 6 * hue, 6.0);
    return value * (1 - saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
  };
  return {channel(5), channel(3), channel(1)};
}

constexpr glm::u8vec4 clear_pixel{0, 0, 0, 0}, black{0, 0, 0, 255};

}  // namespace

// Steps of the golden ratio around the circle of hues, three kinds of brightness after each other.
glm::u8vec4 item_colour(std::uint32_t patch) {
  constexpr std::array<glm::dvec2, 3> kinds{{{0.46, 0.82}, {0.62, 0.58}, {0.26, 0.96}}};
  const glm::dvec2 kind = kinds[patch % kinds.size()];
  const double hue = patch * 0.6180339887498949;
  return opaque(from_hue(hue - std::floor(hue), kind.x, kind.y));
}

PixelColour item_colours() {
  return [](std::uint32_t item, float, const glm::dvec3&) {
    if (item == no_item) return black;
    glm::u8vec4 c = item_colour(item & ~from_behind);
    if (item & from_behind) c = {c.r / 3, c.g / 3, c.b / 3, 255};
    return c;
  };
}

PixelColour seen_colours(const Patches& patches, const std::vector<glm::dvec3>& radiosity, const Display& display) {
  const bool solved = radiosity.size() == patches.patches.size() && !radiosity.empty();
  return [&patches, &radiosity, display, solved](std::uint32_t item, float, const glm::dvec3& direction) {
    if (item >= from_behind) return black;
    const Patch& p = patches.patches[item];
    if (solved) return opaque(glm::dvec3(displayed(display, glm::vec3(radiosity[item]))));
    if (p.emission != glm::dvec3(0)) return glm::u8vec4(255);
    return opaque(p.reflectance * (0.55 + 0.45 * std::abs(glm::dot(p.normal, direction))));
  };
}

PixelColour weight_colours(double full) {
  return [full](std::uint32_t, float weight, const glm::dvec3&) { return ramp(full > 0 ? double(weight) / full : 0); };
}

double largest_delta_form_factor(int resolution) { return 4 / (pi * resolution * resolution); }

glm::ivec2 cross_place(const glm::dvec3& d, int resolution) {
  const double along_x = std::abs(d.x), along_y = std::abs(d.y);
  // Unfolded: -1..1 on the top, beyond it up to -2..2 on the sides.
  glm::dvec2 at;
  if (d.z >= along_x && d.z >= along_y)
    at = {d.x / d.z, d.y / d.z};
  else if (along_x >= along_y)
    at = {std::copysign(2 - d.z / along_x, d.x), d.y / along_x};
  else
    at = {d.x / along_y, std::copysign(2 - d.z / along_y, d.y)};
  const auto pixel = [&](double v) { return std::clamp(int((v + 2) * 0.5 * resolution), 0, 2 * resolution - 1); };
  return {pixel(at.x), pixel(-at.y)};
}

Picture cross_picture(const HemicubeView& view, const PixelColour& colour, int most) {
  const int whole = 2 * view.resolution, size = std::min(whole, std::max(most, 1));
  Picture out(size, size, clear_pixel);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const int u = int((std::int64_t(2) * x + 1) * whole / (2 * size));
      const int v = int((std::int64_t(2) * y + 1) * whole / (2 * size));
      if (const auto p = cross_pixel(u, v, view.resolution))
        out.at(x, y) = colour(view.items.at(u, v), view.weights.at(u, v), pixel_direction(view, *p));
    }
  return out;
}

Picture disc_picture(const HemicubeView& view, const PixelColour& colour, int size) {
  Picture out(size, size, clear_pixel);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const glm::dvec2 at((2 * x + 1.0) / size - 1, 1 - (2 * y + 1.0) / size);
      const double r2 = glm::dot(at, at);
      if (r2 >= 1) continue;
      const glm::dvec3 d(at, std::sqrt(1 - r2));
      const glm::ivec2 p = cross_place(d, view.resolution);
      out.at(x, y) = colour(view.items.at(p.x, p.y), view.weights.at(p.x, p.y),
                            d.x * view.frame.x + d.y * view.frame.y + d.z * view.frame.z);
    }
  return out;
}

std::vector<PatchPixels> patch_pixels(const HemicubeView& view) {
  std::uint32_t most = 0;
  for (const std::uint32_t item : view.items.pixels())
    if (item != no_item) most = std::max(most, item & ~from_behind);
  std::vector<PatchPixels> fronts(std::size_t(most) + 1), backs(std::size_t(most) + 1);
  PatchPixels nothing_met;
  for (int y = 0; y < view.items.height(); ++y)
    for (int x = 0; x < view.items.width(); ++x) {
      if (!cross_pixel(x, y, view.resolution)) continue;
      const std::uint32_t item = view.items.at(x, y);
      PatchPixels& p = item == no_item ? nothing_met : item < from_behind ? fronts[item] : backs[item & ~from_behind];
      if (p.pixels++ == 0) p.item = item, p.low = p.high = {x, y};
      p.low = glm::min(p.low, glm::ivec2(x, y)), p.high = glm::max(p.high, glm::ivec2(x, y));
      p.sum += double(view.weights.at(x, y));
    }
  std::vector<PatchPixels> out;
  for (const std::vector<PatchPixels>* side : {&fronts, &backs})
    std::copy_if(side->begin(), side->end(), std::back_inserter(out),
                 [](const PatchPixels& p) { return p.pixels > 0; });
  if (nothing_met.pixels > 0) out.push_back(nothing_met);
  return out;
}

AllWeights all_weights(int resolution) {
  const auto of = [&](PixelWeight w) { return PixelWeights(resolution, w); };
  return {of(PixelWeight::delta_form_factor), of(PixelWeight::integrated), of(PixelWeight::unweighted),
          of(PixelWeight::solid_angle), of(PixelWeight::r_squared)};
}

std::array<WeightedSum, names_of<PixelWeight>.size()> weighted_sums(const HemicubeView& view, std::uint32_t item,
                                                                    const AllWeights& weights) {
  std::array<WeightedSum, names_of<PixelWeight>.size()> out{};
  for (int y = 0; y < view.items.height(); ++y)
    for (int x = 0; x < view.items.width(); ++x) {
      const std::uint32_t seen = view.items.at(x, y);
      const auto p = cross_pixel(x, y, view.resolution);
      if (!p || seen == no_item) continue;
      for (std::size_t k = 0; k < out.size(); ++k) {
        const double w = double(weights[k](p->face, p->x, p->y));
        out[k].all += w;
        if (seen == item) out[k].item += w;
      }
    }
  return out;
}

std::vector<PixelEdge> item_outline(const HemicubeView& view, const PatchPixels& of) {
  const auto inside = [&](int x, int y) {
    return x >= of.low.x && y >= of.low.y && x <= of.high.x && y <= of.high.y && view.items.at(x, y) == of.item &&
           cross_pixel(x, y, view.resolution).has_value();
  };
  std::vector<PixelEdge> out;
  for (const bool across : {true, false}) {
    const glm::ivec2 low = across ? of.low : glm::ivec2(of.low.y, of.low.x);
    const glm::ivec2 high = across ? of.high : glm::ivec2(of.high.y, of.high.x);
    for (int line = low.y; line <= high.y + 1; ++line) {
      int begun = 0, kind = 0;  // of the line that goes on: 1 where the inside is behind it, -1 where before
      for (int at = low.x; at <= high.x + 1; ++at) {
        const bool before = across ? inside(at, line - 1) : inside(line - 1, at);
        const bool behind = across ? inside(at, line) : inside(line, at);
        const int now = int(behind) - int(before);
        if (now == kind) continue;
        if (kind != 0) out.push_back(across ? PixelEdge{begun, line, at, line} : PixelEdge{line, begun, line, at});
        begun = at, kind = now;
      }
    }
  }
  return out;
}

}  // namespace cg
