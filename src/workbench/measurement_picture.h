// What measurements share: pictures, and coordinates.
#pragma once
#include "workbench/measurement.h"

namespace cg {

// The scene as the options want it: the camera turned, one term of one light alone.
Scene as_asked(const Scene& scene, const MeasurementOptions& options);

// A square picture of `scene` as it is asked for, with normals. Throws InputError where the technique cannot, or where
// the picture is empty.
Frame picture_for(const MeasureInput& in, const Scene& scene, std::string_view technique);

// One channel of a colour, or the mean of the three.
double channel_of(const glm::vec3& colour, Channel channel);

// Of the options' place: the pixel, counted from the top-left corner.
glm::ivec2 pixel_of(const MeasurementOptions& options);

// Throws InputError: the picture shows no surface where it was looked for.
[[noreturn]] void nothing_there();

// A world point in the coordinates of `space`; w is 1 but for clip coordinates. `size` of the square picture. Window
// coordinates have y up and depth 0..1, as OpenGL's.
glm::dvec4 in_space(const glm::dvec3& world, Space space, const Scene& scene, int object, int size);

double component_of(const glm::dvec4& v, Component component);

// The measurements of pictures, those of points and vertices, and those of radiosity; measurements() is all of them.
std::span<const Measurement> picture_measurements();
std::span<const Measurement> point_measurements();
std::span<const Measurement> radiosity_measurements();

// The scene's object of that index. Throws InputError where there is none.
const Object& object_at(const Scene& scene, int index);

}  // namespace cg
