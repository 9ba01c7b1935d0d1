// One lesson of the report.
#pragma once
#include "measure/html.h"
#include "measure/lesson_results.h"

namespace cg {

// "✓" or "✗" in its colour, with a word for who cannot see it.
Html mark_of(bool holds, Language language);

// The id of a lesson's element, and of its step's: "lesson-1", "lesson-1-2". Both count from 0.
std::string lesson_anchor(std::size_t lesson);
std::string step_anchor(std::size_t lesson, std::size_t step);

// "12.3 ms" with the least and the most behind it.
Html spread_html(const Spread& spread);

Html lesson_section(const LessonResult& result, std::size_t index, Language language);

}  // namespace cg
