// Hemicubes by OpenGL beside the software's.
#include "gl/hemicube_items.h"

#include <gtest/gtest.h>

#include "radiosity/hemicube_view.h"
#include "tests/radiosity/patch_rooms.h"

namespace cg {
namespace {

Radiosity options_of(ItemBuffer by, int resolution, int samples) {
  Radiosity options;
  options.item_buffer = by, options.resolution = resolution, options.samples = samples;
  return options;
}

TEST(HemicubeItems, BothSeeTheSamePatches) {
  Patches room = closed_cube(6);
  add_rectangle(room, {0.3, 0.3, 0.4}, {0.3, 0, 0}, {0, 0.25, 0}, 2, 2);
  add_rectangle(room, {0.6, 0.7, 0.1}, {0.2, 0.1, 0.3}, {-0.3, 0.1, 0.2}, 3, 1);
  const HemicubeViewer viewer(room, gl_draw_items());
  std::size_t other = 0, all = 0;
  for (std::uint32_t i = 0; i < room.patches.size(); i += 11) {
    const HemicubeView ours = viewer.view(i, i % 4, options_of(ItemBuffer::software, 64, 2));
    const HemicubeView theirs = viewer.view(i, i % 4, options_of(ItemBuffer::gl, 64, 2));
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x) {
        const bool pixel = cross_pixel(x, y, 64).has_value();
        all += pixel;
        other += pixel && ours.items.at(x, y) != theirs.items.at(x, y);
        if (pixel) {
          ASSERT_NE(theirs.items.at(x, y), no_item);
        }
      }
  }
  std::printf("%zu of %zu pixels differ\n", other, all);
  EXPECT_LT(double(other), 0.01 * double(all));  // OpenGL rounds corners to parts of a pixel
}

TEST(HemicubeItems, RowsAgree) {
  const Patches room = closed_cube(26);
  const Progress progress;
  const FormFactorRow ours = form_factor_method(room, options_of(ItemBuffer::software, 128, 1)).row(17, progress);
  const FormFactorRow theirs =
      form_factor_method(room, options_of(ItemBuffer::gl, 128, 1), gl_draw_items()).row(17, progress);
  EXPECT_NEAR(ours.sum, theirs.sum, 1e-6);
  double difference = 0;
  std::vector<double> factors(room.patches.size());
  for (const FormFactor& f : ours.factors) factors[f.patch] += double(f.value);
  for (const FormFactor& f : theirs.factors) factors[f.patch] -= double(f.value);
  for (const double d : factors) difference += std::abs(d);
  EXPECT_LT(difference, 0.02);
}

TEST(HemicubeItems, WithoutOpenGlSaysSo) {
  const Patches room = closed_cube(1);
  EXPECT_THROW(form_factor_method(room, options_of(ItemBuffer::gl, 64, 1)), InputError);
}

}  // namespace
}  // namespace cg
