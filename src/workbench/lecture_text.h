// How the steps of a lecture's log are told: what changed, from what to what, and in which lines of the program.
#pragma once
#include <string>
#include <vector>

#include "workbench/lecture_log.h"

namespace cg {

// "s1", "s2", ...: how the three files name step `index` (from 0).
std::string lecture_step_id(std::size_t index);

// The paths of the parameters that differ, in their order; of lights and objects that came or went, "lights.1" alone.
// Where only the way of looking changed, "view".
std::vector<std::string> changed_paths(const LectureEntry& from, const LectureEntry& to);

// The view's settings that differ; `all` gives every one.
Tree view_changes(const LessonView& from, const LessonView& to, bool all);

// The parameters that a step offers: those that it changed, at most 8, the camera's left out.
Tree offered_after(const LectureEntry& from, const LectureEntry& to);

// The Markdown of all steps.
std::string lecture_text(const std::vector<LectureEntry>& steps, const Text& title, Language language);

}  // namespace cg
