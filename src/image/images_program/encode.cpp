#include "image/images_program/encode.h"

namespace cg::images_program {

namespace {

OIIO::TypeDesc type_of(Sample sample) {
  switch (sample) {
    case Sample::u8:
      return OIIO::TypeDesc::UINT8;
    case Sample::u16:
      return OIIO::TypeDesc::UINT16;
    case Sample::half:
      return OIIO::TypeDesc::HALF;
    case Sample::real:
      return OIIO::TypeDesc::FLOAT;
  }
  throw Refused(Failure::encoding, "");
}

bool is_linear(ImageFormat format) { return format == ImageFormat::exr || format == ImageFormat::hdr; }

}  // namespace

Encoder::Encoder(const EncodeOrder& order) : order_(order) {
  if (!size_allowed(order.width, order.height) || order.channels < 3 || order.channels > 4)
    throw Refused(Failure::encoding, "size");
  const Plugin plugin = plugin_of(order.format);
  output_ = OIIO::ImageOutput::create(plugin.plugin);
  if (!output_) throw Refused(Failure::encoding, OIIO::geterror());
  OIIO::ImageSpec spec(order.width, order.height, order.channels, type_of(order.sample));
  void* proxy = &proxy_;
  spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  spec.attribute("oiio:ColorSpace", is_linear(order.format) ? "Linear" : "sRGB");
  spec.attribute("Software", "Shadebench");
  if (order.channels == 4) spec.attribute("oiio:UnassociatedAlpha", 1);  // as it comes, not divided by alpha
  if (order.format == ImageFormat::png) spec.attribute("png:compressionLevel", 3);
  if (order.format == ImageFormat::jpeg) {
    spec.attribute("CompressionQuality", 95);
    spec.attribute("jpeg:subsampling", "4:4:4");  // the edges of saturated highlights stay sharp
  }
  if (order.format == ImageFormat::exr) {
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "");  // else the time goes in, and the same picture gives other bytes
  }
  if (!output_->open(plugin.file, spec)) throw Refused(Failure::encoding, output_->geterror());
}

void Encoder::add_rows(int y, const void* rows, std::size_t bytes) {
  const bool small = order_.sample == Sample::u8;
  const std::size_t row = std::size_t(order_.width) * std::size_t(order_.channels) * (small ? 1 : sizeof(float));
  const std::size_t n = bytes / row;
  if (y != next_row_ || n == 0 || n * row != bytes || n > std::size_t(order_.height - y))
    throw Refused(Failure::encoding, "rows");
  if (!output_->write_scanlines(y, y + int(n), 0, small ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT, rows))
    throw Refused(Failure::encoding, output_->geterror());
  next_row_ += int(n);
}

const std::vector<unsigned char>& Encoder::finish() {
  if (next_row_ != order_.height) throw Refused(Failure::encoding, "rows");
  if (!output_->close()) throw Refused(Failure::encoding, output_->geterror());
  OIIO::Filesystem::IOMemReader reader(bytes_.data(), bytes_.size());
  const OIIO::ImageSpec read = open_image(order_.format, reader)->spec();
  const bool channels =
      read.nchannels == order_.channels || order_.format == ImageFormat::gif;  // its reader adds alpha
  if (read.width != order_.width || read.height != order_.height || !channels)
    throw Refused(Failure::encoding, "verification");
  return bytes_;
}

}  // namespace cg::images_program
