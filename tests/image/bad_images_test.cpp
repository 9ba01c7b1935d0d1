// Hundreds of damaged and hostile files: each gives pixels of the size it states or one clear line, and the application
// lives on. The corpus comes from tests/fuzz/make_bad_images.py.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "image/image_file.h"
#include "params/file.h"
#include "params/input_error.h"
#include "tests/temporary_folder.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

struct Expected {
  std::string what;   // read, refuse, either
  int width, height;  // 0: any
  std::string name;
};

std::vector<Expected> expected_in(const fs::path& folder) {
  std::vector<Expected> all;
  std::istringstream lines(read_file(folder / "expected.txt"));
  for (std::string what, width, height, name; lines >> what >> width >> height >> name;)
    all.push_back({what, std::atoi(width.c_str()), std::atoi(height.c_str()), name});
  return all;
}

bool finite(const FileImage& image) {
  for (const glm::vec3& p : image.colour.pixels())
    if (!std::isfinite(p.r) || !std::isfinite(p.g) || !std::isfinite(p.b)) return false;
  return true;
}

TEST(BadImages, GivePixelsOrOneClearLine) {
  const TemporaryFolder folder;
  ColourImage good(16, 12);
  for (std::size_t i = 0; i < good.size(); ++i) good.pixels()[i] = glm::vec3(float(i) / 192, float(i % 16) / 16, 0.5f);
  std::string command =
      "python3 '" SHADEBENCH_SOURCE_DIR "/tests/fuzz/make_bad_images.py' '" + folder.path().string() + "'";
  for (const char* seed : {"a.jpg", "a.exr", "a.hdr"}) {
    write_image(folder / seed, good, {});
    command += " '" + (folder / seed).string() + "'";
  }
  ASSERT_EQ(std::system((command + " > /dev/null").c_str()), 0);

  const std::vector<Expected> all = expected_in(folder.path());
  EXPECT_GE(all.size(), 300u);
  int read = 0, refused = 0, ended = 0;
  for (const Expected& file : all) {
    const auto begin = std::chrono::steady_clock::now();
    try {
      const FileImage image = read_image(folder / file.name);
      ++read;
      if (std::getenv("SHADEBENCH_SHOW"))
        std::printf("  READ %s %dx%d %d channels %d bits, %zu bad\n", file.name.c_str(), image.info.width,
                    image.info.height, image.info.channels, image.info.bits, image.bad_pixels);
      EXPECT_NE(file.what, "refuse") << file.name;
      EXPECT_EQ(image.colour.size(), std::size_t(image.info.width) * std::size_t(image.info.height));
      EXPECT_TRUE(!file.width || image.info.width == file.width) << file.name;
      EXPECT_TRUE(!file.width || image.info.height == file.height) << file.name;
      EXPECT_TRUE(finite(image)) << file.name;
    } catch (const InputError& error) {
      ++refused;
      const std::string line = error.message(Language::english);
      EXPECT_NE(file.what, "read") << line;
      EXPECT_EQ(line.find('\n'), std::string::npos);
      EXPECT_EQ(line.rfind((folder / file.name).string() + ": ", 0), 0u) << line;
      EXPECT_GT(line.size(), (folder / file.name).string().size() + 10);
      if (line.find("ended over it") != std::string::npos) {
        ++ended;
        std::printf("  ended: %s\n", file.name.c_str());
      }
      if (std::getenv("SHADEBENCH_SHOW")) std::printf("  %s\n", line.c_str() + folder.path().string().size() + 1);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(11)) << file.name;
  }
  EXPECT_EQ(read_image(folder / "good.png").info.width, 16);
  std::printf("%zu files: %d read, %d refused, of which %d ended the program\n", all.size(), read, refused, ended);
}

}  // namespace
}  // namespace cg
