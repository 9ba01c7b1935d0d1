#include "workbench/progress_line.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace cg {

ProgressLine::ProgressLine(const Progress& progress, std::string label) {
  if (::isatty(STDERR_FILENO) != 1) return;
  thread_ = std::thread([this, &progress, label = std::move(label)] { run(progress, label); });
}

ProgressLine::~ProgressLine() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void ProgressLine::run(const Progress& progress, const std::string& label) {
  using namespace std::chrono_literals;
  std::unique_lock lock(mutex_);
  const auto finished = [&] { return done_; };
  if (wake_.wait_for(lock, 500ms, finished)) return;
  do {
    const int percent = int(100 * progress.fraction.load());
    std::fprintf(stderr, "\r%s %3d %%", label.c_str(), percent);
  } while (!wake_.wait_for(lock, 100ms, finished));
  std::fputs("\r\x1b[K", stderr);
}

}  // namespace cg
