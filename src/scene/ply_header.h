// The header of a PLY file: which elements it holds, and the properties of each.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/text_scanner.h"

namespace cg {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyType type);
inline bool is_integer(PlyType type) { return type < PlyType::float32; }

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type;  // of a list: the integer type of its length
};

struct PlyElement {
  std::string name;
  std::uint64_t count;
  std::vector<PlyProperty> properties;
  long line;

  const PlyProperty* find(std::string_view property) const;
  // The fewest bytes that one of these takes.
  std::uint64_t least_bytes(PlyFormat format) const;
};

struct PlyHeader {
  PlyFormat format;
  std::vector<PlyElement> elements;  // in the order of the body
  std::size_t body;                  // the offset of the first byte behind the header
};

// Reads from the first line to end_header; `in` then stands before the body. Throws InputError, also where the counts
// need more bytes than `bytes` has.
PlyHeader read_ply_header(TextScanner& in, std::string_view bytes);

}  // namespace cg
