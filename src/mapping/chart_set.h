// The charts of a mesh while automatic seams are sought: they are joined, and the seams between them straightened.
#pragma once
#include <array>

#include "mapping/flatten.h"

namespace cg {

// A chart that is a disk.
struct SeamChart {
  std::vector<std::uint32_t> faces;   // ascending; empty: joined to another chart
  std::vector<std::uint32_t> border;  // edges, one loop
  double perimeter = 0;
  double fill = 0, length = 0;  // its area over that of its box when laid flat; that box's longer side
  double worst = 1;             // quasi-conformal distortion of a triangle
};

// Edges one after the other along the border between two charts, as corners of the first.
struct SeamChain {
  std::uint32_t chart = 0, other = 0;
  std::vector<std::uint32_t> edges;
  double score = 0;  // its length over the shorter border of the two
};

// Chains that have no chart in common may be tried at the same time.
class ChartSet {
 public:
  // What `cuts` has is never opened again.
  ChartSet(const UnwrapSurface& surface, const Unwrapping& options, EdgeCuts& cuts);

  // Clusters, opened to disks and halved until each lies well.
  void begin();

  const std::vector<SeamChart>& charts() const { return charts_; }
  // Each once, named from the chart with the lower number.
  std::vector<SeamChain> chains() const;

  // Whether the two charts lie well as one: then the chain's edges are open, and `joined` is to be given to accept().
  bool try_join(const SeamChain& chain, SeamChart& joined);
  // Whether a shorter chain between the same ends parts them, both lying well: then it is cut in the old one's place.
  bool try_straighten(const SeamChain& chain, std::array<SeamChart, 2>& parts);
  void accept(std::uint32_t number, SeamChart chart);

 private:
  std::vector<std::vector<std::uint32_t>> parts_of(const std::vector<std::uint32_t>& faces) const;
  bool try_chart(const std::vector<std::uint32_t>& faces, SeamChart& chart);
  std::vector<std::uint32_t> faces_of_both(const SeamChain& chain) const;
  void add_chains(std::uint32_t number, std::vector<SeamChain>& out) const;
  bool goes_on(std::uint32_t from, std::uint32_t to) const;
  std::uint32_t chart_across(std::uint32_t corner) const;
  std::vector<std::uint32_t> slits(const ChartMesh& mesh) const;
  void set_cut(std::uint32_t corner, bool cut) { cuts_[corner] = cuts_[s_.across(corner)] = cut; }
  bool sharp(std::uint32_t corner) const;
  double length(std::uint32_t edge) const;
  double seam_cost(std::uint32_t edge) const;

  const UnwrapSurface& s_;
  const Unwrapping& options_;
  EdgeCuts& cuts_;
  const EdgeCuts fixed_;
  const std::vector<double> deficit_;     // of each position: 2 pi less the angles of its faces
  const std::vector<glm::dvec3> normal_;  // of each face
  double longest_;                        // chart that may come from joining
  std::vector<std::uint32_t> vertex_of_, chart_of_;
  std::vector<SeamChart> charts_;
};

}  // namespace cg
