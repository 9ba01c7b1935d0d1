// What both OpenGL techniques draw: the visible objects with their surfaces and matrices, and which parts of the
// light model a scene uses at all.
#pragma once
#include <vector>

#include "scene/frame.h"
#include "scene/pass_recorder.h"
#include "scene/plan.h"
#include "scene/scene.h"
#include "shading/ambient_term.h"
#include "shading/eye_normal.h"
#include "shading/layer_uv.h"
#include "shading/light_parts.h"
#include "shading/surface.h"

namespace cg {

struct DrawItem {
  int object;  // into Scene::objects
  SurfaceHandle surface;
  const Material* material;  // of the scene that was given
  glm::dmat4 object_to_eye;  // without Surface::to_mesh()
  glm::mat4 surface_to_eye;  // with it
};

// The visible objects that have triangles. Left out are objects whose mesh is not loaded or whose matrices are not
// finite in float, as the software technique does.
std::vector<DrawItem> draw_list(const Scene& scene, const View& view, DrawnBy by = DrawnBy::light_model);

// The layers of textures that the item is drawn with, and which of its surface's uv each has.
LayerUv drawn_layers(const Scene& scene, const DrawItem& item, DrawnBy by = DrawnBy::light_model);

// The surfaces of the list, each once: their bytes go to `record` as "surfaces", and those of their radiosity and of
// their uv, with the bytes of OpenGL's buffers for them, as "radiosity" and "uv" where there are any.
void record_surfaces(const std::vector<DrawItem>& items, bool kept, std::size_t radiosity_buffers,
                     std::size_t uv_buffers, PassRecorder& record);

}  // namespace cg
