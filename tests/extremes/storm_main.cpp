// storm [STATES [FIRST]]: random scenes through the software pipeline (10^6 from seed 0 on, if not said otherwise).
// Prints each faulty state's seed and a summary; exit status 1 where there was one.
#include <cstdio>
#include <cstdlib>

#include "raster/software.h"
#include "tests/extremes/storm.h"

int main(int argc, char** argv) {
  const std::uint64_t states = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000000;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 0;
  const cg::Technique software = cg::software_technique();
  const auto meshes = cg::storm::meshes();
  std::uint64_t faults = 0;
  for (std::uint64_t seed = first; seed < first + states; ++seed) {
    const std::string fault = cg::storm::fault(software, cg::storm::random_scene(seed, meshes));
    if (!fault.empty() && ++faults <= 20) std::printf("state %llu: %s\n", (unsigned long long)seed, fault.c_str());
    if ((seed - first) % 100000 == 99999) std::fprintf(stderr, "%llu states\n", (unsigned long long)(seed - first + 1));
  }
  std::printf("%llu states, %llu faulty\n", (unsigned long long)states, (unsigned long long)faults);
  return faults == 0 ? 0 : 1;
}
