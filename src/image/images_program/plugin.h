// OpenImageIO as this program uses it: formats by name, files as bytes in memory, no threads.
#pragma once
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <stdexcept>
#include <string>

#include "image/image_protocol.h"

namespace cg::images_program {

using namespace image_protocol;

// Why a request is refused; `what()` is the library's own words, in English.
struct Refused : std::runtime_error {
  Refused(Failure f, const std::string& detail) : std::runtime_error(detail), failure(f) {}
  Failure failure;
};

// One thread, and the limits of image_protocol.h.
void configure();

struct Plugin {
  const char* plugin;  // OpenImageIO's name
  const char* file;    // a name that its open() accepts
};
Plugin plugin_of(ImageFormat format);

// Decodes from `reader`, which must outlive it. Checks the header before anything of the picture's size is allocated.
std::unique_ptr<OIIO::ImageInput> open_image(ImageFormat format, OIIO::Filesystem::IOMemReader& reader);

}  // namespace cg::images_program
