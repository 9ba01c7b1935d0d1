// Processor time, in milliseconds: of the whole process with all its threads, or of the thread that asks.
#pragma once
#include <ctime>

namespace cg {

inline double clock_ms(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}
inline double process_cpu_ms() { return clock_ms(CLOCK_PROCESS_CPUTIME_ID); }
inline double thread_cpu_ms() { return clock_ms(CLOCK_THREAD_CPUTIME_ID); }

// Work after work: each lap ends where the next begins.
class CpuClock {
 public:
  // Since the clock was made, or since the last lap.
  double lap_ms() {
    const double now = process_cpu_ms(), lap = now - last_;
    last_ = now;
    return lap;
  }
  double total_ms() const { return last_ - first_; }  // of the laps so far

 private:
  double first_ = process_cpu_ms(), last_ = first_;
};

}  // namespace cg
