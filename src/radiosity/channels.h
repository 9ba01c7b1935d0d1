// RGB by patch, twice: a plane a channel, so that eight patches of one channel lie side by side for a dense row of F to
// be multiplied by, and a patch's channels together, for a sparse row's.
#pragma once
#include <array>
#include <vector>

#include "math/vec.h"
#include "raster/lanes.h"

namespace cg {

// The channels of one patch, and 0.
typedef double Quad __attribute__((vector_size(4 * sizeof(double))));

class Channels {
 public:
  Channels() = default;
  explicit Channels(std::size_t size) : size_(size), quads_(size, Quad{}) {
    for (std::vector<double>& plane : planes_) plane.resize((size + lanes - 1) / lanes * lanes);
  }
  explicit Channels(const std::vector<glm::dvec3>& values) : Channels(values.size()) {
    for (std::size_t i = 0; i < size_; ++i) set(i, values[i]);
  }

  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ * sizeof(Quad) + 3 * padded_size() * sizeof(double); }
  // Its size is rounded up to whole lanes; the rest is 0.
  const double* plane(int channel) const { return planes_[std::size_t(channel)].data(); }
  std::size_t padded_size() const { return planes_[0].size(); }
  const Quad* quads() const { return quads_.data(); }
  // To be written to where the quads are not asked for.
  double* plane_alone(int channel) { return planes_[std::size_t(channel)].data(); }

  glm::dvec3 operator[](std::size_t i) const { return {planes_[0][i], planes_[1][i], planes_[2][i]}; }
  void set(std::size_t i, const glm::dvec3& v) {
    for (std::size_t c = 0; c < 3; ++c) planes_[c][i] = v[int(c)];
    quads_[i] = Quad{v.x, v.y, v.z, 0};
  }
  std::vector<glm::dvec3> vectors() const {
    std::vector<glm::dvec3> out(size_);
    for (std::size_t i = 0; i < size_; ++i) out[i] = (*this)[i];
    return out;
  }

 private:
  std::size_t size_ = 0;
  std::array<std::vector<double>, 3> planes_;
  std::vector<Quad> quads_;
};

inline double largest(const glm::dvec3& v) { return v.x > v.y ? (v.x > v.z ? v.x : v.z) : (v.y > v.z ? v.y : v.z); }

}  // namespace cg
