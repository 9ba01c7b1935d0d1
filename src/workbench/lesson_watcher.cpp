#include "workbench/lesson_watcher.h"

#include <system_error>

namespace cg {

namespace fs = std::filesystem;

LessonWatcher::LessonWatcher(fs::path folder) : folder_(std::move(folder)), seen_(stamps()) { read(); }

std::array<LessonWatcher::Stamp, 3> LessonWatcher::stamps() const {
  std::array<Stamp, 3> out;
  const char* const files[] = {"lesson.json", "lesson.en.md", "lesson.ja.md"};
  for (std::size_t i = 0; i < out.size(); ++i) {
    std::error_code error;
    const auto time = fs::last_write_time(folder_ / files[i], error);
    if (error) continue;
    const auto bytes = fs::file_size(folder_ / files[i], error);
    if (!error) out[i] = {time, bytes};
  }
  return out;
}

bool LessonWatcher::poll() {
  const auto now = stamps();
  if (now == seen_) return false;
  seen_ = now;
  read();
  return true;
}

void LessonWatcher::read() {
  try {
    lesson_ = std::make_shared<const Lesson>(read_lesson(folder_));
    error_.reset();
  } catch (const InputError& e) {
    error_ = e;
  }
}

}  // namespace cg
