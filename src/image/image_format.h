// The image file formats, told apart by what is in a file, never by its name.
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "params/words.h"

namespace cg {

// GIF is only written, and only one frame of it (image/gif_animation.h).
enum class ImageFormat : unsigned char { png, jpeg, exr, hdr, bmp, tga, pnm, tiff, gif };

// The format of a file that begins with these bytes, or why it is not read: an unknown format, or a variant whose
// readers are not safe (colour-mapped TGA, tiled or deep EXR).
struct FormatFound {
  std::optional<ImageFormat> format;
  Words refused, accepted;  // where there is no format
};
FormatFound format_of_content(std::string_view bytes);

// The format that a file of this name is written in: .png .jpg .jpeg .exr .hdr. Throws InputError for any other.
ImageFormat format_to_write(const std::filesystem::path& file);

}  // namespace cg
