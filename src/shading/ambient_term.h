// Where the ambient term of a scene comes from: I_a k_a and the lights' I_ai k_a, or the radiosity solution that stands
// in for them. One answer for all techniques:
//
//   I = E + B_r + sum_i att_i spot_i [ I_di k_d (N.L_i) + f_i I_si k_s (N.H_i)^n ],  B_r = B/pi - E at each corner
//
// This work is based on: Cindy Goral, Kenneth Torrance, Donald Greenberg, Bennett Battaile, Modeling the Interaction of
// Light Between Diffuse Surfaces, 1984 (radiosity as the colour of vertices, interpolated).
#pragma once
#include "scene/only_plain.h"
#include "shading/light_model.h"
#include "shading/surface.h"

namespace cg {

// Whose picture: with some mistakes the program for the fixed function keeps the constant term.
enum class DrawnBy { light_model, fixed_function };

// The solution that is drawn; null where the ambient term is constant: as the scene says, or because there is no
// solution, or one of other objects or meshes, or one with numbers that are not finite.
const RadiosityField* drawn_field(const Scene& scene, DrawnBy by = DrawnBy::light_model);

// Whether it is drawn, and why or why not, for a plan.
struct AmbientReason {
  bool drawn = false;
  Text text;
};
AmbientReason ambient_reason(const Scene& scene, DrawnBy by = DrawnBy::light_model);

// What is drawn of an object: its elements in `field`, or its own mesh. Null where it is not loaded.
MeshHandle drawn_mesh(const Scene& scene, std::size_t object, const RadiosityField* field);

// The same as a surface, from surface_cache(), with the light of its vertices where the field has some and the uv that
// its layers of textures need (layer_uv()); the mesh is not null.
SurfaceHandle drawn_surface(const Scene& scene, std::size_t object, const RadiosityField* field);

// The scene with the meshes that are drawn: for whoever asks which triangle is which, or draws lines over it.
Scene with_drawn_meshes(Scene scene);

// The k of an object that is drawn as `surface`: a solution leaves no k_a.
template <class Real>
EyeMaterial<Real> drawn_material(const Scene& scene, const Object& object, const Surface& surface) {
  EyeMaterial<Real> m = eye_material<Real>(material_of(scene, object), scene.shading.color_material);
  if (optional(!surface.radiosity.empty())) m.k_a = Vec3<Real>(Real(0));
  return m;
}

}  // namespace cg
