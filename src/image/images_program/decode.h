// A file's bytes to pixels.
#pragma once
#include <functional>
#include <string_view>

#include "image/image_protocol.h"

namespace cg::images_program {

// Where the answer goes, piece by piece.
struct DecodeSink {
  std::function<void(const image_protocol::PictureHeader&)> picture;
  // n bytes of whole rows from row y on: float, PictureHeader::channels a pixel.
  std::function<void(int y, const float* rows, std::size_t bytes)> rows;
};

// Returns the number of pixels with a NaN or an infinity, which became 0. Without `with_pixels` only the header is
// read. Throws Refused.
std::uint64_t decode(ImageFormat format, std::string_view bytes, bool with_pixels, const DecodeSink& sink);

}  // namespace cg::images_program
