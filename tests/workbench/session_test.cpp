// The session comes back; damage, missing folders and a full disk are survived and said.
#include "workbench/session.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "params/file.h"
#include "tests/temporary_folder.h"
#include "workbench/environment.h"
#include "workbench/open.h"
#include "workbench/preset.h"

namespace cg {
namespace {

Session sample(double n) {
  Session s;
  s.scene = open_scene("cube");
  s.scene->material.n = n;
  s.source = "cube";
  s.recent = {"cube", "a b/日本.obj"};
  s.window.at("width") = 1280;
  s.settings.at("language") = "ja";
  return s;
}

class SessionTest : public testing::Test {
 protected:
  Session loaded(std::string* messages = nullptr) {
    SessionStore store(folder / "state/shadebench", folder / "config/shadebench");
    const Session session = store.load();
    while (const auto message = store.next_message()) {
      EXPECT_FALSE(message->ja.empty());
      if (messages) *messages += message->en + "\n";
    }
    return session;
  }
  void save(const Session& session) {
    SessionStore store(folder / "state/shadebench", folder / "config/shadebench");
    store.keep(session, 0);
  }
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "state/shadebench/session.json";
};

TEST_F(SessionTest, ComesBack) {
  std::string messages;
  EXPECT_EQ(loaded(&messages), Session{});
  EXPECT_EQ(messages, "");
  save(sample(5));
  EXPECT_EQ(loaded(&messages), sample(5));
  EXPECT_EQ(messages, "");
}

TEST_F(SessionTest, IsSavedAtMostEveryTwoSeconds) {
  SessionStore store(folder / "state/shadebench", folder / "config/shadebench");
  const auto saved = [&] { return std::filesystem::exists(file) ? read_file(file) : ""; };
  store.keep(sample(1), 100);
  store.flush();
  const std::string first = saved();
  EXPECT_NE(first, "");
  store.keep(sample(2), 101);
  EXPECT_EQ(saved(), first);
  store.keep(sample(2), 102.1);
  store.flush();
  EXPECT_NE(saved(), first);
}

TEST_F(SessionTest, DamageFallsBackToTheOneBefore) {
  save(sample(1));
  save(sample(2));
  const std::string whole = read_file(file);
  std::string messages;
  for (std::size_t i = 0; i < whole.size(); i += 7) {
    std::string bad = whole;
    bad[i] = char(bad[i] ^ 1);
    save_file(file, bad);
    const Session session = loaded(&messages);
    ASSERT_TRUE(session == sample(1) || session == sample(2)) << i;
  }
  EXPECT_NE(messages.find("the one saved before it is shown"), std::string::npos);
  for (const std::string& bad : {std::string(), whole.substr(0, whole.size() / 2), std::string("\0\xff{", 3)}) {
    save_file(file, bad);
    EXPECT_EQ(loaded(), sample(1));
  }
  std::filesystem::remove(file);
  EXPECT_EQ(loaded(), sample(1));
  save_file(folder / "state/shadebench/session.previous.json", "{");
  save_file(file, "{");
  messages.clear();
  Session rest;
  rest.settings = sample(1).settings;  // in another file
  EXPECT_EQ(loaded(&messages), rest);
  EXPECT_NE(messages.find("the defaults are used"), std::string::npos);
}

TEST_F(SessionTest, AModelThatIsGoneIsSaid) {
  save_file(folder / "t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  Session session = sample(1);
  session.scene = open_scene((folder / "t.obj").string());
  save(session);
  session = Session{};  // nobody holds the mesh
  std::filesystem::remove(folder / "t.obj");
  std::string messages;
  session = loaded(&messages);
  EXPECT_FALSE(session.scene);
  EXPECT_EQ(session.source, "cube");
  EXPECT_NE(messages.find("t.obj"), std::string::npos) << messages;

  // Twice saved since, the scene is still there, and opens when its model has come back.
  save(sample(2)), save(sample(3));
  save_file(folder / "t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Scene kept = read_preset(folder / "state/shadebench/unopened-scene.json");
  EXPECT_EQ(kept.objects.at(0).mesh->triangles().size(), 1u);
}

TEST_F(SessionTest, WithoutFoldersNothingIsSavedAndThatIsSaid) {
  SessionStore store(std::nullopt, std::nullopt);
  EXPECT_TRUE(store.next_message());
  EXPECT_EQ(store.load(), Session{});
  store.keep(sample(1), 10);
  EXPECT_FALSE(store.next_message());

  save_file(folder / "file", "");
  SessionStore blocked(folder / "file/state", folder / "file/config");  // cannot be made
  EXPECT_TRUE(blocked.next_message());
  blocked.keep(sample(1), 10);
  blocked.flush();
}

TEST_F(SessionTest, AFailureIsSaidOnce) {
  std::filesystem::create_directories(folder / "state/shadebench/session.json");  // a folder: cannot be replaced
  SessionStore store(folder / "state/shadebench", folder / "config/shadebench");
  for (int i = 0; i < 3; ++i) {
    store.keep(sample(i + 1), 10 * i);
    store.flush();
  }
  const auto message = store.next_message();
  ASSERT_TRUE(message);
  EXPECT_NE(message->en.find("Not saved"), std::string::npos);
  EXPECT_FALSE(store.next_message());
}

TEST_F(SessionTest, ASecondWindowReadsButDoesNotSave) {
  save(sample(1));
  SessionStore first(folder / "state/shadebench", folder / "config/shadebench");
  SessionStore second(folder / "state/shadebench", folder / "config/shadebench");
  EXPECT_TRUE(second.next_message());
  EXPECT_EQ(second.load(), sample(1));
  second.keep(sample(9), 0);
  second.flush();
  EXPECT_EQ(first.load(), sample(1));
}

TEST_F(SessionTest, KilledAtAnyMomentItComesBack) {
  save(sample(1));
  for (int i = 0; i < 25; ++i) {
    const pid_t child = ::fork();
    if (child == 0) {
      SessionStore store(folder / "state/shadebench", folder / "config/shadebench");
      for (int n = 1;; ++n) {
        store.keep(sample(n % 50 + 1), 10.0 * n);
        store.flush();
      }
    }
    ::usleep(useconds_t(3000 + 700 * i));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const Session back = loaded();
    ASSERT_TRUE(back.scene) << i;
    EXPECT_EQ(back.recent, sample(1).recent);
  }
}

TEST(Recent, NewestFirstOnceAndBounded) {
  std::vector<std::string> recent;
  for (int i = 0; i < 20; ++i) add_recent(recent, std::to_string(i));
  add_recent(recent, "15");
  EXPECT_EQ(recent.size(), 12u);
  EXPECT_EQ(recent[0], "15");
  EXPECT_EQ(recent[1], "19");
}

TEST(Environment, LanguageAndFolders) {
  const auto set = [](const char* name, const char* value) { ::setenv(name, value, 1); };
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) set(name, "");
  EXPECT_EQ(language_of_environment(), Language::english);
  set("LANG", "ja_JP.UTF-8");
  EXPECT_EQ(language_of_environment(), Language::japanese);
  set("LC_ALL", "C");
  EXPECT_EQ(language_of_environment(), Language::english);
  set("XDG_STATE_HOME", "/x y");
  EXPECT_EQ(state_folder(), "/x y/shadebench");
  set("XDG_STATE_HOME", "relative");
  set("HOME", "/家");
  EXPECT_EQ(state_folder(), "/家/.local/state/shadebench");
  ::unsetenv("HOME");
  EXPECT_EQ(state_folder(), std::nullopt);
}

}  // namespace
}  // namespace cg
