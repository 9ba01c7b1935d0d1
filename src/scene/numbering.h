// Numbers for values that may repeat: equal values get the same one, in the order in which they first come.
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace cg {

// What a Numbering hashes and compares: the bits of three numbers, -0 taken for 0, and an index.
struct BitsAndIndex {
  std::array<std::uint64_t, 3> bits{};
  std::uint32_t index = 0;

  explicit BitsAndIndex(const glm::dvec3& v, std::uint32_t i = 0) : index(i) {
    for (int k = 0; k < 3; ++k) bits[k] = std::bit_cast<std::uint64_t>(v[k] + 0.0);
  }
  friend bool operator==(const BitsAndIndex&, const BitsAndIndex&) = default;

  std::uint64_t hash() const {
    std::uint64_t h = index;
    for (const std::uint64_t b : bits) {
      h = (h ^ b) * 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
    return h;
  }
};

class Numbering {
 public:
  explicit Numbering(std::size_t expected) : slots_(std::bit_ceil(2 * expected + 16), none) {
    values_.reserve(expected);
  }

  std::uint32_t operator()(const BitsAndIndex& value) {
    if (2 * values_.size() >= slots_.size()) grow();
    std::uint32_t& slot = find(value);
    if (slot == none) {
      slot = std::uint32_t(values_.size());
      values_.push_back(value);
    }
    return slot;
  }
  std::size_t size() const { return values_.size(); }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;

  std::uint32_t& find(const BitsAndIndex& value) {
    std::size_t i = value.hash() & (slots_.size() - 1);
    while (slots_[i] != none && !(values_[slots_[i]] == value)) i = (i + 1) & (slots_.size() - 1);
    return slots_[i];
  }
  void grow() {
    slots_.assign(2 * slots_.size(), none);
    for (std::size_t v = 0; v < values_.size(); ++v) find(values_[v]) = std::uint32_t(v);
  }

  std::vector<BitsAndIndex> values_;
  std::vector<std::uint32_t> slots_;  // open addressing, a power of two, at most half full
};

}  // namespace cg
