// Every text that the descriptions hold, for the glyphs of the fonts.
#pragma once
#include "ui/look.h"

namespace cg {

// Notes all labels and helps of scene and settings, so that the atlas is built once and not text by text.
void note_all_texts(Glyphs& glyphs, Language language);

}  // namespace cg
