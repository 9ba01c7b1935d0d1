// What a lecturer changed and when, kept while the window is open, and saved as a lesson that the students step through
// afterwards: each step shows the lines of the program that changed.
#pragma once
#include <filesystem>
#include <vector>

#include "workbench/lesson.h"

namespace cg {

struct LectureEntry {
  double seconds = 0;  // since the lecture began
  Scene scene;
  LessonView view;
};

class LectureLog {
 public:
  // What stands now, `seconds` after the lecture began (never less than before). While a gesture is `held` nothing is
  // noted: what it changed is one entry, made when it ends. Cheap where nothing changed; call it once a frame.
  void note(const Scene& scene, const LessonView& view, double seconds, bool held);

  // In the order of time; the first is the scene that the lecture began with.
  const std::vector<LectureEntry>& entries() const { return entries_; }
  // Begins anew with what was noted last.
  void restart();

 private:
  std::vector<LectureEntry> entries_;
};

// What changed within `within` seconds in the same parameters becomes one entry (the wheel's notches, a value that was
// typed twice); then, the shortest gaps first, until at most `most` are left.
std::vector<LectureEntry> coalesced(std::vector<LectureEntry> entries, double within = 4, std::size_t most = 100);

// The merge patch (RFC 7396) that turns `from` into `to`. Neither may hold a null.
Tree patch_between(const Tree& from, const Tree& to);

// The lines of the listing that differ, in order: "- " before what went, "+ " before what came.
std::vector<std::string> changed_lines(const Scene& from, const Scene& to, Language language);

// Makes `folder` with lesson.json, lesson.en.md and lesson.ja.md, complete or not at all: read_lesson() takes it, and
// the scene of each step is that of coalesced(entries). Throws InputError where there is something in `folder`
// already that is no lesson, where nothing was changed, and where it cannot be written.
void save_lecture(const std::vector<LectureEntry>& entries, const std::filesystem::path& folder, const Text& title);

}  // namespace cg
