// The two pictures and what is kept of them from frame to frame.
#pragma once
#include <array>

#include "ui/overlay_renderer.h"
#include "ui/pane_gestures.h"
#include "ui/pane_jobs.h"
#include "ui/probe_jobs.h"

namespace cg {

struct App;

// Made and destroyed while the window's OpenGL context is current.
class Panes {
 public:
  explicit Panes(const App& app);
  // At ImGui's cursor, `size` pixels.
  void draw(App& app, ImVec2 size);
  const PaneJobs& jobs() const { return jobs_; }
  // The drawings whose pixels are on the textures now.
  const DrawingHandle& on_screen(int side) const { return on_screen_[std::size_t(side)]; }
  // How long the last frame took to give work to the techniques and to take their pictures.
  double exchange_ms() const { return exchange_ms_; }

 private:
  struct LineCall {  // what the drawing of the lines needs when ImGui comes to it
    Panes* panes;
    int side;
    Place place;
    std::array<float, 4> clip;
    std::vector<Lines> more;
    std::function<LineStyle(Mark)> style;
  };

  void keep_camera(App& app, double aspect);
  std::array<Place, 2> places(App& app, ImVec2 at, ImVec2 size) const;
  void submit(App& app, const Place& place);
  void take_pictures(App& app);
  void ask_probes(App& app);
  void upload(int side);
  void report(App& app);

  void paint_pane(App& app, int side, const Place& place);
  void paint_wipe(App& app, const Place& place);
  void paint_flip(App& app, const Place& place);
  void paint_difference(App& app, const Place& place);
  void paint_picture(App& app, const Texture& texture, const Place& place, float from, float to);
  void paint_lines(App& app, int side, const Place& place);
  void paint_handles(App& app, const Place& place);
  void paint_probe(App& app, int side, const Place& place);
  void paint_cursor(App& app, const Place& place);
  void paint_message(App& app, int side, const Place& place);
  void paint_footer(App& app, int side, ImVec2 at, float width);
  void paint_both_footers(App& app, const Place& place);
  void paint_name(App& app, int side, ImVec2 at, bool from_right);
  void paint_gain(App& app, const Place& place);
  void paint_legend(App& app, const Place& place);
  void paint_worst(App& app, const Place& place);
  static void draw_lines(const ImDrawList* list, const ImDrawCmd* command);

  PaneJobs jobs_;
  ProbeJobs probes_;
  std::array<std::uint64_t, 2> probed_from_{};  // serials of the pictures that may be probed
  std::array<Texture, 2> pictures_, depths_;
  Texture difference_;
  std::array<DrawingHandle, 2> on_screen_, depth_of_;
  std::shared_ptr<const Compared> shown_difference_;
  std::shared_ptr<const MeshOverlay> kept_lines_;
  OverlayRenderer renderer_;
  std::array<LineCall, 2> line_calls_;
  Region region_;
  Gesture gesture_;
  Pointing pointing_;
  std::optional<Camera> last_camera_;
  int flipped_ = 0;         // the side that flip shows
  bool auto_flip_ = false;  // every 0.7 s the other
  double flipped_at_ = 0;
  ImVec2 area_{0, 0};  // from x to x: all that the panes have
  double exchange_ms_ = 0;
  int largest_ = 4096;  // side of a texture
};

}  // namespace cg
