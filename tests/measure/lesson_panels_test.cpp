// What the steps of the program's own lessons open in the panels of trades and extremes is there.
#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "measure/extreme.h"
#include "measure/knob.h"
#include "workbench/lesson.h"

namespace cg {
namespace {

TEST(LessonPanels, NameKnobsAndExtremesThatAreThere) {
  std::set<std::string> knob_ids, extreme_ids;
  for (const Knob& knob : knobs()) knob_ids.emplace(knob.id);
  for (const ExtremeCase& c : extreme_cases()) extreme_ids.insert(c.id);
  std::size_t named = 0;
  for (const auto& folder : lesson_folders(SHADEBENCH_SOURCE_DIR "/lessons"))
    for (const LessonStep& step : read_lesson(folder).steps) {
      const auto& [knob, extreme] = std::tie(step.view.knob, step.view.extreme);
      named += !knob.empty() + !extreme.empty();
      EXPECT_TRUE(knob.empty() || knob_ids.contains(knob)) << knob;
      EXPECT_TRUE(extreme.empty() || extreme_ids.contains(extreme)) << extreme;
    }
  EXPECT_GE(named, 7u);
}

}  // namespace
}  // namespace cg
