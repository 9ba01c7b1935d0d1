// Software and OpenGL draw the same picture: a sample of what `parity --all` goes through.
#include <gtest/gtest.h>

#include "params/input_error.h"
#include "tests/parity/parity_cases.h"

namespace cg::parity {
namespace {

class Parity : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    try {
      comparison_.emplace();
    } catch (const InputError& none) {
      GTEST_SKIP() << none.what();
    }
  }
  std::optional<Comparison> comparison_;
};

// Every camera, light and mode occurs with each model, though not each with each.
TEST_P(Parity, SameCoverageSameColours) {
  const Model model = shape_model(GetParam());
  const std::vector<Setting> settings = all_settings();
  for (std::size_t i = 0; i < settings.size(); i += 7)
    for (const Result& r :
         comparison_->compare(scene_of(model, settings[i]), model.name + ' ' + name_of(settings[i]))) {
      EXPECT_LE(r.coverage_mismatch, 5u) << r.what;
      EXPECT_LE(r.max_error * 255, 2.001) << r.what;
      EXPECT_LE(double(r.over_1_255), 0.001 * double(r.covered)) << r.what;
      EXPECT_GT(r.covered, 1000u) << r.what;
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Parity, ::testing::Values("teapot", "cube", "torus-knot", "plane"));

}  // namespace
}  // namespace cg::parity
