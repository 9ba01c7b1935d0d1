#include "radiosity/seams.h"

#include <algorithm>
#include <cmath>

#include "scene/numbering.h"

namespace cg {

namespace {

using Index = std::uint32_t;

// An edge of an outline that no other of its surface has, on the line that it shares with edges of other surfaces.
struct Side {
  Index a, b;      // as the outline runs
  std::size_t at;  // of a in Outlines::vertex
  Index line = 0;
  double from = 0, to = 0;  // along the line, from < to unless it runs the other way
};

std::vector<Side> open_sides(const Outlines& outlines) {
  std::vector<Side> all, open;
  for (std::size_t e = 0; e + 1 < outlines.first.size(); ++e)
    for (std::size_t i = outlines.first[e]; i < outlines.first[e + 1]; ++i)
      all.push_back(
          {outlines.vertex[i], outlines.vertex[i + 1 < outlines.first[e + 1] ? i + 1 : outlines.first[e]], i});
  const auto low = [](const Side& s) { return std::min(s.a, s.b); };
  const auto high = [](const Side& s) { return std::max(s.a, s.b); };
  std::sort(all.begin(), all.end(), [&](const Side& s, const Side& t) {
    return low(s) != low(t) ? low(s) < low(t) : high(s) != high(t) ? high(s) < high(t) : s.at < t.at;
  });
  const auto same = [&](std::size_t i, std::size_t j) {
    return j < all.size() && low(all[i]) == low(all[j]) && high(all[i]) == high(all[j]);
  };
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!same(i, i + 1) && (i == 0 || !same(i, i - 1))) open.push_back(all[i]);
  return open;
}

// Numbers the lines on which the sides lie, told apart to a ten millionth of the scene's size.
void find_lines(const Patches& patches, std::vector<Side>& sides) {
  double extent = 0;
  for (const ElementVertex& v : patches.vertices)
    extent = std::max({extent, std::abs(v.position.x), std::abs(v.position.y), std::abs(v.position.z)});
  if (!(extent > 0)) return;
  const auto rounded = [](const glm::dvec3& v, double step) {
    return glm::dvec3(std::round(v.x / step), std::round(v.y / step), std::round(v.z / step));
  };
  Numbering directions(sides.size()), lines(sides.size());
  for (Side& s : sides) {
    const glm::dvec3 &p = patches.vertices[s.a].position, &q = patches.vertices[s.b].position;
    glm::dvec3 d = unit(q - p);
    const double sign = std::abs(d.x) > 1e-6 ? d.x : std::abs(d.y) > 1e-6 ? d.y : d.z;
    if (sign < 0) d = -d;
    const Index direction = directions(BitsAndIndex(rounded(d, 1e-7)));
    s.from = glm::dot(p, d), s.to = glm::dot(q, d);
    s.line = lines(BitsAndIndex(rounded(p - s.from * d, 1e-7 * extent), direction));
  }
}

struct OnLine {
  Index line;
  double at;
};

// Shares of a side nearer to its ends, or to each other, than this are one point.
constexpr double one_point = 1e-6;

}  // namespace

SeamedOutlines with_seams(const Patches& patches, const Outlines& outlines) {
  std::vector<Side> sides = open_sides(outlines);
  find_lines(patches, sides);
  std::vector<OnLine> ends;
  for (const Side& s : sides) ends.push_back({s.line, s.from}), ends.push_back({s.line, s.to});
  const auto before = [](const OnLine& p, const OnLine& q) { return p.line != q.line ? p.line < q.line : p.at < q.at; };
  std::sort(ends.begin(), ends.end(), before);
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) { return s.at < t.at; });

  SeamedOutlines out;
  auto side = sides.begin();
  std::vector<double> inside;
  for (std::size_t e = 0; e + 1 < outlines.first.size(); ++e) {
    for (std::size_t i = outlines.first[e]; i < outlines.first[e + 1]; ++i) {
      out.vertex.push_back(outlines.vertex[i]);
      if (side == sides.end() || side->at != i) continue;
      inside.clear();
      const double length = side->to - side->from;
      const OnLine low{side->line, std::min(side->from, side->to)}, high{side->line, std::max(side->from, side->to)};
      for (auto p = std::upper_bound(ends.begin(), ends.end(), low, before); p != ends.end() && before(*p, high); ++p)
        inside.push_back((p->at - side->from) / length);
      std::sort(inside.begin(), inside.end());
      double last = 0;
      for (const double t : inside) {
        if (t < last + one_point || t > 1 - one_point) continue;
        last = t;
        const auto seam = Index(patches.vertices.size() + out.seams.size());
        out.seams.push_back({seam, side->a, side->b, t});
        out.vertex.push_back(seam);
      }
      ++side;
    }
    out.first.push_back(Index(out.vertex.size()));
  }
  return out;
}

}  // namespace cg
