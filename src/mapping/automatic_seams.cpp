// First many nearly flat charts, each halved until it lies well; then neighbours are joined along the longest common
// border while their union still lies well, each trial a conformal map of its own. Joining two disks along one chain of
// edges gives a disk. Seams so remain where the surface is curved (Lévy et al. 2002 ask for that; growing charts under
// a bound on distortion: Zhou, Snyder, Guo and Shum, Iso-charts, 2004; Sorkine, Cohen-Or, Goldenthal and Lischinski,
// Bounded-Distortion Piecewise Mesh Parameterization, 2002).
#include "mapping/automatic_seams.h"

#include <algorithm>
#include <array>
#include <set>

#include "mapping/chart_set.h"
#include "mapping/parallel.h"

namespace cg {

namespace {

using ChainName = std::array<std::size_t, 4>;

// The same charts with the same chain: while they are joined, a chart is known by its size, which only grows.
ChainName name_of(const SeamChain& c, const std::vector<SeamChart>& charts) {
  return {c.edges.front(), c.edges.size(), charts[c.chart].faces.size(), charts[c.other].faces.size()};
}

// The best chains of which no two have a chart in common and none was tried before, for as many faces as there are left
// in the budget.
std::vector<SeamChain> choose(const ChartSet& set, const std::set<ChainName>& tried, std::size_t& budget) {
  std::vector<SeamChain> chains = set.chains(), out;
  std::stable_sort(chains.begin(), chains.end(),
                   [](const SeamChain& a, const SeamChain& b) { return a.score > b.score; });
  std::vector<char> taken(set.charts().size());
  for (SeamChain& chain : chains) {
    const std::size_t cost = set.charts()[chain.chart].faces.size() + set.charts()[chain.other].faces.size();
    if (taken[chain.chart] || taken[chain.other] || cost > budget || tried.contains(name_of(chain, set.charts())))
      continue;
    taken[chain.chart] = taken[chain.other] = 1;
    budget -= cost;
    out.push_back(std::move(chain));
  }
  return out;
}

void join(ChartSet& set, std::size_t budget) {
  std::set<ChainName> failed;
  for (;;) {
    const std::vector<SeamChain> chosen = choose(set, failed, budget);
    if (chosen.empty()) return;
    std::vector<SeamChart> joined(chosen.size());
    std::vector<char> well(chosen.size());
    in_parallel(chosen.size(), [&](std::size_t i) { well[i] = set.try_join(chosen[i], joined[i]); });
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (well[i]) {
        set.accept(chosen[i].other, {});
        set.accept(chosen[i].chart, std::move(joined[i]));
      } else {
        failed.insert(name_of(chosen[i], set.charts()));
      }
    }
  }
}

void straighten(ChartSet& set, std::size_t budget) {
  std::set<ChainName> tried;
  for (;;) {
    const std::vector<SeamChain> chosen = choose(set, tried, budget);
    if (chosen.empty()) return;
    for (const SeamChain& chain : chosen) tried.insert(name_of(chain, set.charts()));
    std::vector<std::array<SeamChart, 2>> parts(chosen.size());
    std::vector<char> well(chosen.size());
    in_parallel(chosen.size(), [&](std::size_t i) { well[i] = set.try_straighten(chosen[i], parts[i]); });
    for (std::size_t i = 0; i < chosen.size(); ++i)
      if (well[i]) {
        set.accept(chosen[i].chart, std::move(parts[i][0]));
        set.accept(chosen[i].other, std::move(parts[i][1]));
      }
  }
}

}  // namespace

bool lies_well(const FlatChart& chart, const Unwrapping& options) {
  return chart.injective() && chart.distortion.mean_quasi_conformal() <= 1.1 &&
         chart.distortion.area_distortion() <= options.area_distortion;
}

void cut_automatically(const UnwrapSurface& surface, const Unwrapping& options, EdgeCuts& cuts) {
  ChartSet set(surface, options, cuts);
  set.begin();
  join(set, 110 * surface.face_count() + 100000);
  straighten(set, 10 * surface.face_count());
}

}  // namespace cg
