// Whole files in and out, and what stays of the old one when saving fails.
#include "params/file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "params/input_error.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

class FileTest : public testing::Test {
 protected:
  std::size_t files() const { return std::size_t(std::distance(fs::directory_iterator(folder.path()), {})); }
  const TemporaryFolder folder;
};

TEST_F(FileTest, SavesAndReadsTheSameBytes) {
  std::string bytes(100000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = char(i * 7);
  const fs::path file = folder / "日本 語\n?x=1.bin";
  save_file(file, bytes);
  EXPECT_EQ(read_file(file), bytes);
  save_file(file, "");
  EXPECT_EQ(read_file(file), "");
  EXPECT_EQ(files(), 1u);
}

TEST_F(FileTest, KeepsALinkAndThePermissions) {
  const fs::path file = folder / "real", link = folder / "link";
  save_file(file, "old");
  ::chmod(file.c_str(), 0640);
  fs::create_symlink("real", link);
  save_file(link, "new");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(read_file(file), "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms(0640));
}

TEST_F(FileTest, ANameOfTheGreatestLength) {
  const fs::path file = folder / std::string(255, 'n');
  save_file(file, "x");
  EXPECT_EQ(read_file(file), "x");
}

TEST_F(FileTest, SaysWhatIsWrong) {
  const auto reading = [&](const fs::path& f) { return refusal_of([&] { read_file(f, 10); }); };
  const auto saving = [&](const fs::path& f) { return refusal_of([&] { save_file(f, "x"); }); };
  EXPECT_NE(reading(folder / "none").find("none: cannot be read: no such file"), std::string::npos);
  EXPECT_NE(reading(folder.path()).find("it is a folder"), std::string::npos);
  EXPECT_NE(reading("/dev/zero").find("a device"), std::string::npos);
  save_file(folder / "long", "12345678901");
  EXPECT_NE(reading(folder / "long").find("is larger than"), std::string::npos);
  ::mkfifo((folder / "fifo").c_str(), 0600);
  EXPECT_NE(reading(folder / "fifo").find("is a pipe"), std::string::npos);
  EXPECT_NE(saving(folder / "fifo").find("is a pipe"), std::string::npos);
  EXPECT_NE(saving("/dev/full").find("a device"), std::string::npos);
  EXPECT_NE(saving(folder.path()).find("it is a folder"), std::string::npos);
  EXPECT_NE(saving(folder / "none" / "x").find("no such file or folder"), std::string::npos);
  EXPECT_NE(saving(folder / std::string(256, 'n')).find("too long"), std::string::npos);
}

TEST_F(FileTest, AFullDiskLeavesTheOldFile) {
  const fs::path file = folder / "f";
  save_file(file, "old");
  const pid_t child = ::fork();
  if (child == 0) {  // the limit ends with this process
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const std::string error = refusal_of([&] { save_file(file, std::string(100000, 'x')); });
    ::_exit(error.find("not saved") != std::string::npos ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(read_file(file), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(FileTest, KilledWhileSavingLeavesOldOrNew) {
  const fs::path file = folder / "f";
  const std::string versions[2] = {std::string(300000, 'a'), std::string(200000, 'b')};
  save_file(file, versions[0]);
  for (int round = 0; round < 50; ++round) {
    const pid_t child = ::fork();
    if (child == 0)
      for (int i = 0;; ++i) save_file(file, versions[i % 2]);
    ::usleep(useconds_t(300 + 131 * round));
    ::kill(child, SIGKILL);
    ASSERT_EQ(::waitpid(child, nullptr, 0), child);
    const std::string now = read_file(file);
    ASSERT_TRUE(now == versions[0] || now == versions[1]) << round;
  }
}

}  // namespace
}  // namespace cg
