// How long the start took and how long the window's own thread was busy with a frame: a promise of the program, so
// it can be printed.
#pragma once
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

namespace cg {

using WallClock = std::chrono::steady_clock;

inline double ms_since(WallClock::time_point t) {
  return std::chrono::duration<double, std::milli>(WallClock::now() - t).count();
}

class StartTimes {
 public:
  explicit StartTimes(bool print) : print_(print), start_(WallClock::now()) {}
  void mark(const char* what) const {
    if (print_) std::fprintf(stderr, "start: %-12s %7.1f ms\n", what, ms_since(start_));
  }

 private:
  bool print_;
  WallClock::time_point start_;
};

class FrameTimes {
 public:
  void begin() { start_ = WallClock::now(); }
  void end() { all_.push_back(ms_since(start_)); }
  void print() {
    if (all_.size() < 3) return;
    std::vector<double> later(all_.begin() + 2, all_.end());  // the first two build the fonts
    std::sort(later.begin(), later.end());
    std::fprintf(stderr, "frames: %zu, median %.1f ms, 99 %% %.1f ms, worst %.1f ms\n", later.size(),
                 later[later.size() / 2], later[later.size() * 99 / 100], later.back());
  }

 private:
  WallClock::time_point start_;
  std::vector<double> all_;
};

}  // namespace cg
