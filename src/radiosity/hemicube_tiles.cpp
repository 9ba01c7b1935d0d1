#include "radiosity/hemicube_tiles.h"

#include <cstring>

namespace cg {

void HemicubeItems::take(const ItemFaces& faces) {
  for (const HemicubeFace f : hemicube_faces) {
    const FaceTiles places(f, resolution_);
    const int width = face_width(f, resolution_), height = face_height(f, resolution_);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        tiles(f)[places.tile(x, y)].item[FaceTiles::lane(x, y)] =
            faces[std::size_t(f)][std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
}

TiledWeights::TiledWeights(const PixelWeights& weights) : resolution_(weights.resolution()) {
  for (const HemicubeFace f : hemicube_faces) {
    const FaceTiles places(f, resolution_);
    auto& face = faces_[std::size_t(f)];
    auto& sums = tile_sums_[std::size_t(f)];
    face.assign(places.count(), Tile{WideFloats{}});
    sums.assign(places.count(), 0);
    for (int y = 0; y < face_height(f, resolution_); ++y)
      for (int x = 0; x < face_width(f, resolution_); ++x) {
        const float w = weights(f, x, y);
        face[places.tile(x, y)].weight[FaceTiles::lane(x, y)] = w;
        sums[places.tile(x, y)] += double(w);
      }
  }
}

void TiledWeights::add(const HemicubeItems& items, double share, double* sums, Rest& rest) const {
  const auto place = [&](std::uint32_t item) -> double& {
    return item < from_behind ? sums[item] : item == no_item ? rest.nothing : rest.behind;
  };
  for (const HemicubeFace f : hemicube_faces) {
    const ItemTile* tiles = items.tiles(f);
    const auto& weights = faces_[std::size_t(f)];
    const std::vector<double>& tile_sums = tile_sums_[std::size_t(f)];
    for (std::size_t t = 0; t < weights.size(); ++t) {
      alignas(64) std::array<std::uint32_t, wide> item;
      alignas(64) std::array<float, wide> weight;
      std::memcpy(item.data(), &tiles[t].item, sizeof item);
      std::memcpy(weight.data(), &weights[t].weight, sizeof weight);
      const WideItems differ = tiles[t].item ^ item[0];
      std::array<std::uint64_t, wide / 2> any;
      std::memcpy(any.data(), &differ, sizeof any);
      if (((any[0] | any[1]) | (any[2] | any[3]) | (any[4] | any[5]) | (any[6] | any[7])) == 0) {
        place(item[0]) += share * tile_sums[t];
        continue;
      }
      for (std::size_t i = 0; i < wide; ++i) place(item[i]) += share * double(weight[i]);
    }
  }
}

}  // namespace cg
