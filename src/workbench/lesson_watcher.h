// A lesson that is read again while the lecturer edits its files. An error keeps the last good version.
#pragma once
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "params/input_error.h"
#include "workbench/lesson.h"

namespace cg {

class LessonWatcher {
 public:
  // Reads the folder at once.
  explicit LessonWatcher(std::filesystem::path folder);

  // Looks whether a file has changed (three calls of stat) and reads them if so. True: lesson() or error() is new.
  bool poll();

  // The last version without an error; null where there was none yet.
  std::shared_ptr<const Lesson> lesson() const { return lesson_; }
  // What is wrong with the files as they are now, with file and line.
  const std::optional<InputError>& error() const { return error_; }

 private:
  struct Stamp {
    std::filesystem::file_time_type time{};
    std::uintmax_t bytes = 0;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  std::array<Stamp, 3> stamps() const;
  void read();

  const std::filesystem::path folder_;
  std::array<Stamp, 3> seen_{};
  std::shared_ptr<const Lesson> lesson_;
  std::optional<InputError> error_;
};

}  // namespace cg
