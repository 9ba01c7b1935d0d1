// What the parts of gl_calls build their list with.
#pragma once
#include "shading/ambient_term.h"
#include "shading/gl_calls.h"

namespace cg {

inline constexpr double gl_largest_shininess = 128, gl_smallest_shininess = 1e-6;

// A number that the call has whatever the scene is.
inline GlNumber fixed(double value) { return {.value = value, .path = {}}; }

// NaN is 0, and what is infinite the largest float.
double finite(double x);

std::vector<GlNumber> vector_numbers(const std::string& path, const glm::dvec3& v);

struct GlCallList {
  std::vector<GlCall> calls;
  GlSection section = GlSection::state;  // of what is added next

  // The reference lives until the next call is added.
  GlCall& add(std::string_view function, std::vector<std::string> tokens);
  // A call that takes an array of four numbers: v and `fourth`.
  GlCall& add_array(std::string_view function, std::vector<std::string> tokens, std::string variable,
                    const std::string& path, const glm::dvec3& v, const GlNumber& fourth, Quantity quantity);
};

// Whether the program calls glColor: as the scene says, or because of the mistake.
inline bool follows_color(const Scene& scene) {
  return scene.shading.color_material != ColorMaterial::off || scene.mistakes.no_color_material;
}

void add_light_calls(const Scene& scene, GlCallList& list);
// The solution that the calls draw; null: none.
inline const RadiosityField* field_of_calls(const Scene& scene) { return drawn_field(scene, DrawnBy::fixed_function); }

void add_object_calls(const Scene& scene, GlCallList& list);
// The texture units of an object; `units_on`: how many the object before it left on, and this one leaves.
void add_texture_calls(const Scene& scene, int object, int& units_on, GlCallList& list);
// Of each corner, in the body of draw_mesh.
void add_texture_coordinates(const Scene& scene, GlCallList& list);

}  // namespace cg
