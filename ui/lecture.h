// The lecture's log in the window: noted while the lecturer works, saved as a lesson from the list of lessons.
#pragma once
#include <optional>
#include <string>

#include "workbench/lecture_log.h"

namespace cg {

struct App;

struct LectureDesk {
  LectureLog log;
  std::optional<std::string> folder;  // that is being typed, to save it
  int reveal = 0;                     // frames in which the panel still scrolls to where it is typed
};

// After a frame.
void note_lecture(App& app);

// How many changes there are, and where they are saved.
void draw_lecture_log(App& app);

}  // namespace cg
