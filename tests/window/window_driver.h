// Drives the real window under a virtual X server as a person does, by keys and the mouse, and reads what it shows from
// the file that --state writes.
#pragma once
#include <sys/types.h>

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "params/tree.h"

namespace cg {

// Whether there is what it needs: Xvfb and xdotool.
bool can_drive_windows();

class WindowDriver {
 public:
  // Starts a server with a screen of that size and the program in it, with a home of its own in `home`. Fails the test
  // where either does not start.
  WindowDriver(int width, int height, std::filesystem::path home, std::vector<std::string> options = {});
  ~WindowDriver();
  WindowDriver(const WindowDriver&) = delete;
  WindowDriver& operator=(const WindowDriver&) = delete;

  // As xdotool calls them: "Page_Down", "ctrl+z".
  void key(const std::string& name);
  void type(const std::string& text);
  void move(double x, double y);
  void click(double x, double y);
  void drag(double x, double y, double dx, double dy);
  // On the middle of a control, once it is there.
  void click(const std::string& control);
  std::array<double, 4> place(const std::string& control);

  // The newest state.
  const Tree& state();
  // Reads until `holds` or `seconds` are over; then the test has failed, and says `what` was waited for.
  bool wait(const std::string& what, const std::function<bool(const Tree&)>& holds, double seconds = 15);

  // The screen, kept as an artifact of that name.
  std::filesystem::path screenshot(const std::string& name);
  const std::filesystem::path& home() const { return home_; }
  bool runs() const;

 private:
  void tool(const std::string& arguments) const;
  // Until a frame has seen the pointer there, with the button so.
  void wait_pointer(double x, double y, bool down);

  std::filesystem::path home_, state_file_;
  int width_ = 0, height_ = 0;
  std::string display_;
  pid_t server_ = -1, program_ = -1;
  Tree state_;
};

// The value at a path of the state: "lesson.place"; null where there is none.
const Tree& at(const Tree& state, std::string_view path);

}  // namespace cg
