// The scene from outside: the camera with what it sees, the lights, the mesh and the probed point, by a camera of its
// own. Lights and the scene's camera are dragged in it.
#pragma once
#include <memory>

#include "ui/clip_edges.h"
#include "ui/overlay_renderer.h"
#include "ui/pane_place.h"
#include "ui/texture.h"
#include "workbench/job.h"
#include "workbench/picking.h"

namespace cg {

struct App;

// Made and destroyed while the window's OpenGL context is current.
class WorldView {
 public:
  explicit WorldView(const App& app);
  // At ImGui's cursor, `size` pixels. `divided`: after the division by w, where the clip volume is a cube.
  void draw(App& app, ImVec2 size, bool divided);

 private:
  // What is taken hold of.
  struct Grab {
    enum Kind { none, orbit, pan, light, eye, target } kind = none;
    ImVec2 start{0, 0};
    Handle handle;
    Light before;
    glm::dvec3 point{0};  // of the scene's camera, as it was
    bool along_view = false;
  };
  struct LineCall {
    WorldView* view;
    Place place;
    std::array<float, 4> clip;
    std::vector<Lines> lines;
    float scale = 1;
    Camera camera;
    bool divided = false;
  };

  void submit(App& app, const Place& place);
  void take_mouse(App& app, const Place& place);
  void begin(App& app, const Place& place);
  void go_on(App& app, const Place& place);
  void drag_camera(App& app, const Place& place);
  void draw_divided(App& app, const Place& place);
  void paint(App& app, const Place& place);
  void paint_lines(App& app, const Place& place);
  void add_line_call(const Place& place);
  void paint_marks(App& app, const Place& place);
  Scene seen_from_here(const App& app) const;
  static void draw_lines(const ImDrawList* list, const ImDrawCmd* command);

  std::unique_ptr<Job> job_;
  Request asked_;
  bool has_asked_ = false;
  DrawingHandle shown_, depth_of_;
  Texture picture_, depth_;
  OverlayRenderer renderer_, divided_renderer_;
  LineCall call_;
  ClipEdges clip_edges_;
  std::shared_ptr<const Lines> kept_edges_;
  std::optional<Camera> camera_, divided_camera_;  // of the world, of the cube; nothing before the first picture
  Grab grab_;
  std::optional<Handle> pointed_;  // the light under the mouse
  Grab::Kind pointed_end_ = Grab::none;
};

}  // namespace cg
