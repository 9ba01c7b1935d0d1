// Formulas as the blackboard has them: italic quantities, upright vectors, indices and exponents, in colour.
#pragma once
#include <imgui.h>

#include <string_view>

namespace cg {

struct TypeSize {
  ImFont *base, *index;
  float scale = 1, index_scale = 1;  // of the fonts' own sizes
};

// Sets `markup` with its baseline at `at` and returns its width. "_" and "^" take the next letter, or a {group},
// below or above the line: "k_a", "(N·H)^n". Greek and signs are UTF-8. With no draw list it only measures.
float typeset(ImDrawList* draw, const TypeSize& size, ImVec2 at, ImU32 colour, std::string_view markup);

inline float typeset_width(const TypeSize& size, std::string_view markup) {
  return typeset(nullptr, size, {0, 0}, 0, markup);
}

// One line of text with its baseline at `at`, `scale` times as large as the font; returns its width.
float set_text(ImDrawList* draw, ImFont* font, ImVec2 at, ImU32 colour, std::string_view text, float scale = 1);
float text_width(ImFont* font, std::string_view text, float scale = 1);

}  // namespace cg
