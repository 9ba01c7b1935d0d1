#include "scene/bundled_textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <set>

#include "image/image_file.h"
#include "params/file.h"

namespace cg {
namespace {

const std::filesystem::path folder = std::filesystem::path(SHADEBENCH_SOURCE_DIR) / "textures";

const std::vector<BundledTexture>& textures() {
  static const std::vector<BundledTexture> made = bundled_textures_made();
  return made;
}

const Picture& picture(const std::string& name) {
  for (const BundledTexture& t : textures())
    if (t.name == name) return t.picture;
  throw std::out_of_range(name);
}

// After a change of a picture: shadebench-textures textures
TEST(BundledTextures, AreWhatTheProgramWrites) {
  EXPECT_EQ(read_file(folder / "SOURCES.md"), texture_sources(textures()));
  std::set<std::string> names{"SOURCES.md"};
  for (const BundledTexture& t : textures()) {
    names.insert(t.name);
    const FileImage file = read_image(folder / t.name);
    ASSERT_EQ(file.info.width, t.picture.width()) << t.name;
    ASSERT_EQ(file.info.height, t.picture.height()) << t.name;
    EXPECT_EQ(!file.alpha.empty(), t.alpha) << t.name;
    // Another mathematical library rounds its sines and cosines in its own way.
    int other = 0;
    for (int y = 0; y < file.info.height; ++y)
      for (int x = 0; x < file.info.width; ++x) {
        const glm::vec3 is = file.colour.at(x, y) * 255.0f;
        const glm::u8vec4 made = t.picture.at(x, y);
        for (int c = 0; c < 3; ++c) other += std::abs(is[c] - float(made[c])) > 1.01f;
        if (t.alpha) other += std::abs(file.alpha.at(x, y) * 255.0f - float(made.a)) > 1.01f;
      }
    EXPECT_EQ(other, 0) << t.name;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    EXPECT_TRUE(names.contains(entry.path().filename().string())) << entry.path() << " is not written by the program";
}

// What is laid side by side: the step over the border is no larger than the largest within.
TEST(BundledTextures, HaveNoSeam) {
  for (const char* name : {"brick-height.png", "marble.png", "rust-mask.png"}) {
    const Picture& p = picture(name);
    const auto step = [](glm::u8vec4 a, glm::u8vec4 b) { return std::abs(int(a.r) - int(b.r)); };
    int within = 0, over = 0;
    for (int i = 0; i < p.height(); ++i) {
      for (int k = 1; k < p.width(); ++k)
        within = std::max({within, step(p.at(k, i), p.at(k - 1, i)), step(p.at(i, k), p.at(i, k - 1))});
      over = std::max({over, step(p.at(0, i), p.at(p.width() - 1, i)), step(p.at(i, 0), p.at(i, p.height() - 1))});
    }
    EXPECT_LE(over, within) << name;
  }
}

// A normal picture's colours are unit normals of the upper hemisphere, upright on the whole.
TEST(BundledTextures, BrickNormalsAreUnit) {
  const Picture& p = picture("brick-normal.png");
  glm::dvec3 sum(0);
  for (int y = 0; y < p.height(); ++y)
    for (int x = 0; x < p.width(); ++x) {
      const glm::dvec3 n = glm::dvec3(p.at(x, y)) / 127.5 - 1.0;
      // The mean of unit normals is a little shorter where they turn.
      EXPECT_GT(n.z, 0) << x << " " << y;
      EXPECT_LE(glm::length(n), 1.02);
      sum += n;
    }
  sum /= double(p.width()) * p.height();
  EXPECT_NEAR(sum.x, 0, 0.01);
  EXPECT_NEAR(sum.y, 0, 0.01);
}

// The six faces show one room: along the edge of two walls, each of its own colour, the light falls off alike.
TEST(BundledTextures, TheRoomsFacesMeet) {
  const Picture &right = picture("room-right.png"), &near = picture("room-near.png");
  const int n = right.width();
  for (int y = 1; y < n - 1; ++y)  // where r_x = r_z = 1: the left edge of +x, the right one of +z
    EXPECT_NEAR(right.at(0, y).r / 0.78, near.at(n - 1, y).r / 0.80, 2) << y;
}

}  // namespace
}  // namespace cg
