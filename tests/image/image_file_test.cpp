// Image files: every format there and back, faults of the disk and of the program that reads them.
#include "image/image_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <limits>
#include <random>
#include <thread>

#include "params/file.h"
#include "params/input_error.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace cg {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

class ImageFileTest : public testing::Test {
 protected:
  // What is said of a file of these bytes.
  std::string reading(const std::string& name, const std::string& bytes) {
    save_file(folder / name, bytes);
    return refusal_of([&] { read_image(folder / name); });
  }
  const TemporaryFolder folder;
};

ColourImage noise(int width, int height, float from, float to) {
  std::mt19937 random(7);
  ColourImage image(width, height);
  for (glm::vec3& p : image.pixels())
    for (int c = 0; c < 3; ++c) p[c] = from + (to - from) * float(random() >> 8) / float(1 << 24);
  return image;
}

double largest_error(const ColourImage& a, const ColourImage& b) {
  double largest = 0;
  EXPECT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(double(a.pixels()[i][c] - b.pixels()[i][c])));
  return largest;
}

std::string text(std::initializer_list<std::string_view> parts) {
  std::string out;
  for (std::string_view part : parts) out += part;
  return out;
}

std::string floats(std::initializer_list<float> values) {
  return {reinterpret_cast<const char*>(std::data(values)), values.size() * sizeof(float)};
}

TEST_F(ImageFileTest, EightBitsAreExact) {
  ColourImage steps(256, 2);
  for (int i = 0; i < 256; ++i) {
    steps.at(i, 0) = glm::vec3(float(i) / 255);
    steps.at(i, 1) = {float(i) / 255, float(255 - i) / 255, 0.5f};
  }
  for (const Display& d : {Display{}, Display{DisplayTransform::photographic, 1, {}}}) {
    write_image(folder / "a.png", steps, d);
    const FileImage read = read_image(folder / "a.png");
    EXPECT_EQ(picture({}, read.colour), picture(d, steps));
    EXPECT_EQ(read.info.bits, 8);
    EXPECT_EQ(read.info.channels, 3);
    EXPECT_FALSE(read.info.floating);
    EXPECT_TRUE(read.alpha.empty());
  }
  write_image(folder / "b.png", picture({}, steps));
  EXPECT_EQ(picture({}, read_image(folder / "b.png").colour), picture({}, steps));
}

TEST_F(ImageFileTest, SixteenBitsToAStep) {
  const ColourImage image = noise(333, 17, 0, 1);
  write_image(folder / "a.png", image, {}, Depth::high);
  const FileImage read = read_image(folder / "a.png");
  EXPECT_EQ(read.info.bits, 16);
  EXPECT_LE(largest_error(read.colour, image), 0.5 / 65535 + 1e-7);
}

TEST_F(ImageFileTest, FloatIsExactAndHalfIsTheNearestHalf) {
  ColourImage image = noise(97, 31, -100, 100);
  image.at(0, 0) = {1e-30f, -1e30f, 65504};
  write_image(folder / "a.exr", image, {}, Depth::high);
  FileImage read = read_image(folder / "a.exr");
  EXPECT_EQ(read.colour, image);
  EXPECT_EQ(read.info.bits, 32);
  EXPECT_TRUE(read.info.floating);
  write_image(folder / "b.exr", image, {});
  read = read_image(folder / "b.exr");
  EXPECT_EQ(read.info.bits, 16);
  EXPECT_EQ(read.colour.at(0, 0), glm::vec3(0, -65504, 65504));  // within half's range
  for (std::size_t i = 1; i < image.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const float a = image.pixels()[i][c];
      ASSERT_NEAR(double(read.colour.pixels()[i][c]), double(a), std::abs(double(a)) / 2048 + 3e-8);
    }
}

TEST_F(ImageFileTest, RadianceKeepsOnePercentOfTheLargestChannel) {
  const ColourImage image = noise(64, 40, 0, 300);
  write_image(folder / "a.hdr", image, {});
  const FileImage read = read_image(folder / "a.hdr");
  EXPECT_TRUE(read.info.floating);
  for (std::size_t i = 0; i < image.size(); ++i) {
    const glm::vec3 a = image.pixels()[i];
    const double largest = double(std::max(a.r, std::max(a.g, a.b)));
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(double(read.colour.pixels()[i][c]), double(a[c]), largest / 128);
  }
}

TEST_F(ImageFileTest, JpegIsClose) {
  ColourImage smooth(200, 100);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 200; ++x) smooth.at(x, y) = {float(x) / 199, float(y) / 99, 0.5f};
  write_image(folder / "a.jpeg", smooth, {});
  EXPECT_LE(largest_error(read_image(folder / "a.jpeg").colour, smooth), 8.0 / 255);
}

TEST_F(ImageFileTest, SizesAndNames) {
  for (const auto& [w, h] : {std::pair{1, 1}, {1, 700}, {65536, 1}, {33, 17}})
    for (const char* name : {"a.png", "日本 語?x=1.EXR", "b.hdr", "c.jpg"}) {
      if (w > 65500 && name[0] == 'c') continue;  // JPEG ends there
      write_image(folder / name, ColourImage(w, h, glm::vec3(0.5f)), {});
      const ImageInfo info = inspect_image(folder / name);
      EXPECT_EQ(info.width, w) << name;
      EXPECT_EQ(info.height, h) << name;
      EXPECT_EQ(read_image(folder / name).colour.size(), std::size_t(w * h)) << name;
    }
}

TEST_F(ImageFileTest, SamePictureSameBytes) {
  const ColourImage image = noise(50, 50, 0, 1);
  ImageProgram another;
  const std::array names{"a.png", "a.exr", "a.hdr", "a.jpg"};
  for (const char* name : names) write_image(folder / name, image, {});
  std::this_thread::sleep_for(1100ms);  // nor does the time matter
  fs::create_directory(folder / "again");
  for (const char* name : names) {
    write_image(folder / "again" / name, image, {}, Depth::standard, another);
    EXPECT_TRUE(read_file(folder / "again" / name) == read_file(folder / name)) << name;
  }
}

TEST_F(ImageFileTest, ByContentNotByName) {
  write_image(folder / "a.png", ColourImage(3, 2, glm::vec3(1)), {});
  fs::rename(folder / "a.png", folder / "a.jpg");
  EXPECT_EQ(read_image(folder / "a.jpg").info.width, 3);
  EXPECT_NE(reading("text.png", "hello world\n").find("not an image of a known format"), std::string::npos);
  EXPECT_NE(reading("empty.png", "").find("is empty"), std::string::npos);
}

TEST_F(ImageFileTest, OrdinaryFilesOfOtherFormats) {
  save_file(folder / "a.ppm", text({"P6\n2 1\n255\n", {"\xff\x00\x00\x00\x80\xff", 6}}));
  FileImage read = read_image(folder / "a.ppm");
  EXPECT_EQ(read.colour.at(0, 0), glm::vec3(1, 0, 0));
  EXPECT_EQ(read.colour.at(1, 0), glm::vec3(0, 128 / 255.0f, 1));
  save_file(folder / "a.pgm", text({"P5\n1 1\n65535\n", {"\x80\x00", 2}}));
  read = read_image(folder / "a.pgm");
  EXPECT_EQ(read.info.bits, 16);
  EXPECT_EQ(read.info.channels, 1);
  EXPECT_NEAR(double(read.colour.at(0, 0).b), 32768 / 65535.0, 1e-7);
  // True colour, 2 x 1, 32 bits, origin at the top: blue, green, red, alpha.
  save_file(folder / "a.tga",
            text({{"\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\x20\x28", 18}, {"\0\0\xff\x80\xff\0\0\xff", 8}}));
  read = read_image(folder / "a.tga");
  EXPECT_EQ(read.colour.at(0, 0), glm::vec3(1, 0, 0));
  EXPECT_NEAR(double(read.alpha.at(0, 0)), 128 / 255.0, 1e-7);
  EXPECT_EQ(read.colour.at(1, 0), glm::vec3(0, 0, 1));
}

TEST_F(ImageFileTest, NanAndInfinityInAFileBecomeZeroAndAreCounted) {
  save_file(folder / "a.pfm", text({"PF\n2 2\n-1.0\n", floats({1, nan, 3, 4, 5, 6, 7, inf, -inf, 10, 11, 12})}));
  const FileImage read = read_image(folder / "a.pfm");
  EXPECT_EQ(read.bad_pixels, 2u);
  double sum = 0;
  for (const glm::vec3& p : read.colour.pixels()) sum += double(p.r + p.g + p.b);
  EXPECT_EQ(sum, 1 + 3 + 4 + 5 + 6 + 7 + 10 + 11 + 12);
}

TEST_F(ImageFileTest, HugeHeadersAreRefusedAtOnce) {
  ImageProgram::shared();
  const pid_t before = ImageProgram::shared().pid();
  EXPECT_NE(reading("a.ppm", "P6\n1000000 1000000\n255\n").find("too large"), std::string::npos);
  EXPECT_NE(reading("b.ppm", "P6\n100000 100000\n255\n").find("too large"), std::string::npos);
  EXPECT_NE(reading("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 100000\n"), "");
  EXPECT_NE(reading("b.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y -5 +X 5\n"), "");
  EXPECT_NE(reading("c.ppm", "P6\n-5 5\n255\n" + std::string(75, 'x')), "");
  EXPECT_TRUE(before == -1 || ImageProgram::shared().pid() == before);
}

TEST_F(ImageFileTest, WritingSaysWhatItCannotDo) {
  const ColourImage image(2, 2);
  const auto writing = [&](const fs::path& f, const ColourImage& i) {
    return refusal_of([&] { write_image(f, i, {}); });
  };
  EXPECT_NE(writing(folder / "a.gif", image).find("use .png, .jpg, .exr or .hdr"), std::string::npos);
  EXPECT_NE(writing(folder / "none" / "a.png", image).find("no such file or folder"), std::string::npos);
  EXPECT_NE(writing("/dev/full", image), "");
  EXPECT_NE(writing(folder / "a.png", {}).find("a picture of this size"), std::string::npos);
  EXPECT_NE(writing(folder / "a.jpg", ColourImage(65501, 1)).find("at most 65500"), std::string::npos);
  EXPECT_NE(refusal_of([&] { write_image(folder / "a.exr", Picture(2, 2)); }).find("use .png or .jpg"),
            std::string::npos);
}

TEST_F(ImageFileTest, AFullDiskLeavesTheOldFile) {
  const ColourImage old(4, 4, glm::vec3(1)), image = noise(400, 400, 0, 1);
  rlimit limit{};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  for (const char* name : {"a.png", "a.jpg", "a.hdr", "a.exr"}) {
    write_image(folder / name, old, {});
    const std::string before = read_file(folder / name);
    const rlimit small{16384, limit.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const std::string message = refusal_of([&] { write_image(folder / name, image, {}); });
    ::setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_NE(message.find("not saved"), std::string::npos) << name << message;
    EXPECT_EQ(read_file(folder / name), before) << name;
  }
  ::signal(SIGXFSZ, handler);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 4);
}

TEST_F(ImageFileTest, StartsOnlyWhenItIsNeededAndAgainWhenItDied) {
  ImageProgram program;
  EXPECT_EQ(program.pid(), -1);
  write_image(folder / "a.png", ColourImage(8, 8), {}, Depth::standard, program);
  const pid_t first = program.pid();
  EXPECT_GT(first, 0);
  read_image(folder / "a.png", program);
  EXPECT_EQ(program.pid(), first);
  ::kill(first, SIGKILL);
  siginfo_t ended;
  ASSERT_EQ(::waitid(P_PID, id_t(first), &ended, WEXITED | WNOWAIT), 0);  // dead, and still the program's to notice
  EXPECT_EQ(read_image(folder / "a.png", program).info.width, 8);
  EXPECT_NE(program.pid(), first);
}

TEST_F(ImageFileTest, AStoppedProgramIsGivenUp) {
  ImageProgram program({}, 10s);
  write_image(folder / "a.png", ColourImage(8, 8), {}, Depth::standard, program);
  ImageProgram hasty({}, 400ms);
  while (hasty.pid() < 0) try {  // starting may take longer than this limit on a busy machine
      read_image(folder / "a.png", hasty);
    } catch (const InputError&) {
    }
  ::kill(hasty.pid(), SIGSTOP);
  EXPECT_NE(refusal_of([&] { read_image(folder / "a.png", hasty); }).find("took longer"), std::string::npos);
  EXPECT_EQ(hasty.pid(), -1);
}

TEST_F(ImageFileTest, KilledAtAnyMomentGivesPixelsOrAMessage) {
  ImageProgram program;
  const ColourImage image = noise(300, 300, 0, 1);
  write_image(folder / "a.png", image, {}, Depth::standard, program);
  std::atomic<bool> over{false};
  std::thread killer([&] {
    for (int i = 0; !over; ++i) {
      std::this_thread::sleep_for(std::chrono::microseconds(20000 + 7919 * (i % 97)));
      if (const pid_t pid = program.pid(); pid > 0) ::kill(pid, SIGKILL);
    }
  });
  int read = 0, refused = 0;
  const auto end = std::chrono::steady_clock::now() + 3s;
  while (std::chrono::steady_clock::now() < end) {
    const std::string message = refusal_of([&] {
      EXPECT_EQ(read_image(folder / "a.png", program).colour.size(), image.size());
      write_image(folder / "b.png", image, {}, Depth::standard, program);
    });
    message.empty() ? ++read : ++refused;
    EXPECT_TRUE(message.empty() || message.find("ended over it") != std::string::npos) << message;
  }
  over = true;
  killer.join();
  EXPECT_GT(refused, 0);
  refusal_of([&] { read_image(folder / "a.png", program); });  // the last kill may fall into this one
  EXPECT_EQ(read_image(folder / "a.png", program).info.width, 300);
}

TEST_F(ImageFileTest, AMissingOrOtherProgramIsAMessage) {
  write_image(folder / "a.png", ColourImage(8, 8), {});
  ImageProgram missing(folder / "none");
  EXPECT_NE(refusal_of([&] { read_image(folder / "a.png", missing); }).find("does not start"), std::string::npos);
  ImageProgram other("/bin/true"), echo("/bin/cat");
  EXPECT_NE(refusal_of([&] { read_image(folder / "a.png", other); }).find("ended over it"), std::string::npos);
  EXPECT_NE(refusal_of([&] { read_image(folder / "a.png", echo); }), "");
}

TEST_F(ImageFileTest, ManyThreads) {
  write_image(folder / "a.png", noise(64, 64, 0, 1), {});
  const FileImage expected = read_image(folder / "a.png");
  std::vector<std::thread> threads;
  std::atomic<int> good{0};
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 10; ++i) {
        good += read_image(folder / "a.png").colour == expected.colour;
        write_image(folder / ("t" + std::to_string(t) + ".png"), expected.colour, {});
      }
    });
  for (std::thread& t : threads) t.join();
  EXPECT_EQ(good, 40);
}

}  // namespace
}  // namespace cg
