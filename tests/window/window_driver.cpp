#include "window/window_driver.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>

#include "params/file.h"
#include "params/input_error.h"

namespace cg {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

void pause(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

bool has_program(const char* name) {
  return std::system(("command -v " + std::string(name) + " >/dev/null 2>&1").c_str()) == 0;
}

// Starts a program; what it writes goes to `log`.
pid_t start(const std::vector<std::string>& words, const std::vector<std::pair<std::string, std::string>>& environment,
            const fs::path& folder, const fs::path& log, int keep = -1) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  ::setpgid(0, 0);
  if (::chdir(folder.c_str()) != 0) ::_exit(126);
  const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(out, 1), ::dup2(out, 2);
  if (keep >= 0) ::fcntl(keep, F_SETFD, 0);
  for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ::execvp(arguments[0], arguments.data());
  ::_exit(127);
}

void stop(pid_t& child) {
  if (child <= 0) return;
  ::kill(child, SIGTERM);
  for (int i = 0; i < 100; ++i) {
    if (::waitpid(child, nullptr, WNOHANG) == child) {
      child = -1;
      return;
    }
    pause(0.02);
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  child = -1;
}

// Servers that start and end at the same moment take each other's display away.
class StartsAlone {
 public:
  explicit StartsAlone(const fs::path& file) : lock_(::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600)) {
    ::flock(lock_, LOCK_EX);
  }
  ~StartsAlone() { ::close(lock_); }
  StartsAlone(const StartsAlone&) = delete;
  StartsAlone& operator=(const StartsAlone&) = delete;

 private:
  int lock_;
};

// The number that Xvfb writes when it is ready.
std::string read_display(int fd) {
  std::string out;
  pollfd wait{fd, POLLIN, 0};
  char c = 0;
  while (::poll(&wait, 1, 20000) > 0 && ::read(fd, &c, 1) == 1 && c != '\n') out += c;
  return out.empty() ? "" : ":" + out;
}

}  // namespace

bool can_drive_windows() { return has_program("Xvfb") && has_program("xdotool"); }

WindowDriver::WindowDriver(int width, int height, fs::path home, std::vector<std::string> options)
    : home_(std::move(home)), state_file_(home_ / "state.json"), width_(width), height_(height) {
  fs::create_directories(home_);
  fs::remove(state_file_);
  int pipe[2];
  if (::pipe2(pipe, O_CLOEXEC) != 0) throw std::runtime_error("pipe");
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  const StartsAlone alone(home_.parent_path() / "display.lock");
  server_ = start({"Xvfb", "-displayfd", std::to_string(pipe[1]), "-screen", "0", size + "x24", "-nolisten", "tcp"}, {},
                  home_, home_ / "xvfb.log", pipe[1]);
  ::close(pipe[1]);
  display_ = read_display(pipe[0]);
  ::close(pipe[0]);
  if (display_.empty()) throw std::runtime_error("Xvfb does not start: see " + (home_ / "xvfb.log").string());
  const std::string below = home_.string();
  const std::vector<std::pair<std::string, std::string>> environment{{"DISPLAY", display_},
                                                                     {"HOME", below},
                                                                     {"XDG_CONFIG_HOME", below + "/config"},
                                                                     {"XDG_STATE_HOME", below + "/state"},
                                                                     {"XDG_CACHE_HOME", below + "/cache"},
                                                                     {"XDG_DATA_HOME", below + "/data"},
                                                                     {"LANG", "C.UTF-8"},
                                                                     {"LC_ALL", "C.UTF-8"},
                                                                     {"SHADEBENCH_DATA", SHADEBENCH_SOURCE_DIR}};
  options.insert(options.begin(), {SHADEBENCH_PROGRAM, "--size", size, "--state", state_file_.string()});
  program_ = start(options, environment, home_, home_ / "shadebench.log");
}

WindowDriver::~WindowDriver() {
  stop(program_);
  const StartsAlone alone(home_.parent_path() / "display.lock");
  stop(server_);
}

bool WindowDriver::runs() const { return program_ > 0 && ::waitpid(program_, nullptr, WNOHANG) == 0; }

void WindowDriver::tool(const std::string& arguments) const {
  const std::string command = "DISPLAY=" + display_ + " xdotool " + arguments + " >/dev/null 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

void WindowDriver::key(const std::string& name) { tool("key " + name); }
void WindowDriver::type(const std::string& text) { tool("type --delay 5 '" + text + "'"); }

void WindowDriver::move(double x, double y) {
  tool("mousemove " + std::to_string(int(x)) + " " + std::to_string(int(y)));
}

// A hand waits for what it sees: one frame at least has the pointer there before the button goes down, and one has the
// button down before it goes up.
void WindowDriver::click(double x, double y) {
  move(x, y);
  wait_pointer(x, y, false);
  tool("mousedown 1");
  wait_pointer(x, y, true);
  tool("mouseup 1");
  wait_pointer(x, y, false);
}

void WindowDriver::wait_pointer(double x, double y, bool down) {
  // A pixel's tolerance: the server's places are whole.
  const auto near = [&](std::string_view path, double value) {
    const double* const there = at(state_, path).number();
    return there && std::abs(*there - value) <= 1;
  };
  wait("the pointer at " + std::to_string(int(x)) + ", " + std::to_string(int(y)), [&](const Tree& s) {
    return near("pointer.x", x) && near("pointer.y", y) && at(s, "pointer.down") == Tree(down);
  });
}

void WindowDriver::drag(double x, double y, double dx, double dy) {
  move(x, y);
  wait_pointer(x, y, false);
  tool("mousedown 1");
  wait_pointer(x, y, true);
  for (int i = 1; i <= 4; ++i) {
    pause(0.05);
    move(x + dx * i / 4, y + dy * i / 4);
  }
  wait_pointer(x + dx, y + dy, true);
  tool("mouseup 1");
  wait_pointer(x + dx, y + dy, false);
}

std::array<double, 4> WindowDriver::place(const std::string& control) {
  const auto list = [&](const Tree& s) {
    const Tree* places = s.find("places");
    const Tree* one = places ? places->find(control) : nullptr;
    return one ? one->list() : nullptr;
  };
  if (!wait("the control " + control, [&](const Tree& s) { return list(s) && list(s)->size() == 4; })) return {};
  std::array<double, 4> out{};
  for (std::size_t i = 0; i < 4; ++i) out[i] = *(*list(state_))[i].number();
  return out;
}

void WindowDriver::click(const std::string& control) {
  // What appears above a control moves it: it must still be there when the pointer is.
  for (int i = 0; i < 20; ++i) {
    const auto corners = place(control);
    const double x = 0.5 * (corners[0] + corners[2]), y = 0.5 * (corners[1] + corners[3]);
    move(x, y);
    wait_pointer(x, y, false);
    if (place(control) == corners) return click(x, y);
  }
  ADD_FAILURE() << control << " does not stay where it is";
}

const Tree& WindowDriver::state() {
  try {
    state_ = parse_json(read_file(state_file_), state_file_.string());
  } catch (const InputError&) {  // not there yet; it is replaced whole
  }
  return state_;
}

bool WindowDriver::wait(const std::string& what, const std::function<bool(const Tree&)>& holds, double seconds) {
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  for (;;) {
    if (holds(state())) return true;
    if (!runs()) {
      ADD_FAILURE() << "the program ended while waiting for " << what << ": " << read_file(home_ / "shadebench.log");
      return false;
    }
    if (Clock::now() > end) {
      ADD_FAILURE() << "waited " << seconds << " s for " << what << "; the state: " << to_json(state_, 0);
      screenshot("failed");
      return false;
    }
    pause(0.03);
  }
}

fs::path WindowDriver::screenshot(const std::string& name) {
  pause(0.1);  // what was written to the state is on the screen after the next swap
  const fs::path folder = SHADEBENCH_ARTIFACTS;
  fs::create_directories(folder);
  const fs::path file = folder / (name + ".png");
  const std::string command = "import -display " + display_ + " -window root " + file.string() + " >/dev/null 2>&1";
  if (std::system(command.c_str()) != 0) std::printf("no screenshot %s\n", file.c_str());
  return file;
}

const Tree& at(const Tree& state, std::string_view path) {
  static const Tree none;
  const Tree* here = &state;
  while (here && !path.empty()) {
    const std::size_t dot = std::min(path.find('.'), path.size());
    here = here->find(path.substr(0, dot));
    path.remove_prefix(std::min(dot + 1, path.size()));
  }
  return here ? *here : none;
}

}  // namespace cg
