// What the writer and the reader of solution files share.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace cg::solution_format {

inline constexpr std::string_view title = "comment Shadebench radiosity solution, version 1\n";

// Sixteen digits each, so that they can be filled in when all else is written; the checksum is taken with zeros for
// its own.
inline constexpr std::size_t digits = 16;
inline constexpr std::string_view size_key = "comment bytes ", checksum_key = "comment checksum ",
                                  geometry_key = "comment geometry ", parameters_key = "comment radiosity ",
                                  figures_key = "comment figures ", end = "end_header\n";

// The elements and properties of the header.
std::string layout(std::uint64_t vertices, std::uint64_t faces, std::uint64_t patches);

std::string hexadecimal(std::uint64_t v);
std::uint64_t checksum(std::string_view bytes);

}  // namespace cg::solution_format
