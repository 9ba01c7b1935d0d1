#include <gtest/gtest.h>

#include "raster/software.h"
#include "tests/extremes/storm.h"

namespace cg {
namespace {

TEST(Storm, TenThousandStatesWithoutAFault) {
  const Technique software = software_technique();
  const auto meshes = storm::meshes();
  for (std::uint64_t seed = 0; seed < 10000; ++seed)
    EXPECT_EQ(storm::fault(software, storm::random_scene(seed, meshes)), "") << "state " << seed;
}

}  // namespace
}  // namespace cg
