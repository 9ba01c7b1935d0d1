#include "ui/line_breaks.h"

#include <gtest/gtest.h>

#include "workbench/formula_colours.h"

namespace cg {
namespace {

// The text with | where a line may end.
std::string marked(std::string_view text) {
  std::string out;
  for (const TextPiece& piece : pieces_of(text)) {
    if (!out.empty() && piece.may_break) out += "|";
    out += piece.text;
  }
  return out;
}

TEST(LineBreaks, EnglishBreaksAtSpacesAlone) {
  EXPECT_EQ(marked("the light's colour, k_d."), "the|light's|colour,|k_d.");
  EXPECT_EQ(marked("  two  spaces "), "two|spaces");
  EXPECT_EQ(marked(""), "");
}

TEST(LineBreaks, JapaneseBreaksBetweenCharacters) {
  EXPECT_EQ(marked("光源の色"), "光|源|の|色");
  EXPECT_EQ(marked("OpenGL では"), "OpenGL|で|は");
  EXPECT_EQ(marked("値は128まで"), "値|は|128|ま|で");
}

// JIS X 4051: no closing mark, small kana or long vowel begins a line, no opening bracket ends one.
TEST(LineBreaks, ForbiddenCharactersStayWithTheirNeighbours) {
  EXPECT_EQ(marked("光る。次に、"), "光|る。|次|に、");
  EXPECT_EQ(marked("「拡散」と（鏡面）"), "「拡|散」|と|（鏡|面）");
  EXPECT_EQ(marked("シェーダー"), "シェー|ダー");
  EXPECT_EQ(marked("きっと"), "きっ|と");
  EXPECT_EQ(marked("そう……か"), "そ|う……|か");
  for (const char32_t c : {U'、', U'。', U'」', U'）', U'ッ', U'ー'}) EXPECT_FALSE(may_break_between(U'光', c));
  for (const char32_t c : {U'「', U'（', U'『'}) EXPECT_FALSE(may_break_between(c, U'光'));
}

TEST(LineBreaks, TheLastCharacterOfARunDecidesAboutTheNext) {
  EXPECT_EQ(last_character("光源"), U'源');
  EXPECT_EQ(last_character("word "), U'\0');
  EXPECT_EQ(last_character(""), U'\0');
  EXPECT_FALSE(pieces_of("。", U'源')[0].may_break);
  EXPECT_TRUE(pieces_of("光", U'源')[0].may_break);
  EXPECT_FALSE(pieces_of("s", U'n')[0].may_break);
}

// Each part as its markup and its quantity's number.
std::string coloured(std::string_view markup) {
  Quantity carried = Quantity::none;
  std::string out, whole;
  for (const FormulaPart& part : coloured_parts(markup, carried)) {
    out += "<" + std::string(part.markup) + ":" + std::to_string(int(part.quantity)) + ">";
    whole += part.markup;
  }
  EXPECT_EQ(whole, markup);
  return out;
}

TEST(FormulaColours, AQuantityHoldsForTheFactorsBehindIt) {
  const std::string d = std::to_string(int(Quantity::diffuse)), s = std::to_string(int(Quantity::specular)),
                    a = std::to_string(int(Quantity::ambient));
  EXPECT_EQ(coloured("k_d (N·L) + k_s (R·V)^n"), "<k_d (N·L) :" + d + "><+ :0><k_s (R·V)^n:" + s + ">");
  EXPECT_EQ(coloured("I = I_a k_a"), "<I = :0><I_a k_a:" + a + ">");
  EXPECT_EQ(coloured("cos^n α"), "<cos:0><^n:" + s + ">< α:0>");
  EXPECT_EQ(coloured("sin θ"), "<sin θ:0>");
  EXPECT_EQ(coloured("_"), "<_:0>");
  EXPECT_EQ(coloured("a^{"), "<a^{:0>");
}

}  // namespace
}  // namespace cg
