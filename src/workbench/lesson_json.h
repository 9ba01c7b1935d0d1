// The part of a lesson that is no text: steps, their scenes, numbers and tasks, from lesson.json.
#pragma once
#include "workbench/lesson.h"

namespace cg {

// The steps in order, without their texts. `where` names the file. Throws InputError with the line.
std::vector<LessonStep> parse_lesson_json(std::string_view json, const std::string& where);

}  // namespace cg
