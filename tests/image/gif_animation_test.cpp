#include "image/gif_animation.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "params/file.h"
#include "params/input_error.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

Picture plain(int width, int height, glm::u8vec4 colour) {
  Picture out(width, height);
  for (int y = 0; y < height; ++y) std::fill_n(out.row(y), width, colour);
  return out;
}

// The blocks of a GIF, read as the standard describes them: how long each frame is shown, and its size.
struct Seen {
  std::vector<int> delays;
  int width = 0, height = 0;
  bool loops = false, whole = false;
};
Seen read_gif(const std::string& b) {
  Seen out;
  const auto byte = [&](std::size_t i) { return i < b.size() ? int(static_cast<unsigned char>(b[i])) : -1; };
  const auto skip = [&](std::size_t at) {
    while (byte(at) > 0) at += std::size_t(byte(at)) + 1;
    return at + 1;
  };
  const auto table = [](int packed) { return packed & 0x80 ? std::size_t(3) << ((packed & 7) + 1) : 0; };
  EXPECT_EQ(b.substr(0, 6), "GIF89a");
  out.width = byte(6) | byte(7) << 8, out.height = byte(8) | byte(9) << 8;
  std::size_t at = 13 + table(byte(10));
  int delay = 0;
  while (at < b.size()) {
    if (byte(at) == 0x3b) {
      out.whole = at + 1 == b.size();
      break;
    }
    if (byte(at) == 0x21 && byte(at + 1) == 0xf9) delay = byte(at + 4) | byte(at + 5) << 8;
    if (byte(at) == 0x21 && byte(at + 1) == 0xff) out.loops = b.substr(at + 3, 11) == "NETSCAPE2.0";
    if (byte(at) == 0x21) {
      at = skip(at + 2);
    } else if (byte(at) == 0x2c) {
      EXPECT_EQ(byte(at + 5) | byte(at + 6) << 8, out.width);
      EXPECT_EQ(byte(at + 7) | byte(at + 8) << 8, out.height);
      out.delays.push_back(delay);
      at = skip(at + 10 + table(byte(at + 9)) + 1);
    } else {
      ADD_FAILURE() << "an unknown block at " << at;
      break;
    }
  }
  return out;
}

TEST(GifAnimation, FramesStandInOneContainerWithTheirTimes) {
  const fs::path file = fs::path(testing::TempDir()) / "animation.gif";
  fs::remove(file);
  GifAnimation gif(file, 40, 24);
  gif.add(plain(40, 24, {255, 0, 0, 255}), 7);
  gif.add(plain(40, 24, {0, 255, 0, 255}), 1);  // as short as programs play it
  gif.hold(40);
  gif.add(plain(40, 24, {0, 0, 255, 255}), 6);
  EXPECT_FALSE(fs::exists(file)) << "it appears when it is whole";
  gif.save();
  const Seen seen = read_gif(read_file(file));
  EXPECT_EQ(seen.delays, (std::vector<int>{7, 42, 6}));
  EXPECT_EQ(seen.width, 40);
  EXPECT_EQ(seen.height, 24);
  EXPECT_TRUE(seen.loops);
  EXPECT_TRUE(seen.whole);
  fs::remove(file);
}

TEST(GifAnimation, ASizeThatNoGifHasIsRefused) {
  EXPECT_THROW(GifAnimation("x.gif", 65536, 2), InputError);
  EXPECT_THROW(GifAnimation("x.gif", 0, 2), InputError);
}

TEST(GifAnimation, AFolderThatIsNotThereIsNamed) {
  GifAnimation gif("/nowhere/at/all.gif", 4, 4);
  gif.add(plain(4, 4, {1, 2, 3, 255}), 5);
  try {
    gif.save();
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(e.message(Language::english).find("/nowhere/at/all.gif"), std::string::npos);
  }
}

}  // namespace
}  // namespace cg
