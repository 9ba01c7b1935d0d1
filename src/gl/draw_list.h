// What both OpenGL techniques draw: the visible objects with their surfaces and matrices, and which parts of the
// light model a scene uses at all.
#pragma once
#include <vector>

#include "scene/frame.h"
#include "scene/plan.h"
#include "scene/scene.h"
#include "shading/eye_normal.h"
#include "shading/light_model.h"
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
std::vector<DrawItem> draw_list(const Scene& scene, const View& view);

// What the scene's lights and materials use of the light model.
struct UsedTerms {
  bool diffuse = false, specular = false;  // some light and some material have it
  bool point = false, directional = false;
  bool attenuation = false, spot = false, eye_position = false;
  bool normal() const { return diffuse || specular; }
};
UsedTerms used_terms(const EyeLighting<double>& lighting, const EyeMaterial<double>& material);
// Over all visible objects.
UsedTerms used_terms(const Scene& scene);

}  // namespace cg
