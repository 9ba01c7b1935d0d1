// The processor time of the whole process, all threads, in milliseconds.
#pragma once
#include <ctime>

namespace cg {

inline double process_cpu_ms() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

}  // namespace cg
