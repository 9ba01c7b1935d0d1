// First many nearly flat charts, each halved until it lies well; then neighbours are joined along the longest common
// border while their union still lies well, each trial a conformal map of its own. Joining two disks along one chain of
// edges gives a disk. Seams so remain where the surface is curved (Lévy et al. 2002 ask for that; growing charts under
// a bound on distortion: Zhou, Snyder, Guo and Shum, Iso-charts, 2004; Sorkine, Cohen-Or, Goldenthal and Lischinski,
// Bounded-Distortion Piecewise Mesh Parameterization, 2002).
#include "mapping/automatic_seams.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <set>

#include "mapping/cut_to_disk.h"
#include "mapping/face_clusters.h"
#include "mapping/pack.h"
#include "mapping/parallel.h"
#include "math/transform.h"

namespace cg {

namespace {

constexpr double bend = 0.15;    // of the first clusters: normals about 30 degrees around their mean
constexpr double compact = 0.6;  // a chart's share of its box, below which no two are joined unless one is so already
constexpr double longest_chart = 1.0;  // over the root of the whole area: longer ones leave the square half empty

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

// A chain of edges, one after the other along the border of the chart that it is named from.
struct Chain {
  std::uint32_t chart, other;
  std::vector<std::uint32_t> edges;  // corners of `chart`
  double score = 0;                  // its length over the shorter border of the two
};

struct Chart {
  std::vector<std::uint32_t> faces;
  std::vector<std::uint32_t> border;  // edges, one loop
  double perimeter = 0;
  double fill = 0, length = 0;  // its area over that of its box when laid flat; that box's longer side
};

class Joiner {
 public:
  Joiner(const UnwrapSurface& s, const Unwrapping& options, EdgeCuts& cuts)
      : s_(s),
        options_(options),
        cuts_(cuts),
        fixed_(cuts),
        deficit_(angle_deficits(s)),
        vertex_of_(s.corner_count()) {}

  void run() {
    cut_into_clusters(s_, bend, cuts_);
    halve_until_well();
    double area = 0;
    for (std::uint32_t f = 0; f < s_.face_count(); ++f)
      for (std::size_t t = s_.first_triangle(f); t < s_.first_triangle(f + 1); ++t) {
        const auto& [a, b, c] = s_.triangle(t);
        area += lay_flat(s_.point(a), s_.point(b), s_.point(c)).area();
      }
    longest_ = longest_chart * std::sqrt(area);
    std::size_t budget = 16 * s_.face_count() + 100000;  // of faces in trials
    while (join_round(budget)) {
    }
  }

 private:
  // Charts that lie well go into charts_, the others into halves.
  void halve_until_well() {
    std::vector<std::vector<std::uint32_t>> waiting = charts_between(s_, cuts_).faces;
    chart_of_.assign(s_.face_count(), no_index);
    while (!waiting.empty()) {
      std::vector<Chart> tried(waiting.size());
      std::vector<char> well(waiting.size());
      in_parallel(waiting.size(), [&](std::size_t i) {
        cut_to_disk(s_, waiting[i], cuts_, vertex_of_);
        well[i] = try_chart(waiting[i], tried[i]);
      });
      std::vector<std::vector<std::uint32_t>> rest;
      for (std::size_t i = 0; i < waiting.size(); ++i) {
        if (well[i] || !cut_in_two(s_, waiting[i], cuts_)) {
          for (const std::uint32_t f : waiting[i]) chart_of_[f] = std::uint32_t(charts_.size());
          charts_.push_back(std::move(tried[i]));
        } else {
          add_parts(waiting[i], rest);
        }
      }
      waiting = std::move(rest);
    }
  }

  // The pieces into which cuts have parted the faces.
  void add_parts(const std::vector<std::uint32_t>& faces, std::vector<std::vector<std::uint32_t>>& out) const {
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
  }

  bool try_chart(const std::vector<std::uint32_t>& faces, Chart& chart) {
    const ChartMesh mesh = make_chart_mesh(s_, cuts_, faces, vertex_of_);
    chart.faces = faces;
    if (mesh.loops.size() != 1) return false;
    chart.border = mesh.loop_edges.front();
    chart.perimeter = 0;
    for (const std::uint32_t c : chart.border) chart.perimeter += glm::distance(s_.point(c), s_.point(s_.next(c)));
    if (!is_disk(mesh, faces.size())) return false;
    FlatChart flat = flatten(mesh, UnwrapMethod::lscm);
    if (!lies_well(flat, options_)) return false;
    turn_to_smallest_box(flat.flat);
    glm::dvec2 low = flat.flat.front(), high = low;
    for (const glm::dvec2& p : flat.flat) low = glm::min(low, p), high = glm::max(high, p);
    chart.fill = flat.distortion.flat_area / std::max((high.x - low.x) * (high.y - low.y), 1e-300);
    chart.length = std::max(high.x - low.x, high.y - low.y);
    return true;
  }

  bool sharp(std::uint32_t corner) const { return std::abs(deficit_[s_.position_of(corner)]) > 0.6; }

  // The chains along the border of a chart, to other charts of a higher number.
  void add_chains(std::uint32_t number, std::vector<Chain>& out) const {
    const std::vector<std::uint32_t>& border = charts_[number].border;
    const std::size_t n = border.size(), begin = out.size();
    const auto other = [&](std::uint32_t c) {
      return s_.across(c) == no_index || fixed_[c] ? no_index : chart_of_[s_.face_of(s_.across(c))];
    };
    // A chain goes on from its last edge to the next where nothing else meets between them, on either side.
    const auto goes_on = [&](std::uint32_t from, std::uint32_t to) {
      if (other(from) != other(to) || sharp(to)) return false;
      std::uint32_t k = s_.next(s_.across(to));  // the border on the other side, from the common vertex
      while (!cuts_[k]) k = s_.next(s_.across(k));
      return k == s_.across(from);
    };
    std::size_t start = 0;  // where a chain begins; a border that is all one chain is parted in two
    while (start < n && other(border[start]) != no_index && goes_on(border[(start + n - 1) % n], border[start]))
      ++start;
    const bool all_one = start == n;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t at = (start + i) % n;
      const std::uint32_t c = border[at];
      if (other(c) == no_index || other(c) <= number) continue;
      const bool begins = i == 0 || (all_one && i == n / 2) || !goes_on(border[(at + n - 1) % n], c) ||
                          out.size() == begin || out.back().other != other(c);
      if (begins) out.push_back({number, other(c), {}, 0});
      out.back().edges.push_back(c);
    }
    for (std::size_t k = begin; k < out.size(); ++k) {
      double length = 0;
      for (const std::uint32_t c : out[k].edges) length += glm::distance(s_.point(c), s_.point(s_.next(c)));
      out[k].score = length / std::max(std::min(charts_[number].perimeter, charts_[out[k].other].perimeter), 1e-300);
    }
  }

  // Tries the best pairs of charts that do not meet each other; false where there are none left to try.
  bool join_round(std::size_t& budget) {
    std::vector<Chain> chains;
    for (std::uint32_t i = 0; i < charts_.size(); ++i)
      if (!charts_[i].faces.empty()) add_chains(i, chains);
    std::stable_sort(chains.begin(), chains.end(), [](const Chain& a, const Chain& b) { return a.score > b.score; });
    std::vector<char> taken(charts_.size());
    std::vector<const Chain*> chosen;
    for (const Chain& chain : chains) {
      const std::size_t cost = charts_[chain.chart].faces.size() + charts_[chain.other].faces.size();
      if (taken[chain.chart] || taken[chain.other] || cost > budget || failed_.contains(name_of(chain))) continue;
      taken[chain.chart] = taken[chain.other] = 1;
      budget -= cost;
      chosen.push_back(&chain);
    }
    std::vector<Chart> joined(chosen.size());
    std::vector<char> well(chosen.size());
    in_parallel(chosen.size(), [&](std::size_t i) { well[i] = try_join(*chosen[i], joined[i]); });
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (!well[i]) {
        failed_.insert(name_of(*chosen[i]));
        continue;
      }
      for (const std::uint32_t f : charts_[chosen[i]->other].faces) chart_of_[f] = chosen[i]->chart;
      charts_[chosen[i]->chart] = std::move(joined[i]);
      charts_[chosen[i]->other] = {};
    }
    return !chosen.empty();
  }

  // The same charts with the same chain: a chart is known by its size, which only grows.
  std::array<std::size_t, 4> name_of(const Chain& c) const {
    return {c.edges.front(), c.edges.size(), charts_[c.chart].faces.size(), charts_[c.other].faces.size()};
  }

  bool try_join(const Chain& chain, Chart& joined) {
    std::vector<std::uint32_t> opened;
    const auto open = [&](std::uint32_t c) {
      cuts_[c] = cuts_[s_.across(c)] = 0;
      opened.push_back(c);
    };
    std::vector<std::uint32_t> faces;
    std::merge(charts_[chain.chart].faces.begin(), charts_[chain.chart].faces.end(), charts_[chain.other].faces.begin(),
               charts_[chain.other].faces.end(), std::back_inserter(faces));
    for (const std::uint32_t c : chain.edges) open(c);
    close_slits(make_chart_mesh(s_, cuts_, faces, vertex_of_), open);
    const double least_fill = std::min({compact, charts_[chain.chart].fill, charts_[chain.other].fill});
    const double longest = std::max({longest_, charts_[chain.chart].length, charts_[chain.other].length});
    if (try_chart(faces, joined) && joined.fill >= 0.95 * least_fill && joined.length <= longest) return true;
    for (const std::uint32_t c : opened) cuts_[c] = cuts_[s_.across(c)] = 1;
    return false;
  }

  // Closes slits from their inner ends on, while the surface is flat there.
  template <class Open>
  void close_slits(const ChartMesh& mesh, const Open& open) const {
    if (mesh.loops.size() != 1) return;
    std::vector<std::uint32_t> kept;
    const std::vector<std::uint32_t>& border = mesh.loop_edges.front();
    std::size_t left = border.size();
    for (const std::uint32_t c : border) {
      if (!kept.empty() && left > 4 && s_.across(c) == kept.back() && !fixed_[c] && !sharp(c)) {
        open(c);
        kept.pop_back();
        left -= 2;
      } else {
        kept.push_back(c);
      }
    }
  }

  const UnwrapSurface& s_;
  const Unwrapping& options_;
  EdgeCuts& cuts_;
  const EdgeCuts fixed_;  // what was cut before
  const std::vector<double> deficit_;
  std::vector<std::uint32_t> vertex_of_, chart_of_;
  std::vector<Chart> charts_;
  std::set<std::array<std::size_t, 4>> failed_;
  double longest_ = 0;
};

}  // namespace

bool lies_well(const FlatChart& chart, const Unwrapping& options) {
  return chart.injective() && chart.distortion.mean_quasi_conformal() <= 1.1 &&
         chart.distortion.area_distortion() <= options.area_distortion;
}

void cut_automatically(const UnwrapSurface& surface, const Unwrapping& options, EdgeCuts& cuts) {
  Joiner(surface, options, cuts).run();
}

}  // namespace cg
