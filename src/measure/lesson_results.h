// A lesson as it comes out on this machine: every step drawn by its two techniques, timed, compared, and checked.
#pragma once
#include "image/difference.h"
#include "measure/trade.h"
#include "workbench/lesson.h"
#include "workbench/lesson_check.h"

namespace cg {

// One technique's picture of a step.
struct DrawnStep {
  std::string technique;
  Text name;
  std::optional<Text> problem;  // why there is no picture; then the rest is empty
  std::string file;             // the picture, a path below the report's folder
  Spread clock, cpu;            // of a frame: time on the clock; processor time of all threads
};

struct StepResult {
  DrawnStep left, right;
  std::optional<Difference> difference;  // where both are there
  std::string difference_file;
  double seen_gain = 1;  // false colours show the difference times this
  Scene scene;           // of the step: what a text names
  std::vector<NumberResult> numbers;
};

struct LessonResult {
  std::optional<Lesson> lesson;  // none where the files cannot be read: one of the findings says why
  std::string id;
  std::vector<StepResult> steps;  // of lesson->steps
  std::vector<LessonFinding> findings;

  std::size_t count(LessonFinding::Kind kind) const;
  std::size_t compared() const;  // numbers with an expected value, tasks, and what else was found wrong
  std::size_t off() const;
};

struct ResultOptions {
  int picture = 360;   // pixels a side, of the pictures
  int timed = 512;     // and of the frames that are timed
  int repeats = 7;     // of each frame, the two techniques in turn; the first is not counted
  double seconds = 1;  // for the repeats of a step: no more are begun after it, but for the first three
  int threads = 1;
};

// `findings`: of check_lesson(folder). Draws into `into`/pictures, which is made where it is missing. `techniques` must
// not be used by another thread meanwhile. Throws InputError where a file cannot be written, and Cancelled.
LessonResult lesson_result(const std::filesystem::path& folder, std::vector<LessonFinding> findings,
                           const std::filesystem::path& into, std::span<const Technique> techniques,
                           const ResultOptions& options, Progress& progress);

}  // namespace cg
