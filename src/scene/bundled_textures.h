// The pictures of textures/: what the program ships, made by itself.
#pragma once
#include <string>
#include <vector>

#include "image/display.h"

namespace cg {

struct BundledTexture {
  std::string name;  // "brick-colour.png"
  Picture picture;   // row 0 at the top
  bool alpha = false;
  std::string origin;  // of the table in SOURCES.md
};

std::vector<BundledTexture> bundled_textures_made();

// SOURCES.md.
std::string texture_sources(const std::vector<BundledTexture>& textures);

}  // namespace cg
