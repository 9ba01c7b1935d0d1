// Where a line may end, in English and in Japanese: between words, and between any two characters of which one is
// Japanese, but for those that may not begin or end a line (JIS X 4051, Formatting rules for Japanese documents:
// 禁則処理).
#pragma once
#include <string_view>
#include <vector>

namespace cg {

// Whether a line may end between two characters that stand side by side. 0: the edge of the text.
bool may_break_between(char32_t before, char32_t after);

// What is not divided, as it follows the piece before it.
struct TextPiece {
  std::string_view text;      // no space in it, not empty
  bool space_before = false;  // a line that is broken here drops it
  bool may_break = false;     // a line may begin here
};

// The pieces of UTF-8 text from left to right. `before`: the character that the text follows without a space.
std::vector<TextPiece> pieces_of(std::string_view text, char32_t before = 0);

// The last character; 0 where there is none.
char32_t last_character(std::string_view text);

}  // namespace cg
