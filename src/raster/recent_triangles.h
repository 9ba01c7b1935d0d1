// The triangles that were set up last, as the next row of pixels shows most of them again.
#pragma once
#include "raster/drawing.h"

namespace cg {

template <class Triangle>
class RecentTriangles {
 public:
  // The triangle with this number: set_up() makes it where it is not one of the last.
  template <class SetUp>
  const Triangle& get(std::uint32_t id, const SetUp& set_up) {
    Entry& entry = entries_[id * 2654435769u >> (32 - bits)];  // Donald Knuth's multiplicative hash
    if (entry.id != id) entry.triangle = set_up(), entry.id = id;
    return entry.triangle;
  }

 private:
  static constexpr int bits = 7;
  struct Entry {
    std::uint32_t id = no_triangle;
    Triangle triangle{};
  };
  std::array<Entry, std::size_t(1) << bits> entries_;  // with who uses it, on the stack: less than 64 KiB
};

}  // namespace cg
