// What an ordinary program does not do, and gl-fixed does where a scene's numbers would leave float's range or lose
// the picture in its rounding: lights sent relative to the eye, another unit of length, far lights as directions.
#pragma once
#include <vector>

#include "gl/draw_list.h"

namespace cg {

// The unit of length in OpenGL's eye space is 1/`eye_unit` metres: a power of two that keeps an object of extreme
// size inside float's range (Mesa takes a matrix with a determinant below 1e-25 for singular). 1 for ordinary objects.
double eye_unit(const glm::dmat4& surface_to_eye, double surface_radius, NormalLength length);

// `projection` and `modelview` in that unit; their product is the same to the bit.
glm::mat4 projection_in_unit(glm::mat4 projection, double eye_unit);
glm::mat4 modelview_in_unit(glm::mat4 modelview, double eye_unit);

// Whether the lights may be sent as the list of calls says: world position times the view matrix, both in float. That
// is off by about 3 ulp of the larger of the light's and the eye's distance from the origin, where vertices are off by
// 1 ulp of their distance from the eye. So those may be at most 16 times what the picture itself is wide: the larger
// of the distances eye-light and eye-object. The angle of L is then off by 3e-6 where the light is as far from the
// surface as the eye is. Numbers whose squares leave float are not for the list either.
bool lights_as_listed(const Scene& scene, const EyeLighting<double>& lighting, const std::vector<DrawItem>& items);

// Sends the first 8 lights, and switches the others off. The modelview matrix is changed: glLight multiplies
// positions by the camera's rotation, relative to the eye, so that far offsets survive float.
void send_lights_from_eye(const Scene& scene, const EyeLighting<double>& lighting, double eye_unit);

// The light of an object as it is sent in the end, in numbers of OpenGL: `as_listed`, or relative to the eye, where
// far lights are directions and their attenuation is in their colours.
EyeLighting<float> lighting_as_sent(const EyeLighting<double>& lighting, bool as_listed, double eye_unit);

// Sends the emission once more where emission and ambient light come to NaN, with no light as its cause: clamped,
// OpenGL would make it white, where the other techniques make it black.
bool is_emission_of_nan(const EyeMaterial<double>& m, const EyeLighting<double>& lighting);
void send_emission_of_nan(const EyeMaterial<double>& m, const EyeLighting<double>& lighting);

// What a user should know about the limits that this scene meets.
std::vector<Text> fixed_function_notes(const Scene& scene, const EyeLighting<double>& lighting,
                                       const std::vector<DrawItem>& items);

}  // namespace cg
