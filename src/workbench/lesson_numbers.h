// A lesson's numbers and tasks, computed: for its texts, for the student's scene and for the check.
#pragma once
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "workbench/lesson.h"
#include "workbench/solved_scenes.h"

namespace cg {

struct NumberResult {
  std::string name, unit;
  int digits = 3, decimals = -1;  // as in LessonNumber
  std::optional<double> value;
  std::optional<double> expected, tolerance;
  std::optional<Text> problem;  // why there is no value, or no expected value

  bool holds() const {
    return !problem && value && (!expected || std::abs(*value - *expected) <= *tolerance);  // NaN does not hold
  }
};

// The step's numbers for `preset`: the step's own, or preset_of() a student's scene, so that a text can follow it.
// `folder`: where model files are looked for. `techniques` must not be used by another thread meanwhile. `solved` keeps
// the radiosity solutions that were needed, for the next call. Never throws but Cancelled: what is wrong is each
// number's `problem`.
std::vector<NumberResult> compute_numbers(const LessonStep& step, const Tree& preset,
                                          const std::filesystem::path& folder, std::span<const Technique> techniques,
                                          Progress& progress, SolvedScenes& solved);

// As a person writes it: 0.0417, 12.5, 100, 1.2×10⁻⁷. `digits`: significant; `decimals`: at most so many behind the
// point, -1: any.
std::string in_digits(double v, int digits, int decimals = -1);

// The text of {{name}} in a step's text: a number of `results` in its digits, or the parameter at a path of the scene,
// as "material.n" or "lights.0.position.x". Nothing while a number is not there.
std::optional<std::string> text_of_number(std::string_view name, const std::vector<NumberResult>& results,
                                          const Scene& scene);

struct TaskResult {
  double value = 0, goal = 0, tolerance = 0;
  bool done = false;
};

// Whether the student's scene reaches the goal. `start` is the step's own scene. Takes a picture or two: to be called
// on a worker, with techniques of its own (software_technique() makes one). Throws InputError and Cancelled.
TaskResult check_task(const LessonTask& task, const Scene& scene, const Scene& start,
                      const std::filesystem::path& folder, std::span<const Technique> techniques, Progress& progress,
                      SolvedScenes& solved);

}  // namespace cg
