// `lessons --report DIR`: the lessons on this machine, as pages for a browser.
#pragma once
#include "measure/report_page.h"

namespace cg {

struct WrittenReport {
  bool holds = false;          // all that was compared
  std::filesystem::path page;  // in the language asked for
};

// Writes a page a language and their pictures into `into`, which is made where it is missing; the pages last, each
// complete or not at all. `findings`: of check_lesson(), a lesson each. `quick`: without trades and extremes, which
// take minutes. Tells on a terminal how far it is. Throws InputError where a file cannot be written.
WrittenReport write_lesson_report(const std::vector<std::filesystem::path>& folders,
                                  std::vector<std::vector<LessonFinding>> findings, const std::filesystem::path& into,
                                  std::span<const Technique> techniques, bool quick, Language language);

}  // namespace cg
