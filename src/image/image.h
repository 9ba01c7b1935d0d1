// Linear pixels in memory. Row 0 is the top row.
#pragma once
#include <cassert>
#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace cg {

// Leaves new pixels as the memory was, where nothing is said about them.
template <class Pixel>
struct PixelAllocator : std::allocator<Pixel> {
  template <class Other>
  struct rebind {
    using other = PixelAllocator<Other>;
  };
  void construct(Pixel* place) { ::new (static_cast<void*>(place)) Pixel; }
  template <class... Value>
  void construct(Pixel* place, Value&&... value) {
    ::new (static_cast<void*>(place)) Pixel(std::forward<Value>(value)...);
  }
};

template <class Pixel>
class Image {
 public:
  using Pixels = std::vector<Pixel, PixelAllocator<Pixel>>;
  Image() = default;
  // width, height >= 0.
  Image(int width, int height, Pixel fill = {})
      : width_(width), height_(height), pixels_(std::size_t(width) * std::size_t(height), fill) {}

  // Pixels that mean nothing yet: for who writes them all.
  static Image unwritten(int width, int height) {
    Image image;
    image.width_ = width, image.height_ = height;
    image.pixels_.resize(std::size_t(width) * std::size_t(height));
    return image;
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return pixels_.empty(); }
  std::size_t size() const { return pixels_.size(); }
  // 0 <= x < width from the left, 0 <= y < height from the top.
  Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
  const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }
  Pixel* row(int y) { return pixels_.data() + std::size_t(y) * std::size_t(width_); }
  const Pixel* row(int y) const { return pixels_.data() + std::size_t(y) * std::size_t(width_); }
  Pixels& pixels() { return pixels_; }
  const Pixels& pixels() const { return pixels_; }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  std::size_t index(int x, int y) const {
    assert(x >= 0 && y >= 0 && x < width_ && y < height_);
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
  }
  int width_ = 0, height_ = 0;
  Pixels pixels_;
};

using ColourImage = Image<glm::vec3>;  // linear RGB

}  // namespace cg
