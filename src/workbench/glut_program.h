// The parts of an exported GLUT program that are the same for every scene, as C89 text.
#pragma once
#include <string_view>

namespace cg {

// Each {{English|Japanese}} in them stands for one of the two.

// The matrix `matrix` in double, and translate, rotate and scale, which multiply it; perspective or orthographic; dot
// and normalize; look_at. The formulas are those of math/transform.cpp in their order, so that they come to the same
// bits.
extern const std::string_view glut_matrices, glut_perspective, glut_orthographic, glut_vectors, glut_look_at;

// What stands around the transform of an object. Needs the variables view and model_angle.
extern const std::string_view glut_modelview;

// read_obj: the meshes of an OBJ as export_obj writes them, into arrays of triangles. Needs the constants `meshes` and
// MOST_CORNERS.
extern const std::string_view glut_meshes;

// The window: orbiting with the mouse, turning the light or the model, saving the picture, main(). Needs set_state(),
// draw_scene(), and the variables eye, target, up, aspect, light_angle and model_angle.
extern const std::string_view glut_window;

}  // namespace cg
