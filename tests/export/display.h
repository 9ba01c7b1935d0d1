// A display of a test's own and programs that run on it.
#pragma once
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cg {

// A child process, ended with its object.
class Process {
 public:
  // `inherited`: a descriptor that the child keeps open besides 0, 1 and 2; -1: none.
  Process(const std::filesystem::path& folder, std::vector<std::string> words,
          const std::vector<std::pair<std::string, std::string>>& environment = {}, int inherited = -1) {
    pid_ = ::fork();
    if (pid_ != 0) return;
    const int log = ::open((folder / "log").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    ::dup2(log, 1), ::dup2(log, 2);
    for (int fd = 3; fd < 256; ++fd)
      if (fd != inherited) ::close(fd);
    for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    if (::chdir(folder.c_str()) == 0) ::execvp(argv[0], argv.data());
    ::_exit(127);
  }
  ~Process() {
    if (!running()) return;
    ::kill(pid_, SIGTERM);
    wait();
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  bool running() {
    if (status_ < 0 && ::waitpid(pid_, &raw_, WNOHANG) == pid_) take_status();
    return status_ < 0;
  }
  // The exit status; 128 where it was killed.
  int wait() {
    if (status_ < 0 && ::waitpid(pid_, &raw_, 0) == pid_) take_status();
    return status_;
  }
  pid_t pid() const { return pid_; }

 private:
  void take_status() { status_ = WIFEXITED(raw_) ? WEXITSTATUS(raw_) : 128; }
  pid_t pid_ = -1;
  int raw_ = 0, status_ = -1;
};

inline bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

// An X server without a screen; it chooses its number itself.
class XServer {
 public:
  explicit XServer(const std::filesystem::path& folder) {
    int ends[2];
    if (::pipe(ends) != 0) return;
    server_.emplace(folder,
                    std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0",
                                             "1024x768x24", "-nolisten", "tcp"},
                    std::vector<std::pair<std::string, std::string>>{}, ends[1]);
    ::close(ends[1]);
    char c = 0;
    while (::read(ends[0], &c, 1) == 1 && c != '\n') number_ += c;
    ::close(ends[0]);
  }
  // ":99"; empty where there is none.
  std::string name() const { return number_.empty() ? "" : ":" + number_; }

 private:
  std::optional<Process> server_;
  std::string number_;
};

}  // namespace cg
