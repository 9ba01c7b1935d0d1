// Extreme pictures and surroundings: sizes at the limits, every kind of channel, no memory to spare, another locale.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>

#include "image/image_file.h"
#include "params/file.h"
#include "params/input_error.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

class ImageExtremes : public testing::Test {
 protected:
  FileImage read(const std::string& name, const std::string& bytes) {
    save_file(folder / name, bytes);
    return read_image(folder / name);
  }
  std::string refusal(const std::string& name, const std::string& bytes) {
    return refusal_of([&] { read(name, bytes); });
  }
  const TemporaryFolder folder;
};

std::string ppm(int width, int height) {
  return "P6\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" +
         std::string(3 * std::size_t(width) * std::size_t(height), '\x80');
}

std::string header_of(long width, long height) {
  return "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
}

long peak_kib() {
  rusage use{};
  ::getrusage(RUSAGE_SELF, &use);
  return use.ru_maxrss;
}

TEST_F(ImageExtremes, Sizes) {
  for (const auto& [w, h] : {std::pair{1, 1}, {1, 997}, {33, 17}, {65536, 1}, {1, 65536}, {1 << 20, 1}}) {
    const FileImage image = read("a.ppm", ppm(w, h));
    EXPECT_EQ(image.colour.width(), w);
    EXPECT_EQ(image.colour.height(), h);
    EXPECT_EQ(image.colour.at(w - 1, h - 1), glm::vec3(128 / 255.0f));
  }
}

TEST_F(ImageExtremes, OverTheLimitIsRefusedBeforeItCostsAnything) {
  const long before = peak_kib();
  for (const auto& [w, h] : {std::pair{32768L, 32768L}, {16385L, 16384L}, {(1L << 20) + 1, 1L}, {1L, 2000000000L}})
    EXPECT_NE(refusal("a.pgm", header_of(w, h)).find("too large"), std::string::npos) << w;
  EXPECT_LT(peak_kib() - before, 8 << 10);
}

TEST_F(ImageExtremes, ReadingTakesAtMostThreeTimesThePixels) {
  const int side = 2048;
  save_file(folder / "a.ppm", ppm(side, side));
  const long before = peak_kib();
  const FileImage image = read_image(folder / "a.ppm");
  const long pixels_kib = long(image.colour.size() * sizeof(glm::vec3) >> 10);
  EXPECT_LE(peak_kib() - before, 3 * pixels_kib);
}

TEST_F(ImageExtremes, HalfOfTheSignalIsTheGrey188) {
  write_image(folder / "a.png", ColourImage(1, 1, glm::vec3(0.5f)), {DisplayTransform::photographic, 0, {}});
  EXPECT_EQ(to_8bit(read_image(folder / "a.png").colour.at(0, 0).g), 188);
  write_image(folder / "a.png", ColourImage(1, 1, glm::vec3(0.5f)), {});
  EXPECT_EQ(to_8bit(read_image(folder / "a.png").colour.at(0, 0).g), 128);
}

TEST_F(ImageExtremes, TheLargestRadianceIsFinite) {
  const FileImage image = read("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\xff\xff\xff\xff");
  EXPECT_GT(image.colour.at(0, 0).r, 1e38f);
  EXPECT_EQ(image.bad_pixels, 0u);
  write_image(folder / "b.hdr", ColourImage(1, 1, glm::vec3(1e20f, 1e-20f, -3)), {});
  EXPECT_NEAR(double(read_image(folder / "b.hdr").colour.at(0, 0).r), 1e20, 1e18);
}

TEST_F(ImageExtremes, BadPixelsAreNeverWritten) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const ColourImage bad(4, 4, {nan, inf, -inf});
  for (const char* name : {"a.png", "a.jpg", "a.exr", "a.hdr"}) {
    write_image(folder / name, bad, {});
    const FileImage image = read_image(folder / name);
    EXPECT_EQ(image.bad_pixels, 0u) << name;
    EXPECT_NEAR(double(image.colour.at(1, 1).r), 0, 0.02) << name;
  }
}

TEST_F(ImageExtremes, AnotherLocaleChangesNothing) {
  const ColourImage image(3, 3, {0.123f, 4.5f, 1e-7f});
  const char* had = std::getenv("LC_ALL");
  const std::string before = had ? had : "";
  for (const char* name : {"a.exr", "a.hdr", "a.png"}) {
    write_image(folder / name, image, {});
    const std::string bytes = read_file(folder / name);
    ::setenv("LC_ALL", "de_DE.UTF-8", 1);
    ImageProgram german;
    write_image(folder / name, image, {}, Depth::standard, german);
    EXPECT_TRUE(read_file(folder / name) == bytes) << name;
    had ? ::setenv("LC_ALL", before.c_str(), 1) : ::unsetenv("LC_ALL");
  }
}

}  // namespace
}  // namespace cg
