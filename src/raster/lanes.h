// Eight pixels of a row at once, in the vector types of GCC and Clang: a + b adds eight numbers, a < b compares them
// (-1 in the lanes where it holds, 0 in the others) and m ? a : b chooses by lane. They go by reference, as machines
// without such registers pass them in another way.
#pragma once
#include <bit>
#include <cstdint>
#include <cstring>

#include "math/vec.h"

namespace cg {

inline constexpr int lanes = 8;

template <class T>
struct LanesOf {
  typedef T Type __attribute__((vector_size(lanes * sizeof(T))));
};
template <class T>
using Lanes = typename LanesOf<T>::Type;

// 0, 1, ... 7.
template <class T>
inline constexpr Lanes<T> lane_numbers{0, 1, 2, 3, 4, 5, 6, 7};

// Which lanes, as eight bytes of one number: 0xff where `mask` is -1. Lane 0 is the lowest byte.
using LaneBytes = std::uint64_t;
inline constexpr LaneBytes one_in_each_lane = 0x0101010101010101u;
inline LaneBytes lane_bytes(const Lanes<std::int32_t>& mask) {
  static_assert(std::endian::native == std::endian::little);
  return std::bit_cast<LaneBytes>(__builtin_convertvector(mask, Lanes<std::int8_t>));
}
inline LaneBytes first_lanes(int count) { return count >= lanes ? ~LaneBytes(0) : (LaneBytes(1) << 8 * count) - 1; }
inline int lane_count(LaneBytes bytes) { return std::popcount(bytes) / 8; }
inline int first_lane(LaneBytes bytes) { return std::countr_zero(bytes) / 8; }
inline bool has_lane(LaneBytes bytes, int lane) { return (bytes >> 8 * lane & 1) != 0; }

// Calls run(value, mask) for each run of equal values in the lanes `wanted`; `mask` is -1 wherever that value stands.
template <class Run>
void for_each_run(const Lanes<std::uint32_t>& values, LaneBytes wanted, const Run& run) {
  const Lanes<std::uint32_t> left_neighbours = __builtin_shufflevector(values, values, 0, 0, 1, 2, 3, 4, 5, 6);
  // All beginnings first: the next run need not wait for this one.
  LaneBytes begins = (lane_bytes(values != left_neighbours) | ~(wanted << 8)) & wanted & one_in_each_lane;
  for (; begins != 0; begins &= begins - 1) {
    const std::uint32_t value = values[first_lane(begins)];
    run(value, Lanes<std::int32_t>(values == value));
  }
}

// Eight vectors, by component.
template <class Real>
struct LaneVectors {
  Lanes<Real> x, y, z;
};

// The mask for numbers of another size.
template <class Real>
using LaneMask = Lanes<std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>>;

// `a` in the lanes of `mask`; the others stay.
template <class Real>
void put(const Lanes<std::int32_t>& mask, const LaneVectors<Real>& a, LaneVectors<Real>& out) {
  const LaneMask<Real> m = __builtin_convertvector(mask, LaneMask<Real>);
  out.x = m ? a.x : out.x, out.y = m ? a.y : out.y, out.z = m ? a.z : out.z;
}

}  // namespace cg
