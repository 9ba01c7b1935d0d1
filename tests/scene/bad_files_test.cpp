// Odd and broken files by the hundred (tests/fuzz/make_bad_meshes.py): each comes to as many faces as the file has, or
// to one message that fits on a line and names the file and the line or byte.
#include <chrono>
#include <cstdlib>
#include <fstream>

#include "tests/scene/reading.h"

namespace cg {
namespace {

std::string outcome(const std::filesystem::path& file) {
  try {
    return std::to_string(face_count(read_model(file)));
  } catch (const InputError& e) {
    for (Language language : {Language::english, Language::japanese}) {
      const std::string message = e.message(language);
      EXPECT_TRUE(message.starts_with(file.string()) && message.size() > file.string().size() + 5) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_LT(message.size(), file.string().size() + 400) << message;
    }
    EXPECT_TRUE(e.line > 0 || e.byte >= 0) << e.message(Language::english);
    return "error";
  }
}

TEST(BadFiles, EachIsRightOrRefused) {
  if (std::system("python3 -c '' 2>/dev/null") != 0) GTEST_SKIP() << "no python3";
  TestFolder folder;
  const std::string make =
      "python3 '" SHADEBENCH_SOURCE_DIR "/tests/fuzz/make_bad_meshes.py' '" + (folder / "m").string() + "'";
  ASSERT_EQ(std::system(make.c_str()), 0);
  std::ifstream manifest(folder / "m/manifest.tsv");
  std::string name, expected;
  std::size_t files = 0;
  double slowest = 0;
  while (std::getline(manifest, name, '\t') && std::getline(manifest, expected)) {
    SCOPED_TRACE(name);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(outcome(folder / ("m/" + name)), expected);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    slowest = std::max(slowest, took.count());
    ++files;
  }
  EXPECT_GE(files, 250u);
  std::printf("%zu files, the slowest in %.2f s\n", files, slowest);
}

}  // namespace
}  // namespace cg
