// Runs the program as a person would, and keeps what it says.
#pragma once
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "params/file.h"
#include "tests/temporary_folder.h"

namespace cg {

struct Outcome {
  int status = -1;  // the exit status; -signal where it was killed
  std::string out, err;
  // Lines of `err`.
  std::size_t error_lines() const { return std::size_t(std::count(err.begin(), err.end(), '\n')); }
};

using Environment = std::map<std::string, std::string>;

// Runs `program` in `folder` with the arguments, no display, and these variables beside the usual ones. An empty value
// takes a variable away.
inline Outcome run_program(const std::string& program, const TemporaryFolder& folder,
                           const std::vector<std::string>& arguments, const Environment& environment = {}) {
  const auto out = folder / ".out", err = folder / ".err";
  const pid_t child = ::fork();
  if (child == 0) {
    for (const auto& [name, file] : {std::pair(1, out), {2, err}}) {
      const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      if (fd < 0 || ::dup2(fd, name) < 0) ::_exit(126);
    }
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "LC_ALL", "LC_MESSAGES", "LANG"}) ::unsetenv(name);
    ::setenv("HOME", folder.path().c_str(), 1);
    for (const char* name : {"XDG_CACHE_HOME", "XDG_STATE_HOME", "XDG_CONFIG_HOME"}) ::unsetenv(name);
    for (const auto& [name, value] : environment)
      value.empty() ? ::unsetenv(name.c_str()) : ::setenv(name.c_str(), value.c_str(), 1);
    if (::chdir(folder.path().c_str()) != 0) ::_exit(126);
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    ::execv(program.c_str(), argv.data());
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read_file(out), read_file(err)};
}

}  // namespace cg
