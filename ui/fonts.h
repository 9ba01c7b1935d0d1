// Finds the packaged fonts and builds ImGui's atlas of exactly the glyphs that are wanted.
#pragma once
#include <memory>
#include <string>

#include "ui/look.h"

namespace cg {

class FontFiles;

// The fonts that this machine has: asked once, kept mapped into memory.
std::shared_ptr<const FontFiles> find_fonts();

// Fills ImGui's atlas and `look.fonts` for look.scale and look.glyphs. A missing or damaged font file is replaced by
// the next best, in the end by the face that is embedded in ImGui. The texture is the back-end's business.
void build_fonts(Look& look, const FontFiles& files);

}  // namespace cg
