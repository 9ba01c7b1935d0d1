// The light model as the fixed function is told it: glLight, glMaterial, glLightModel, within OpenGL's limits.
// The OpenGL Graphics System 2.1, section 2.14.
#pragma once
#include <vector>

#include "shading/light_model.h"

namespace cg {

// The unit of length in OpenGL's eye space is 1/`eye_unit` metres: a power of two that keeps an object of extreme
// size inside float's range (Mesa takes a matrix with a determinant below 1e-25 for singular). 1 for ordinary objects.
double eye_unit(const glm::dmat4& surface_to_eye, double surface_radius, NormalLength length);

// `projection` and `modelview` in that unit; their product is the same to the bit.
glm::mat4 projection_in_unit(glm::mat4 projection, double eye_unit);
glm::mat4 modelview_in_unit(glm::mat4 modelview, double eye_unit);

// Sends the first 8 lights, and switches the others off. The modelview matrix is changed: glLight multiplies
// positions by the camera's rotation, relative to the eye, so that far offsets survive float.
void send_lights(const Scene& scene, const EyeLighting<double>& lighting, double eye_unit);

void send_light_model(const Shading& shading, bool two_sided, bool local_viewer);

void send_material(const Material& material, ColorMaterial tracked, const EyeLighting<double>& lighting);

// What a user should know about the limits that this scene meets.
std::vector<Text> fixed_function_notes(const Scene& scene, const EyeLighting<double>& lighting);

}  // namespace cg
