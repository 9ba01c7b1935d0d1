#include "ui/frame_writer.h"

#include <gtest/gtest.h>

#include "image/image_file.h"
#include "params/file.h"
#include "tests/temporary_folder.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<const Picture> plain(int width, int height, std::uint8_t red) {
  auto out = std::make_shared<Picture>(width, height);
  for (int y = 0; y < height; ++y) std::fill_n(out->row(y), width, glm::u8vec4(red, 0, 0, 255));
  return out;
}

class FrameWriterTest : public testing::Test {
 protected:
  static void wait(FrameWriter& writer) {
    writer.finish();
    for (int i = 0; i < 1500 && !writer.ended(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_TRUE(writer.ended());
  }
  std::vector<std::string> names() const {
    std::vector<std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
      if (entry.is_regular_file()) out.push_back(entry.path().filename().string());
    std::sort(out.begin(), out.end());
    return out;
  }

  TemporaryFolder folder;
};

TEST_F(FrameWriterTest, ASequenceHasAFileForEachTick) {
  FrameWriter writer(RecordedAs::png, folder / "clip", 15, [] {});
  const auto one = plain(8, 6, 10), two = plain(8, 6, 200);
  EXPECT_TRUE(writer.put({one, nullptr, 1}));
  EXPECT_TRUE(writer.put({two, nullptr, 3}));  // two ticks were missed: they show the frame before
  EXPECT_TRUE(writer.put({two, nullptr, 1}));
  wait(writer);
  EXPECT_FALSE(writer.error());
  EXPECT_EQ(names(), (std::vector<std::string>{"frame-00001.png", "frame-00002.png", "frame-00003.png",
                                               "frame-00004.png", "frame-00005.png"}));
  const auto red = [&](const char* name) { return read_image(folder / "clip" / name).colour.at(3, 3).r * 255; };
  for (const char* name : {"frame-00001.png", "frame-00002.png", "frame-00003.png"}) EXPECT_FLOAT_EQ(red(name), 10);
  for (const char* name : {"frame-00004.png", "frame-00005.png"}) EXPECT_FLOAT_EQ(red(name), 200);
}

TEST_F(FrameWriterTest, TwoPicturesStandBesideEachOtherAndACoarseOneIsEnlarged) {
  FrameWriter writer(RecordedAs::png, folder / "clip", 15, [] {});
  writer.put({plain(8, 6, 10), plain(8, 6, 200), 1});
  writer.put({plain(2, 2, 60), plain(8, 6, 200), 1});
  wait(writer);
  const FileImage first = read_image(folder / "clip/frame-00001.png"),
                  second = read_image(folder / "clip/frame-00002.png");
  EXPECT_EQ(first.info.width, 8 + 8 + 8);
  EXPECT_EQ(second.info.width, first.info.width);
  EXPECT_EQ(second.info.height, 6);
  EXPECT_FLOAT_EQ(first.colour.at(7, 5).r * 255, 10);
  EXPECT_FLOAT_EQ(first.colour.at(10, 5).r * 255, 0);
  EXPECT_FLOAT_EQ(first.colour.at(16, 5).r * 255, 200);
  EXPECT_FLOAT_EQ(second.colour.at(7, 5).r * 255, 60);
}

TEST_F(FrameWriterTest, AGifAppearsWhenItIsWholeAndNotBefore) {
  const fs::path file = folder / "clip.gif";
  {
    FrameWriter writer(RecordedAs::gif, file, 15, [] {});
    writer.put({plain(8, 6, 10), nullptr, 1});
    EXPECT_FALSE(fs::exists(file));
    wait(writer);
    EXPECT_TRUE(fs::exists(file));
    EXPECT_EQ(read_file(file).back(), ';');
  }
  fs::remove(file);
  {
    FrameWriter writer(RecordedAs::gif, file, 15, [] {});
    writer.put({plain(8, 6, 10), nullptr, 1});
  }
  EXPECT_TRUE(names().empty()) << "it was left unfinished";
}

TEST_F(FrameWriterTest, TheQueueDoesNotGrow) {
  FrameWriter writer(RecordedAs::gif, folder / "clip.gif", 15, [] {});
  const auto picture = plain(512, 512, 10);
  int taken = 0;
  for (int i = 0; i < 1000; ++i) taken += writer.put({std::make_shared<Picture>(*picture), nullptr, 1});
  EXPECT_LT(taken, 200);
}

TEST_F(FrameWriterTest, WhatCannotBeWrittenIsSaid) {
  FrameWriter writer(RecordedAs::png, folder / "clip", 15, [] {});
  fs::remove_all(folder / "clip");
  writer.put({plain(8, 6, 10), nullptr, 1});
  wait(writer);
  ASSERT_TRUE(writer.error());
  EXPECT_NE(writer.error()->message(Language::english).find("frame-00001.png"), std::string::npos);
  EXPECT_FALSE(writer.put({plain(8, 6, 10), nullptr, 1}));
}

TEST_F(FrameWriterTest, WhatIsThereIsLeftAlone) {
  save_file(folder / "thesis.tex", "years of work");
  EXPECT_THROW(FrameWriter(RecordedAs::png, folder.path(), 15, [] {}), InputError);
  EXPECT_THROW(FrameWriter(RecordedAs::gif, folder / "none/clip.gif", 15, [] {}), InputError);
  EXPECT_EQ(names(), (std::vector<std::string>{"thesis.tex"}));
}

TEST_F(FrameWriterTest, NothingStaysOfARecordingWithoutAFrame) {
  FrameWriter writer(RecordedAs::png, folder / "clip", 15, [] {});
  wait(writer);
  EXPECT_FALSE(fs::exists(folder / "clip"));
}

}  // namespace
}  // namespace cg
