// The pixels of a hemicube's faces in memory: tiles of 4 x 4, sixteen pixels that a processor takes at once.
#pragma once
#include <tbb/cache_aligned_allocator.h>

#include <cstdint>

#include "radiosity/hemicube.h"

namespace cg {

// Sixteen numbers at once, in the vector types of GCC and Clang (compare raster/lanes.h). By reference, as machines
// without such registers pass them in another way.
inline constexpr int wide = 16;
template <class T>
struct WideOf {
  typedef T Type __attribute__((vector_size(wide * sizeof(T))));
};
template <class T>
using Wide = typename WideOf<T>::Type;
using WideFloats = Wide<float>;
using WideInts = Wide<std::int32_t>;
using WideItems = Wide<std::uint32_t>;

template <class T>
using CacheAligned = std::vector<T, tbb::cache_aligned_allocator<T>>;

inline constexpr int tile_side = 4;

// Which tile of a face a pixel is in, and where there. Tiles at the right and upper border may reach over it.
struct FaceTiles {
  int across, up;

  FaceTiles(HemicubeFace f, int resolution)
      : across((face_width(f, resolution) + tile_side - 1) / tile_side),
        up((face_height(f, resolution) + tile_side - 1) / tile_side) {}
  std::size_t count() const { return std::size_t(across) * std::size_t(up); }
  std::size_t tile(int x, int y) const {
    return std::size_t(y / tile_side) * std::size_t(across) + std::size_t(x / tile_side);
  }
  static int lane(int x, int y) { return y % tile_side * tile_side + x % tile_side; }
};

struct alignas(64) ItemTile {
  WideFloats nearness;  // 1 / distance along the face's axis; 0 where nothing is
  WideItems item;       // as in scene/item_drawer.h; what stands beyond the face's border means nothing
};

// The item buffers of one position.
class HemicubeItems {
 public:
  // Nothing anywhere; `resolution` is even.
  void clear(int resolution) {
    resolution_ = resolution;
    for (const HemicubeFace f : hemicube_faces)
      faces_[std::size_t(f)].assign(FaceTiles(f, resolution).count(), {WideFloats{}, WideItems{} + no_item});
  }
  int resolution() const { return resolution_; }
  ItemTile* tiles(HemicubeFace f) { return faces_[std::size_t(f)].data(); }
  const ItemTile* tiles(HemicubeFace f) const { return faces_[std::size_t(f)].data(); }
  std::uint32_t item(HemicubeFace f, int x, int y) const {
    return faces_[std::size_t(f)][FaceTiles(f, resolution_).tile(x, y)].item[FaceTiles::lane(x, y)];
  }
  // From rows of pixels, as DrawItems fills them.
  void take(const ItemFaces& faces);

 private:
  int resolution_ = 0;
  std::array<CacheAligned<ItemTile>, 5> faces_;
};

// The weights of PixelWeights in the same places, 0 beyond the border.
class TiledWeights {
 public:
  explicit TiledWeights(const PixelWeights& weights);
  int resolution() const { return resolution_; }

  // Adds what each patch's pixels count, times `share`, to its number in `sums`.
  struct Rest {
    double behind = 0, nothing = 0;  // what the backs of patches took, and what met nothing
  };
  void add(const HemicubeItems& items, double share, double* sums, Rest& rest) const;

 private:
  struct alignas(64) Tile {
    WideFloats weight;
  };
  int resolution_;
  std::array<CacheAligned<Tile>, 5> faces_;
  std::array<std::vector<double>, 5> tile_sums_;
};

}  // namespace cg
