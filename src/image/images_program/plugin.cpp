#include "image/images_program/plugin.h"

namespace cg::images_program {

void configure() {
  OIIO::attribute("threads", 1);
  OIIO::attribute("exr_threads", -1);  // none
  OIIO::attribute("limits:imagesize_MB", max_megabytes);
  OIIO::attribute("limits:channels", max_channels);
}

Plugin plugin_of(ImageFormat format) {
  switch (format) {
    case ImageFormat::png:
      return {"png", "image.png"};
    case ImageFormat::jpeg:
      return {"jpeg", "image.jpg"};
    case ImageFormat::exr:
      return {"openexr", "image.exr"};
    case ImageFormat::hdr:
      return {"hdr", "image.hdr"};
    case ImageFormat::bmp:
      return {"bmp", "image.bmp"};
    case ImageFormat::tga:
      return {"targa", "image.tga"};
    case ImageFormat::pnm:
      return {"pnm", "image.ppm"};
    case ImageFormat::tiff:
      return {"tiff", "image.tif"};
    case ImageFormat::gif:
      return {"gif", "image.gif"};
  }
  throw Refused(Failure::header, "");
}

namespace {

void check(const OIIO::ImageSpec& spec) {
  if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0) throw Refused(Failure::header, "");
  const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height);
  if (!size_allowed(spec.width, spec.height)) throw Refused(Failure::too_large, size);
  if (spec.nchannels > max_channels) throw Refused(Failure::too_large, std::to_string(spec.nchannels) + " channels");
  if (spec.image_bytes(true) > OIIO::imagesize_t(max_megabytes) << 20)
    throw Refused(Failure::too_large, size + " x " + std::to_string(spec.nchannels) + " channels");
  if (spec.tile_width || spec.depth > 1 || spec.deep) throw Refused(Failure::variant, "tiles, volume or deep");
  constexpr int separated = 5;
  if (spec.get_int_attribute("tiff:PhotometricInterpretation") == separated) throw Refused(Failure::variant, "CMYK");
}

}  // namespace

std::unique_ptr<OIIO::ImageInput> open_image(ImageFormat format, OIIO::Filesystem::IOMemReader& reader) {
  const Plugin plugin = plugin_of(format);
  auto input = OIIO::ImageInput::create(plugin.plugin);
  if (!input) throw Refused(Failure::header, OIIO::geterror());
  OIIO::ImageSpec spec, wishes;
  void* proxy = &reader;
  wishes.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  wishes.attribute("oiio:UnassociatedAlpha", 1);  // colour as it is stored, not multiplied by alpha
  if (!input->open(plugin.file, spec, wishes)) {
    const std::string why = input->geterror();
    if (why.find("limits:") != std::string::npos) throw Refused(Failure::too_large, "");
    throw Refused(Failure::header, why);
  }
  check(input->spec());
  return input;
}

}  // namespace cg::images_program
