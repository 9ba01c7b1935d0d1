// The marks by which the formats are known: PNG (RFC 2083), JPEG (T.81 B.1), OpenEXR file layout, Radiance HDR, BMP,
// TGA 2.0 (no mark: its header must be plausible), Netpbm and PFM, TIFF 6.0.
#include "image/image_format.h"

#include <cctype>
#include <cstdint>

#include "params/input_error.h"

namespace cg {

namespace {

constexpr Words all_formats{"PNG, JPEG, HDR, EXR, BMP, TGA, PPM, PGM, PFM and TIFF are read",
                            "PNG・JPEG・HDR・EXR・BMP・TGA・PPM・PGM・PFM・TIFF を読めます"};

std::uint8_t byte(std::string_view bytes, std::size_t i) { return std::uint8_t(bytes[i]); }

bool is_netpbm(std::string_view b) {
  if (b.size() < 3 || b[0] != 'P') return false;
  const bool kind = (b[1] >= '1' && b[1] <= '6') || b[1] == 'f' || b[1] == 'F';
  return kind && std::isspace(byte(b, 2));
}

// Bytes 0 to 17: length of the name, colour map, image type, the map's 5 bytes, origin, width, height, depth, flags.
bool is_tga(std::string_view b) {
  if (b.size() < 18) return false;
  const int map = byte(b, 1), type = byte(b, 2), depth = byte(b, 16);
  const bool mapped = map == 1 && (type == 1 || type == 9);
  const bool colour = map <= 1 && (type == 2 || type == 10), grey = map <= 1 && (type == 3 || type == 11);
  const bool depth_fits = (mapped || grey) ? depth == 8 || depth == 16 : depth >= 15 && depth <= 32;
  return (mapped || colour || grey) && depth_fits && (byte(b, 17) & 0xc0) == 0;
}

FormatFound exr(std::string_view b) {
  constexpr unsigned tiled = 0x2, deep_or_parts = 0x18;  // of the second byte of the version
  if (b.size() < 8 || (byte(b, 5) & (tiled | deep_or_parts)))
    return {{},
            {"a tiled, deep or multi-part EXR", "タイル・ディープ・マルチパートの EXR です"},
            {"save it as one part in scanlines", "1 パートの走査線形式で保存してください"}};
  return {ImageFormat::exr, {}, {}};
}

FormatFound tga(std::string_view b) {
  if (byte(b, 1) != 0)
    return {{},
            {"a TGA with a colour map", "カラーマップ付きの TGA です"},
            {"save it in true colour", "フルカラーで保存してください"}};
  return {ImageFormat::tga, {}, {}};
}

// A cut JPEG would be read as a picture whose rest is grey.
FormatFound jpeg(std::string_view b) {
  if (b.rfind("\xff\xd9") == std::string_view::npos)
    return {
        {}, {"a JPEG that is cut short", "途中で切れた JPEG です"}, {"its end marker is missing", "終端がありません"}};
  return {ImageFormat::jpeg, {}, {}};
}

}  // namespace

FormatFound format_of_content(std::string_view bytes) {
  using namespace std::string_view_literals;
  const auto begins = [&](std::string_view mark) { return bytes.substr(0, mark.size()) == mark; };
  if (bytes.empty()) return {{}, {"is empty", "空です"}, all_formats};
  if (begins("\x89PNG\r\n\x1a\n"sv)) return {ImageFormat::png, {}, {}};
  if (begins("\xff\xd8\xff"sv)) return jpeg(bytes);
  if (begins("\x76\x2f\x31\x01"sv)) return exr(bytes);
  if (begins("#?RADIANCE"sv) || begins("#?RGBE"sv)) return {ImageFormat::hdr, {}, {}};
  if (begins("II*\0"sv) || begins("MM\0*"sv)) return {ImageFormat::tiff, {}, {}};
  if (begins("BM"sv) && bytes.size() >= 26) return {ImageFormat::bmp, {}, {}};
  if (is_netpbm(bytes)) return {ImageFormat::pnm, {}, {}};
  if (is_tga(bytes)) return tga(bytes);
  return {{}, {"not an image of a known format", "知らない形式の画像です"}, all_formats};
}

ImageFormat format_to_write(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  if (extension == ".png") return ImageFormat::png;
  if (extension == ".jpg" || extension == ".jpeg") return ImageFormat::jpeg;
  if (extension == ".exr") return ImageFormat::exr;
  if (extension == ".hdr") return ImageFormat::hdr;
  throw InputError(file.string(),
                   {"images are not written as \"" + extension + "\"", "画像は「" + extension + "」では書けません"},
                   {"use .png, .jpg, .exr or .hdr", ".png・.jpg・.exr・.hdr を使ってください"});
}

}  // namespace cg
