// What the effects of mistakes are computed from: the scene's lights and surfaces in world and eye coordinates.
#pragma once
#include "scene/frame.h"
#include "shading/light_model.h"
#include "shading/surface.h"
#include "workbench/mistake_effects.h"

namespace cg {

struct MistakeObject {
  int index = 0;
  SurfaceHandle surface;
  glm::dmat4 to_world{1};        // surface coordinates
  std::vector<glm::dvec3> box;   // the 8 corners of its box, world
  glm::dvec3 middle{0};          // of the box, world
  std::vector<glm::dvec3> P, N;  // its vertices in eye coordinates
};

struct MistakeScene {
  explicit MistakeScene(const Scene& scene);
  const Scene& scene;
  glm::dmat4 view;
  EyeLighting<double> world_lights, eye_lights;  // the lights that are on; world: as if eye and world were the same
  std::vector<MistakeObject> objects;            // the visible ones
};

// Three significant digits.
std::string short_number(double v);
std::string percent(double share);
inline double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return degrees(std::atan2(glm::length(glm::cross(unit(a), unit(b))), glm::dot(unit(a), unit(b))));
}

// Each is one line of the table in mistake_effects.h. Where there is no light, or nothing to see, mistake_effect says
// so without asking them; the last three need no light.
MistakeEffect light_before_view_effect(const MistakeScene& s);
MistakeEffect directional_w_effect(const MistakeScene& s);
MistakeEffect long_light_vector_effect(const MistakeScene& s);
MistakeEffect no_gate_effect(const MistakeScene& s);
MistakeEffect no_normalize_effect(const MistakeScene& s);
MistakeEffect flipped_normals_effect(const MistakeScene& s);
MistakeEffect no_normals_effect(const MistakeScene& s);
MistakeEffect no_color_material_effect(const MistakeScene& s);
MistakeEffect no_depth_test_effect(const MistakeScene& s, const View& view);
MistakeEffect swapped_front_face_effect(const MistakeScene& s, const View& view);

}  // namespace cg
