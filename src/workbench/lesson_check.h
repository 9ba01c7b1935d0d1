// Whether lessons hold: every number, both texts, every scene, every task.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "params/tree.h"
#include "workbench/commands.h"
#include "workbench/lesson_numbers.h"

namespace cg {

// One line of the check.
struct LessonFinding {
  std::string lesson, step;  // "03-shading", "gouraud"
  std::string name;          // of the number, the task, or of what was looked at: "scene", "offer", "text"
  std::optional<double> value, expected, tolerance;
  Text note;  // where the expected value comes from, or what is wrong
  bool holds = false;
};

// Opens every step's scene, looks for the offered parameters and the view's techniques, computes the numbers, and tries
// each task: not done at the start, done by its solution. Throws Cancelled only.
std::vector<LessonFinding> check_lesson(const std::filesystem::path& folder, std::span<const Technique> techniques,
                                        Progress& progress);

// `lessons`: lists them; with --check prints a line for each finding, 1 where one does not hold; with --report writes
// the texts. SCENE is a lesson's name or folder; none: all that come with the program.
int run_lessons(const Arguments& arguments, std::span<const Technique> techniques, Language language);

}  // namespace cg
