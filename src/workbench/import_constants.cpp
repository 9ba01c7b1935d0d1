#include "workbench/import_constants.h"

#include <array>

namespace cg {

namespace {

struct Constant {
  std::string_view name;
  int value;
};

// Those with a meaning to a scene stand first: gl_constant_name finds them.
constexpr std::array<Constant, 88> constants{{{"GL_FRONT", gl_constant::front},
                                              {"GL_BACK", gl_constant::back},
                                              {"GL_FRONT_AND_BACK", gl_constant::front_and_back},
                                              {"GL_CW", gl_constant::cw},
                                              {"GL_CCW", gl_constant::ccw},
                                              {"GL_COLOR_MATERIAL", gl_constant::color_material},
                                              {"GL_LIGHTING", gl_constant::lighting},
                                              {"GL_LIGHT_MODEL_LOCAL_VIEWER", gl_constant::light_model_local_viewer},
                                              {"GL_LIGHT_MODEL_TWO_SIDE", gl_constant::light_model_two_side},
                                              {"GL_LIGHT_MODEL_AMBIENT", gl_constant::light_model_ambient},
                                              {"GL_LIGHT_MODEL_COLOR_CONTROL", 0x81F8},
                                              {"GL_CULL_FACE", gl_constant::cull_face},
                                              {"GL_DEPTH_TEST", gl_constant::depth_test},
                                              {"GL_NORMALIZE", gl_constant::normalize},
                                              {"GL_RESCALE_NORMAL", gl_constant::rescale_normal},
                                              {"GL_AMBIENT", gl_constant::ambient},
                                              {"GL_DIFFUSE", gl_constant::diffuse},
                                              {"GL_SPECULAR", gl_constant::specular},
                                              {"GL_POSITION", gl_constant::position},
                                              {"GL_SPOT_DIRECTION", gl_constant::spot_direction},
                                              {"GL_SPOT_EXPONENT", gl_constant::spot_exponent},
                                              {"GL_SPOT_CUTOFF", gl_constant::spot_cutoff},
                                              {"GL_CONSTANT_ATTENUATION", gl_constant::constant_attenuation},
                                              {"GL_LINEAR_ATTENUATION", gl_constant::linear_attenuation},
                                              {"GL_QUADRATIC_ATTENUATION", gl_constant::quadratic_attenuation},
                                              {"GL_EMISSION", gl_constant::emission},
                                              {"GL_SHININESS", gl_constant::shininess},
                                              {"GL_AMBIENT_AND_DIFFUSE", gl_constant::ambient_and_diffuse},
                                              {"GL_COLOR_INDEXES", 0x1603},
                                              {"GL_MODELVIEW", gl_constant::modelview},
                                              {"GL_PROJECTION", gl_constant::projection},
                                              {"GL_TEXTURE", gl_constant::texture},
                                              {"GL_FLAT", gl_constant::flat},
                                              {"GL_SMOOTH", gl_constant::smooth},
                                              {"GL_LIGHT0", gl_constant::light0},
                                              {"GL_LIGHT1", 0x4001},
                                              {"GL_LIGHT2", 0x4002},
                                              {"GL_LIGHT3", 0x4003},
                                              {"GL_LIGHT4", 0x4004},
                                              {"GL_LIGHT5", 0x4005},
                                              {"GL_LIGHT6", 0x4006},
                                              {"GL_LIGHT7", 0x4007},
                                              {"GL_CLAMP_VERTEX_COLOR", gl_constant::clamp_vertex_color},
                                              {"GL_CLAMP_FRAGMENT_COLOR", 0x891B},
                                              {"GL_CLAMP_READ_COLOR", 0x891C},
                                              {"GL_TEXTURE_2D", 0x0DE1},
                                              {"GL_TEXTURE_1D", 0x0DE0},
                                              {"GL_FOG", 0x0B60},
                                              {"GL_BLEND", 0x0BE2},
                                              {"GL_ALPHA_TEST", 0x0BC0},
                                              {"GL_STENCIL_TEST", 0x0B90},
                                              {"GL_SCISSOR_TEST", 0x0C11},
                                              {"GL_LINE_SMOOTH", 0x0B20},
                                              {"GL_POINT_SMOOTH", 0x0B10},
                                              {"GL_POLYGON_SMOOTH", 0x0B41},
                                              {"GL_DITHER", 0x0BD0},
                                              {"GL_MULTISAMPLE", 0x809D},
                                              {"GL_AUTO_NORMAL", 0x0D80},
                                              {"GL_COLOR_BUFFER_BIT", 0x4000},
                                              {"GL_DEPTH_BUFFER_BIT", 0x0100},
                                              {"GL_STENCIL_BUFFER_BIT", 0x0400},
                                              {"GL_FALSE", 0},
                                              {"GL_TRUE", 1},
                                              {"GL_NONE", 0},
                                              {"GL_LINE", 0x1B01},
                                              {"GL_FILL", 0x1B02},
                                              {"GL_POINT", 0x1B00},
                                              {"GL_POINTS", 0},
                                              {"GL_LINES", 1},
                                              {"GL_LINE_LOOP", 2},
                                              {"GL_LINE_STRIP", 3},
                                              {"GL_TRIANGLES", 4},
                                              {"GL_TRIANGLE_STRIP", 5},
                                              {"GL_TRIANGLE_FAN", 6},
                                              {"GL_QUADS", 7},
                                              {"GL_QUAD_STRIP", 8},
                                              {"GL_POLYGON", 9},
                                              {"GL_LESS", 0x0201},
                                              {"GL_LEQUAL", 0x0203},
                                              {"GLUT_RGB", 0},
                                              {"GLUT_RGBA", 0},
                                              {"GLUT_SINGLE", 0},
                                              {"GLUT_DOUBLE", 2},
                                              {"GLUT_DEPTH", 16},
                                              {"NULL", 0},
                                              {"TRUE", 1},
                                              {"FALSE", 0},
                                              {"true", 1}}};

}  // namespace

std::optional<int> gl_constant_value(std::string_view name) {
  for (const Constant& c : constants)
    if (c.name == name) return c.value;
  return name == "false" ? std::optional(0) : std::nullopt;
}

std::string gl_constant_name(int value) {
  for (const Constant& c : constants)
    if (c.value == value) return std::string(c.name);
  return std::to_string(value);
}

}  // namespace cg
