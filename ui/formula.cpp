#include "ui/formula.h"

#include <cfloat>
#include <cmath>

namespace cg {

float text_width(ImFont* font, std::string_view text, float scale) {
  if (text.empty()) return 0;
  return font->CalcTextSizeA(font->FontSize * scale, FLT_MAX, 0, text.data(), text.data() + text.size()).x;
}

float set_text(ImDrawList* draw, ImFont* font, ImVec2 at, ImU32 colour, std::string_view text, float scale) {
  if (text.empty()) return 0;
  if (draw)
    draw->AddText(font, font->FontSize * scale, {std::floor(at.x), std::floor(at.y - font->Ascent * scale)}, colour,
                  text.data(), text.data() + text.size());
  return text_width(font, text, scale);
}

namespace {

std::size_t bytes_of_letter(std::string_view s) {
  std::size_t n = s.empty() ? 0 : 1;
  while (n < s.size() && (static_cast<unsigned char>(s[n]) & 0xc0) == 0x80) ++n;
  return n;
}

// What follows a "_" or "^" at the start of `s`: the group in braces, or one letter. Removes it from `s`.
std::string_view take_group(std::string_view& s) {
  s.remove_prefix(1);
  if (!s.empty() && s[0] == '{') {
    const std::size_t close = std::min(s.find('}'), s.size());
    const std::string_view group = s.substr(1, close - 1);
    s.remove_prefix(std::min(close + 1, s.size()));
    return group;
  }
  const std::size_t n = bytes_of_letter(s);
  const std::string_view group = s.substr(0, n);
  s.remove_prefix(n);
  return group;
}

}  // namespace

float typeset(ImDrawList* draw, const TypeSize& size, ImVec2 at, ImU32 colour, std::string_view markup) {
  const float start = at.x;
  const float em = size.base->FontSize * size.scale, index_scale = size.scale * size.index_scale;
  while (!markup.empty()) {
    if (markup[0] == '_' || markup[0] == '^') {
      const float shift = markup[0] == '_' ? 0.16f * em : -0.30f * em;
      at.x += set_text(draw, size.index, {at.x, at.y + shift}, colour, take_group(markup), index_scale) + 0.04f * em;
    } else {
      const std::string_view run = markup.substr(0, markup.find_first_of("_^"));
      at.x += set_text(draw, size.base, at, colour, run, size.scale);
      markup.remove_prefix(run.size());
    }
  }
  return at.x - start;
}

}  // namespace cg
