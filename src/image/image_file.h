// Image files, read and written through shadebench-images.
#pragma once
#include "image/display.h"
#include "image/image_program.h"

namespace cg {

struct ImageInfo {
  int width = 0, height = 0;
  int channels = 0;       // in the file: 1 grey, 2 grey and alpha, 3, 4, ...
  int bits = 0;           // of a channel
  bool floating = false;  // floating-point: linear light; else 0..1, nearly always sRGB
};

struct FileImage {
  ImageInfo info;
  ColourImage colour;          // as stored, not converted; a grey image has three equal channels
  Image<float> alpha;          // 0..1 as stored; empty where the file has none
  std::size_t bad_pixels = 0;  // with a NaN or an infinity, replaced by 0
};

// Reads a PNG, JPEG, HDR, EXR, BMP, TGA, PPM, PGM, PFM or TIFF, known by its content, of at most 256 megapixels. Throws
// InputError that names the file; any file at all gives one or the other within the program's limit.
FileImage read_image(const std::filesystem::path& file, ImageProgram& program = ImageProgram::shared());
ImageInfo inspect_image(const std::filesystem::path& file, ImageProgram& program = ImageProgram::shared());

// What a channel takes: PNG 8 or 16 bits, EXR half or float; JPEG (8) and HDR (shared exponent) have one kind only.
enum class Depth { standard, high };

// Writes linear light by the name's extension, complete or not at all (save_file): .png and .jpg after the display
// transform, .exr and .hdr as it is. Throws InputError that names the file.
void write_image(const std::filesystem::path& file, const ColourImage& linear, const Display& display,
                 Depth depth = Depth::standard, ImageProgram& program = ImageProgram::shared());

// Writes what a screen shows: .png or .jpg. Alpha is not written.
void write_image(const std::filesystem::path& file, const Picture& picture,
                 ImageProgram& program = ImageProgram::shared());
// The same with its alpha, and colour as it is, not multiplied by it: .png.
void write_image_with_alpha(const std::filesystem::path& file, const Picture& picture,
                            ImageProgram& program = ImageProgram::shared());

// The bytes of what write_image() would save, or of a GIF with one frame. `file` is named in errors.
std::string encode_image(const std::filesystem::path& file, ImageFormat format, const Picture& picture,
                         ImageProgram& program = ImageProgram::shared());

}  // namespace cg
