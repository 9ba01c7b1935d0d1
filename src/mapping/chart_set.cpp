#include "mapping/chart_set.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <set>

#include "mapping/automatic_seams.h"
#include "mapping/cut_to_disk.h"
#include "mapping/edge_paths.h"
#include "mapping/face_clusters.h"
#include "mapping/pack.h"
#include "mapping/parallel.h"
#include "math/transform.h"
#include "scene/polygon.h"

namespace cg {

namespace {

constexpr double bend = 0.15;    // of the first clusters: normals about 30 degrees around their mean
constexpr double compact = 0.6;  // a chart's share of its box, below which no two are joined unless one is so already
constexpr double longest_chart = 1.0;   // over the root of the whole area: longer ones leave the square half empty
constexpr double most_distorted = 1.5;  // triangle that joining may bring about

// 2 pi less the angles of the faces at each position: 0 where it can be laid flat.
std::vector<double> angle_deficits(const UnwrapSurface& s) {
  std::vector<double> out(s.mesh().data().positions.size(), 2 * pi);
  for (std::uint32_t f = 0; f < s.face_count(); ++f)
    for (std::size_t t = s.first_triangle(f); t < s.first_triangle(f + 1); ++t)
      for (int k = 0; k < 3; ++k) {
        const auto& corner = s.triangle(t);
        const glm::dvec3 p = s.point(corner[k]), a = s.point(corner[(k + 1) % 3]) - p,
                         b = s.point(corner[(k + 2) % 3]) - p;
        out[s.position_of(corner[k])] -= std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
      }
  return out;
}

std::vector<glm::dvec3> face_normals(const UnwrapSurface& s) {
  std::vector<glm::dvec3> out(s.face_count()), polygon;
  for (std::uint32_t f = 0; f < s.face_count(); ++f) {
    polygon.clear();
    for (std::uint32_t c = s.first(f); c < s.end(f); ++c) polygon.push_back(s.point(c));
    out[f] = polygon_normal(polygon);
  }
  return out;
}

double whole_area(const UnwrapSurface& s) {
  double area = 0;
  for (std::uint32_t f = 0; f < s.face_count(); ++f)
    for (std::size_t t = s.first_triangle(f); t < s.first_triangle(f + 1); ++t) {
      const auto& [a, b, c] = s.triangle(t);
      area += lay_flat(s.point(a), s.point(b), s.point(c)).area();
    }
  return area;
}

}  // namespace

ChartSet::ChartSet(const UnwrapSurface& s, const Unwrapping& options, EdgeCuts& cuts)
    : s_(s),
      options_(options),
      cuts_(cuts),
      fixed_(cuts),
      deficit_(angle_deficits(s)),
      normal_(face_normals(s)),
      longest_(longest_chart * std::sqrt(whole_area(s))),
      vertex_of_(s.corner_count()) {}

bool ChartSet::sharp(std::uint32_t corner) const { return std::abs(deficit_[s_.position_of(corner)]) > 0.6; }

double ChartSet::length(std::uint32_t edge) const { return glm::distance(s_.point(edge), s_.point(s_.next(edge))); }

// A seam is seen less where the surface bends: there it may be longer.
double ChartSet::seam_cost(std::uint32_t edge) const {
  const double cosine = glm::dot(normal_[s_.face_of(edge)], normal_[s_.face_of(s_.across(edge))]);
  return length(edge) * (1 - 0.8 * std::clamp(2 * (1 - cosine), 0.0, 1.0));  // 60 degrees and more: a fifth
}

void ChartSet::begin() {
  cut_into_clusters(s_, bend, cuts_);
  std::vector<std::vector<std::uint32_t>> waiting = charts_between(s_, cuts_).faces;
  chart_of_.assign(s_.face_count(), no_index);
  while (!waiting.empty()) {
    std::vector<SeamChart> tried(waiting.size());
    std::vector<char> well(waiting.size());
    in_parallel(waiting.size(), [&](std::size_t i) {
      cut_to_disk(s_, waiting[i], cuts_, vertex_of_);
      well[i] = try_chart(waiting[i], tried[i]);
    });
    std::vector<std::vector<std::uint32_t>> rest;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      // Those that lie well stay, the others are halved.
      if (well[i] || !cut_in_two(s_, waiting[i], cuts_)) {
        for (const std::uint32_t f : waiting[i]) chart_of_[f] = std::uint32_t(charts_.size());
        charts_.push_back(std::move(tried[i]));
      } else {
        for (auto& part : parts_of(waiting[i])) rest.push_back(std::move(part));
      }
    }
    waiting = std::move(rest);
  }
}

// The pieces into which cuts have parted the faces.
std::vector<std::vector<std::uint32_t>> ChartSet::parts_of(const std::vector<std::uint32_t>& faces) const {
  std::vector<std::vector<std::uint32_t>> out;
  std::set<std::uint32_t> left(faces.begin(), faces.end());
  while (!left.empty()) {
    std::vector<std::uint32_t> part{*left.begin()};
    left.erase(left.begin());
    for (std::size_t i = 0; i < part.size(); ++i)
      for (std::uint32_t c = s_.first(part[i]); c < s_.end(part[i]); ++c)
        if (!cuts_[c] && left.erase(s_.face_of(s_.across(c)))) part.push_back(s_.face_of(s_.across(c)));
    std::sort(part.begin(), part.end());
    out.push_back(std::move(part));
  }
  return out;
}

bool ChartSet::try_chart(const std::vector<std::uint32_t>& faces, SeamChart& chart) {
  const ChartMesh mesh = make_chart_mesh(s_, cuts_, faces, vertex_of_);
  chart.faces = faces;
  if (mesh.loops.size() != 1) return false;
  chart.border = mesh.loop_edges.front();
  chart.perimeter = 0;
  for (const std::uint32_t c : chart.border) chart.perimeter += length(c);
  if (!is_disk(mesh, faces.size())) return false;
  FlatChart flat = flatten(mesh, UnwrapMethod::lscm);
  if (!lies_well(flat, options_)) return false;
  turn_to_smallest_box(flat.flat);
  glm::dvec2 low = flat.flat.front(), high = low;
  for (const glm::dvec2& p : flat.flat) low = glm::min(low, p), high = glm::max(high, p);
  chart.fill = flat.distortion.flat_area / std::max((high.x - low.x) * (high.y - low.y), 1e-300);
  chart.length = std::max(high.x - low.x, high.y - low.y);
  chart.worst = flat.distortion.worst_quasi_conformal;
  return true;
}

void ChartSet::accept(std::uint32_t number, SeamChart chart) {
  for (const std::uint32_t f : chart.faces) chart_of_[f] = number;
  charts_[number] = std::move(chart);
}

std::uint32_t ChartSet::chart_across(std::uint32_t c) const {
  return s_.across(c) == no_index || fixed_[c] ? no_index : chart_of_[s_.face_of(s_.across(c))];
}

// A chain goes on from its last edge to the next where nothing else meets between them, on either side.
bool ChartSet::goes_on(std::uint32_t from, std::uint32_t to) const {
  if (chart_across(from) != chart_across(to) || sharp(to)) return false;
  std::uint32_t k = s_.next(s_.across(to));  // the border on the other side, from the common vertex
  while (!cuts_[k]) k = s_.next(s_.across(k));
  return k == s_.across(from);
}

// The chains along the border of a chart, to other charts of a higher number.
void ChartSet::add_chains(std::uint32_t number, std::vector<SeamChain>& out) const {
  const std::vector<std::uint32_t>& border = charts_[number].border;
  const std::size_t n = border.size(), begin = out.size();
  std::size_t start = 0;  // where a chain begins; a border that is all one chain is parted in two
  while (start < n && chart_across(border[start]) != no_index && goes_on(border[(start + n - 1) % n], border[start]))
    ++start;
  const bool all_one = start == n;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t at = (start + i) % n;
    const std::uint32_t c = border[at], other = chart_across(c);
    if (other == no_index || other <= number) continue;
    const bool begins = i == 0 || (all_one && i == n / 2) || !goes_on(border[(at + n - 1) % n], c) ||
                        out.size() == begin || out.back().other != other;
    if (begins) out.push_back({number, other, {}, 0});
    out.back().edges.push_back(c);
  }
  for (std::size_t k = begin; k < out.size(); ++k) {
    double sum = 0;
    for (const std::uint32_t c : out[k].edges) sum += length(c);
    out[k].score = sum / std::max(std::min(charts_[number].perimeter, charts_[out[k].other].perimeter), 1e-300);
  }
}

std::vector<SeamChain> ChartSet::chains() const {
  std::vector<SeamChain> out;
  for (std::uint32_t i = 0; i < charts_.size(); ++i)
    if (!charts_[i].faces.empty()) add_chains(i, out);
  return out;
}

std::vector<std::uint32_t> ChartSet::faces_of_both(const SeamChain& chain) const {
  const auto &a = charts_[chain.chart].faces, &b = charts_[chain.other].faces;
  std::vector<std::uint32_t> out;
  std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

// The edges of slits, one of each side, that can be closed from their inner ends on while the surface is flat there.
std::vector<std::uint32_t> ChartSet::slits(const ChartMesh& mesh) const {
  std::vector<std::uint32_t> kept, out;
  if (mesh.loops.size() != 1) return out;
  const std::vector<std::uint32_t>& border = mesh.loop_edges.front();
  std::size_t left = border.size();
  for (const std::uint32_t c : border) {
    if (!kept.empty() && left > 4 && s_.across(c) == kept.back() && !fixed_[c] && !sharp(c)) {
      out.push_back(c);
      kept.pop_back();
      left -= 2;
    } else {
      kept.push_back(c);
    }
  }
  return out;
}

bool ChartSet::try_join(const SeamChain& chain, SeamChart& joined) {
  const SeamChart &a = charts_[chain.chart], &b = charts_[chain.other];
  const std::vector<std::uint32_t> faces = faces_of_both(chain);
  std::vector<std::uint32_t> opened = chain.edges;
  for (const std::uint32_t c : chain.edges) set_cut(c, false);
  for (const std::uint32_t c : slits(make_chart_mesh(s_, cuts_, faces, vertex_of_))) {
    set_cut(c, false);
    opened.push_back(c);
  }
  const double least_fill = 0.95 * std::min({compact, a.fill, b.fill});
  const double longest = std::max({longest_, a.length, b.length});
  const double worst = std::max({most_distorted, a.worst, b.worst});
  if (try_chart(faces, joined) && joined.fill >= least_fill && joined.length <= longest && joined.worst <= worst)
    return true;
  for (const std::uint32_t c : opened) set_cut(c, true);
  return false;
}

bool ChartSet::try_straighten(const SeamChain& chain, std::array<SeamChart, 2>& parts) {
  const std::vector<std::uint32_t> faces = faces_of_both(chain);
  for (const std::uint32_t c : chain.edges) set_cut(c, false);
  const ChartMesh both = make_chart_mesh(s_, cuts_, faces, vertex_of_);
  const std::uint32_t from = vertex_of_[chain.edges.front()], to = vertex_of_[s_.next(chain.edges.back())];
  std::vector<char> closed(both.position.size());
  for (const auto& loop : both.loops)
    for (const std::uint32_t v : loop) closed[v] = v != from && v != to;
  const Ways ways = ways_from(inner_edges(s_, cuts_, both, vertex_of_), {from}, closed,
                              [&](std::uint32_t c) { return seam_cost(c); });
  double old_cost = 0;
  for (const std::uint32_t c : chain.edges) old_cost += seam_cost(c);
  const std::vector<std::uint32_t> way = ways.edges_to(to);
  if (!way.empty() && ways.distance[to] < 0.98 * old_cost) {
    for (const std::uint32_t c : way) set_cut(c, true);
    const auto two = parts_of(faces);
    const double worst = std::max({most_distorted, charts_[chain.chart].worst, charts_[chain.other].worst});
    if (two.size() == 2 && try_chart(two[0], parts[0]) && try_chart(two[1], parts[1]) &&
        std::max(parts[0].worst, parts[1].worst) <= worst)
      return true;
    for (const std::uint32_t c : way) set_cut(c, false);
  }
  for (const std::uint32_t c : chain.edges) set_cut(c, true);
  return false;
}

}  // namespace cg
