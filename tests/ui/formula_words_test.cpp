#include "ui/formula_words.h"

#include <gtest/gtest.h>

#include "params/slots.h"
#include "scene/scene.h"

namespace cg {
namespace {

// The formulas between bars.
std::string marked(std::string_view text) {
  std::string out;
  for (const TextRun& run : formula_runs(text)) out += run.kind == TextRun::formula ? "|" + run.text + "|" : run.text;
  return out;
}

TEST(FormulaWords, AreFoundInTheTextsOfBothLanguages) {
  EXPECT_EQ(marked("The share of the light I_r from the mirrored direction."),
            "The share of the light |I_r| from the mirrored direction.");
  EXPECT_EQ(marked("The colour I_i that is multiplied by k_d (N·L)."),
            "The colour |I_i| that is multiplied by |k_d (N·L)|.");
  EXPECT_EQ(marked("鏡の方向から来る光 I_r の割合。"), "鏡の方向から来る光 |I_r| の割合。");
  EXPECT_EQ(marked("k_d (N·L) に掛かる色 I_i。"), "|k_d (N·L)| に掛かる色 |I_i|。");
  EXPECT_EQ(marked("1/(k_0 + k_1 r + k_2 r²): the part"), "|1/(k_0 + k_1 r + k_2 r²)|: the part");
  EXPECT_EQ(marked("(R·V)^n is the lecture's, (N·H)^n OpenGL's."), "|(R·V)^n| is the lecture's, |(N·H)^n| OpenGL's.");
}

TEST(FormulaWords, NamesOfOpenGLAndPlainSentencesAreNone) {
  for (const char* text : {"", " ", "GL_NORMALIZE mends it.", "use GL_LIGHT_0 or own_material", "a_", "_a", "x _ y",
                           "N·L is negative", "光源の側で N·L が負になり"})
    EXPECT_EQ(marked(text), text);
}

TEST(FormulaWords, TogetherTheRunsAreTheText) {
  Scene scene;
  scene.objects.emplace_back();
  for (const Slot& slot : slots(scene))
    for (const std::string_view text : {slot.about->help.en, slot.about->help.ja}) {
      std::string all;
      for (const TextRun& run : formula_runs(text)) all += run.text;
      EXPECT_EQ(all, text);
    }
}

}  // namespace
}  // namespace cg
