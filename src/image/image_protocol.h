// What is said between the application and shadebench-images, over one socket: messages of a header and `size` bytes.
// Both run on one machine and are built together, so numbers are written as they lie in memory.
//
//                                       ->  ready, once, when the libraries are loaded
//   decode (format, the file's bytes)   ->  picture, rows..., done    or  failed, at any point
//   inspect (the same)                  ->  picture, done             or  failed
//   encode (EncodeOrder), rows..., end  ->  encoded (the file's bytes)  or  failed
#pragma once
#include <cstddef>
#include <cstdint>

#include "image/image_format.h"

namespace cg::image_protocol {

inline constexpr std::int64_t max_pixels = std::int64_t(256) << 20;
inline constexpr std::int32_t max_side = 1 << 20;
inline constexpr int max_channels = 16;
inline constexpr int max_megabytes = 512;                        // decoded, as stored
inline constexpr std::size_t max_file = std::size_t(640) << 20;  // bytes; leaves room beside it in the program's memory
inline constexpr std::size_t max_encoded = std::size_t(2) << 30;  // bytes of a written file: the memory limit
inline constexpr std::size_t rows_size = std::size_t(1) << 20;    // about this many bytes go in one message of rows
inline constexpr std::size_t max_detail = 400;                    // bytes of text in `failed`

constexpr bool size_allowed(std::int64_t width, std::int64_t height) {
  return width > 0 && height > 0 && width <= max_side && height <= max_side && width * height <= max_pixels;
}
// How many rows go in one message.
constexpr int rows_at_once(std::size_t row_bytes) {
  return row_bytes >= rows_size ? 1 : int(rows_size / (row_bytes ? row_bytes : 1));
}

enum class Kind : std::uint32_t {
  decode = 0x53420001,
  inspect,
  encode,
  rows,
  end,
  picture,
  done,
  encoded,
  failed,
  ready
};

enum class Failure : std::uint32_t { header, too_large, variant, pixels, memory, encoding };

struct Header {
  Kind kind;
  std::uint32_t value;  // decode, inspect: ImageFormat; failed: Failure; rows: the first row
  std::uint64_t size;   // bytes that follow
};

enum class Sample : std::uint8_t { u8, u16, half, real };

// The pixels that follow are u8 where `sample` is, else float.
struct EncodeOrder {
  std::int32_t width, height, channels;  // 3 or 4
  ImageFormat format;
  Sample sample;  // in the file
};

struct PictureHeader {
  std::int32_t width, height;
  std::int32_t channels;       // that follow, as float: 3 (RGB) or 4 (RGBA)
  std::int32_t file_channels;  // in the file
  std::int32_t bits;           // of a channel in the file
  std::int32_t floating;       // 1: the file holds floating-point numbers
};

// After `done`.
struct DoneTail {
  std::uint64_t bad_pixels;  // with a NaN or an infinity, replaced by 0
};

}  // namespace cg::image_protocol
