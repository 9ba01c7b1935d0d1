// Random numbers from a counter: the same in every run and on any number of threads, as each depends on its place
// alone. This work is based on: Guy Steele, Doug Lea, Christine Flood, Fast Splittable Pseudorandom Number Generators,
// 2014 (the mixing function); Andrew Kensler, Correlated Multi-Jittered Sampling, 2013.
#pragma once
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>

namespace cg {

// Every bit of the result depends on every bit of `z`.
constexpr std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return z ^ z >> 31;
}

// A key for the numbers of one place (a patch, a pixel) and purpose; `more` tells apart what has the same key.
constexpr std::uint64_t random_key(std::uint64_t key, std::uint64_t more) {
  return mixed(key + 0x9e3779b97f4a7c15u * (more + 1));
}

// In [0, 1).
constexpr double random_number(std::uint64_t key, std::uint64_t counter) {
  return double(random_key(key, counter) >> 11) * 0x1p-53;
}

// Where `i` goes in a permutation of 0..count-1 that `key` chooses: a walk along the cycle of a permutation of the next
// power of two.
constexpr std::uint32_t permuted(std::uint32_t i, std::uint32_t count, std::uint64_t key) {
  std::uint32_t mask = count - 1;
  for (int shift = 1; shift < 32; shift *= 2) mask |= mask >> shift;
  const auto p = std::uint32_t(key >> 32) ^ std::uint32_t(key);
  do {
    i ^= p, i *= 0xe170893d, i ^= p >> 16, i ^= (i & mask) >> 4;
    i ^= p >> 8, i *= 0x0929eb3f, i ^= p >> 23, i ^= (i & mask) >> 1;
    i *= 1 | p >> 27, i *= 0x6935fa69, i ^= (i & mask) >> 11;
    i *= 0x74dcb303, i ^= (i & mask) >> 2, i *= 0x9e501cc3, i ^= (i & mask) >> 2;
    i *= 0xc860a3df, i &= mask, i ^= i >> 5;
  } while (i >= count);
  return (i + p) % count;
}

// Point `i` of `count` in the unit square: one in each cell of a grid, and one in each column and row as fine as there
// are points. In random order, so that two sets with other keys are independent.
inline glm::dvec2 stratified_point(std::uint32_t i, std::uint32_t count, std::uint64_t key) {
  const auto columns = std::uint32_t(std::sqrt(double(count)));
  const std::uint32_t rows = (count + columns - 1) / columns;
  const std::uint32_t s = permuted(i, count, random_key(key, 0));
  const std::uint32_t x = permuted(s % columns, columns, random_key(key, 1));
  const std::uint32_t y = permuted(s / columns, rows, random_key(key, 2));
  const double in_column = (y + random_number(key, 3 + 2 * std::uint64_t(s))) / rows;
  return {(x + in_column) / columns, (s + random_number(key, 4 + 2 * std::uint64_t(s))) / count};
}

}  // namespace cg
