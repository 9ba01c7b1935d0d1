#include "ui/line_breaks.h"

#include <imgui_internal.h>

#include <algorithm>

namespace cg {
namespace {

// 行頭禁則文字: closing brackets, full stops and commas, small kana, marks that belong to what stands before.
constexpr std::u32string_view never_first =
    U"、。，．・：；？！）］｝〕〉》」』】〗〟’”»ー―～〜‐–…‥々〻ゝゞヽヾ％°℃"
    U"ぁぃぅぇぉっゃゅょゎゕゖァィゥェォッャュョヮヵヶㇰㇱㇲㇳㇴㇵㇶㇷㇸㇹㇺㇻㇼㇽㇾㇿ"
    U",.:;?!)]}%";
// 行末禁則文字: opening brackets, and marks before an amount.
constexpr std::u32string_view never_last = U"（［｛〔〈《「『【〖〝‘“«＄￥＃([{";

bool is_one_of(std::u32string_view set, char32_t c) { return set.find(c) != set.npos; }

// Kana, han, full-width forms and their punctuation.
bool is_japanese(char32_t c) {
  return (c >= 0x2e80 && c <= 0x9fff) || (c >= 0xf900 && c <= 0xfaff) || (c >= 0xff00 && c <= 0xffef) ||
         (c >= 0x20000 && c <= 0x3ffff);
}

bool is_space(char32_t c) { return c == ' ' || c == '\t' || c == '\n'; }

// The character at `at`, and where the next one begins.
char32_t character(std::string_view text, std::size_t& at) {
  unsigned c = 0;
  const int bytes = ImTextCharFromUtf8(&c, text.data() + at, text.data() + text.size());
  at += std::size_t(std::max(1, bytes));
  return c;
}

}  // namespace

bool may_break_between(char32_t before, char32_t after) {
  if (before == 0 || after == 0) return false;
  if (is_one_of(never_first, after) || is_one_of(never_last, before)) return false;
  if ((before == U'…' || before == U'―') && before == after) return false;  // two that are one mark
  return is_japanese(before) || is_japanese(after);
}

std::vector<TextPiece> pieces_of(std::string_view text, char32_t before) {
  std::vector<TextPiece> out;
  bool space = false;
  std::size_t start = 0;
  TextPiece piece;
  const auto close = [&](std::size_t end) {
    piece.text = text.substr(start, end - start);
    if (!piece.text.empty()) out.push_back(piece);
    start = end;
  };
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t here = at;
    const char32_t c = character(text, at);
    if (is_space(c)) {
      close(here);
      start = at;
      space = true;
      before = 0;
      continue;
    }
    const bool breaks = space || may_break_between(before, c);
    if (here == start || breaks) {
      close(here);
      piece = {{}, space, breaks};
    }
    space = false;
    before = c;
  }
  close(text.size());
  return out;
}

char32_t last_character(std::string_view text) {
  if (text.empty()) return 0;
  std::size_t at = text.size() - 1;
  while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80) --at;
  const char32_t c = character(text, at);
  return is_space(c) ? 0 : c;
}

}  // namespace cg
