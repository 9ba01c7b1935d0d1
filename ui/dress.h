// Keeps style and fonts as the settings, the monitor and the texts ask for. Fonts are built on a thread of their own:
// the window opens, and later goes on, while they are.
#pragma once
#include <future>

#include "ui/fonts.h"

namespace cg {

struct App;

class Dress {
 public:
  // Starts to build the fonts for the app's settings and content scale.
  explicit Dress(App& app);
  // Before a frame. The first call waits for the fonts; later ones take new ones when they are there, and until then
  // the old stay, with their scale. Needs ImGui's context and OpenGL.
  void fit(App& app);
  bool busy() const { return pending_.valid(); }
  ~Dress();

 private:
  void start(App& app, float scale);
  void adopt(App& app);

  std::shared_future<std::shared_ptr<const FontFiles>> finding_;
  std::future<std::unique_ptr<BuiltFonts>> pending_;
  std::unique_ptr<BuiltFonts> fonts_;  // what ImGui reads
  Theme theme_ = Theme::dark;
  Language language_ = Language::english;
};

}  // namespace cg
