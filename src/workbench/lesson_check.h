// Whether lessons hold: every number, both texts, every scene, every task.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "params/tree.h"
#include "workbench/lesson_numbers.h"

namespace cg {

// One line of the check.
struct LessonFinding {
  enum Kind { problem, number, task } kind = problem;
  std::string lesson, step;  // "03-shading", "gouraud"; no step where the files cannot be read
  std::string name;          // of the number, the task, or of what was looked at: "scene", "offer", "text"
  std::optional<double> value, expected, tolerance;
  Text note;  // where the expected value comes from, or what is wrong
  bool holds = false;
};

// Opens every step's scene, looks for the offered parameters and the view's techniques, computes the numbers, and tries
// each task: not done at the start, done by its solution. Throws Cancelled only.
std::vector<LessonFinding> check_lesson(const std::filesystem::path& folder, std::span<const Technique> techniques,
                                        Progress& progress);

}  // namespace cg
