#include "image/images_program/decode.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "image/images_program/plugin.h"

namespace cg::images_program {

namespace {

// Which of the channels that are read become red, green, blue and alpha; -1 is none.
struct Channels {
  int read;  // the first so many of the file
  int red, green, blue, alpha;
};

Channels channels_of(const OIIO::ImageSpec& spec) {
  const int n = spec.nchannels, alpha = spec.alpha_channel < 4 ? spec.alpha_channel : -1;
  if (n <= 2) return {n, 0, 0, 0, alpha == 1 ? 1 : -1};
  return {std::min(n, 4), 0, 1, 2, alpha == 3 ? 3 : -1};
}

// `from` of Channels::read a pixel to `to` of three or four; returns the pixels in which something was not finite.
std::uint64_t arrange(const std::vector<float>& from, const Channels& c, std::size_t pixels, float* to) {
  std::uint64_t bad = 0;
  const auto finite = [](float v, bool& ok) {
    if (std::isfinite(v)) return v;
    ok = false;
    return 0.0f;
  };
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* p = from.data() + i * std::size_t(c.read);
    bool ok = true;
    for (int channel : {c.red, c.green, c.blue}) *to++ = finite(p[channel], ok);
    if (c.alpha >= 0) *to++ = finite(p[c.alpha], ok);
    bad += !ok;
  }
  return bad;
}

// n rows from the picture's row y on, `channels` a pixel.
void read_rows(OIIO::ImageInput& input, int y, int n, int channels, float* rows) {
  const int first = input.spec().y + y;
  if (!input.read_scanlines(0, 0, first, first + n, 0, 0, channels, OIIO::TypeDesc::FLOAT, rows) || input.has_error())
    throw Refused(Failure::pixels, input.geterror());
}

}  // namespace

std::uint64_t decode(ImageFormat format, std::string_view bytes, bool with_pixels, const DecodeSink& sink) {
  OIIO::Filesystem::IOMemReader reader(bytes.data(), bytes.size());
  const auto input = open_image(format, reader);
  const OIIO::ImageSpec spec = input->spec();
  const Channels channels = channels_of(spec);
  const int sent = channels.alpha >= 0 ? 4 : 3;
  const int bits = spec.get_int_attribute("oiio:BitsPerSample", int(spec.format.size() * 8));
  sink.picture({spec.width, spec.height, sent, spec.nchannels, bits, spec.format.is_floating_point()});
  if (!with_pixels) return 0;

  const std::size_t width = std::size_t(spec.width);
  const std::size_t row_bytes = width * std::size_t(sent) * sizeof(float);
  const int at_once = std::min(rows_at_once(row_bytes), spec.height);
  std::vector<float> read(width * std::size_t(channels.read) * std::size_t(at_once));
  const bool as_it_is = channels.read == sent && !spec.format.is_floating_point();
  std::vector<float> arranged(as_it_is ? 0 : width * std::size_t(sent) * std::size_t(at_once));
  std::uint64_t bad = 0;
  for (int y = 0; y < spec.height; y += at_once) {
    const int n = std::min(at_once, spec.height - y);
    // The TIFF reader passes over strips that it cannot decode when it reads many rows at once.
    const int step = format == ImageFormat::tiff ? 1 : n;
    for (int i = 0; i < n; i += step)
      read_rows(*input, y + i, step, channels.read, read.data() + std::size_t(i) * width * std::size_t(channels.read));
    if (!as_it_is) bad += arrange(read, channels, width * std::size_t(n), arranged.data());
    sink.rows(y, as_it_is ? read.data() : arranged.data(), row_bytes * std::size_t(n));
  }
  return bad;
}

}  // namespace cg::images_program
