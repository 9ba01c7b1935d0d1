// The light model in C that the listing shows: right without mistakes, and each mistake at its line.
#include "shading/own_light_model.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cg {
namespace {

std::vector<SourceLine> guilty(const Mistakes& mistakes) {
  std::vector<SourceLine> lines = own_light_model(mistakes);
  std::erase_if(lines, [](const SourceLine& l) { return l.mistake.empty(); });
  return lines;
}

TEST(OwnLightModel, HasEachMistakeAtItsLine) {
  EXPECT_TRUE(guilty({}).empty());
  const auto l = guilty({.long_light_vector = true});
  ASSERT_EQ(l.size(), 1u);
  EXPECT_EQ(l[0], (SourceLine{"        normalize( l );", "long_light_vector", true}));
  const auto gate = guilty({.no_gate = true});
  ASSERT_EQ(gate.size(), 3u);  // the two right lines, and the one in their place
  EXPECT_TRUE(gate[0].missing && gate[1].missing && !gate[2].missing);
  EXPECT_EQ(guilty({.no_gate = true, .long_light_vector = true}).size(), 4u);
}

TEST(OwnLightModel, IsPlainC) {
  for (const Mistakes& m : {Mistakes{}, Mistakes{.no_gate = true, .long_light_vector = true}})
    for (const SourceLine& line : own_light_model(m)) {
      EXPECT_EQ(line.text.find('#'), std::string::npos) << line.text;
      EXPECT_LE(line.text.size(), 120u) << line.text;
    }
}

}  // namespace
}  // namespace cg
