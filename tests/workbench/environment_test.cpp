#include "workbench/environment.h"

#include <gtest/gtest.h>
#include <stdlib.h>

namespace cg {
namespace {

namespace fs = std::filesystem;

class HomeFolder : public testing::Test {
 protected:
  HomeFolder() { ::setenv("HOME", "/home/学生 A", 1); }
  ~HomeFolder() override {
    if (home_) ::setenv("HOME", home_->c_str(), 1);
  }

 private:
  std::optional<std::string> home_ = ::getenv("HOME") ? std::optional<std::string>(::getenv("HOME")) : std::nullopt;
};

TEST_F(HomeFolder, ATypedFileMayBeginAtHome) {
  EXPECT_EQ(typed_path("~/scene.c"), fs::path("/home/学生 A/scene.c"));
  EXPECT_EQ(typed_path("~scene.c"), fs::path("~scene.c"));
  EXPECT_EQ(typed_path("a/~/b"), fs::path("a/~/b"));
  EXPECT_EQ(typed_path(""), fs::path());
}

TEST_F(HomeFolder, AFileIsShownAsAPersonFindsIt) {
  EXPECT_EQ(shown_path("/home/学生 A/x/../scene.c"), "~/scene.c");
  EXPECT_EQ(shown_path("/home/学生 Ab/scene.c"), "/home/学生 Ab/scene.c");
  EXPECT_EQ(shown_path("scene.c"), (fs::current_path() / "scene.c").string());
  ::setenv("HOME", "/", 1);
  EXPECT_EQ(shown_path("/tmp/a"), "/tmp/a");
  ::unsetenv("HOME");
  EXPECT_EQ(typed_path("~/a"), fs::path("~/a"));
  EXPECT_EQ(shown_path("/tmp/a"), "/tmp/a");
}

}  // namespace
}  // namespace cg
