// Finds the packaged fonts and builds ImGui's atlas of exactly the glyphs that are wanted.
#pragma once
#include <array>
#include <memory>
#include <string>

#include "ui/look.h"

namespace cg {

class FontFiles;

// The fonts that this machine has: asked once, kept mapped into memory.
std::shared_ptr<const FontFiles> find_fonts();

// An atlas, the fonts in it, and what it reads while it lives.
struct BuiltFonts {
  std::unique_ptr<ImFontAtlas> atlas;
  Fonts fonts;
  float scale = 0;
  std::array<ImVector<ImWchar>, 3> ranges;
};

// Builds an atlas for `scale` and the points `wanted`; ASCII and Latin are always there. A missing or damaged font file
// is replaced by the next best, in the end by the face that is embedded in ImGui. Needs neither ImGui's context nor
// OpenGL, so it may run on any thread (it takes a tenth of a second with Japanese); the texture is the back-end's
// business.
std::unique_ptr<BuiltFonts> build_fonts(float scale, const std::unordered_set<ImWchar>& wanted, const FontFiles& files);

}  // namespace cg
