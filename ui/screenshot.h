// The window as a picture in a file, for the README and for looking at what it draws.
#pragma once
#include <string>

#include "image/display.h"

struct GLFWwindow;

namespace cg {

struct App;

// What the window's next swap will show.
Picture window_picture(GLFWwindow* window);

class Screenshot {
 public:
  // `file` is a .png; empty: never wanted.
  explicit Screenshot(std::string file) : file_(std::move(file)) {}
  // True when both pictures stand and all texts have their glyphs, or after 20 s.
  bool wanted(App& app, bool fonts_busy);
  // Reads the back buffer. Throws InputError where the file cannot be written.
  void take(GLFWwindow* window) const;

 private:
  std::string file_;
  int calm_ = 0;
};

}  // namespace cg
