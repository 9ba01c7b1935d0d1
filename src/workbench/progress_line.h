// Shows on a terminal how far long work has come; silent in a pipe and for short work.
#pragma once
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "scene/frame.h"

namespace cg {

class ProgressLine {
 public:
  // Writes to stderr, where that is a terminal, from half a second on. `progress` outlives it.
  ProgressLine(const Progress& progress, std::string label);
  // Wipes the line.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

 private:
  void run(const Progress& progress, const std::string& label);

  std::mutex mutex_;
  std::condition_variable wake_;
  bool done_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace cg
