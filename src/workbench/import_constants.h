// The names of OpenGL's constants that a program of the course uses, with their values (gl.h, GL 2.1).
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace cg {

namespace gl_constant {
enum : int {
  false_ = 0,
  true_ = 1,
  front_left = 0x0400,
  front = 0x0404,
  back = 0x0405,
  front_and_back = 0x0408,
  cw = 0x0900,
  ccw = 0x0901,
  color_material = 0x0B57,
  lighting = 0x0B50,
  light_model_local_viewer = 0x0B51,
  light_model_two_side = 0x0B52,
  light_model_ambient = 0x0B53,
  cull_face = 0x0B44,
  depth_test = 0x0B71,
  normalize = 0x0BA1,
  rescale_normal = 0x803A,
  ambient = 0x1200,
  diffuse = 0x1201,
  specular = 0x1202,
  position = 0x1203,
  spot_direction = 0x1204,
  spot_exponent = 0x1205,
  spot_cutoff = 0x1206,
  constant_attenuation = 0x1207,
  linear_attenuation = 0x1208,
  quadratic_attenuation = 0x1209,
  emission = 0x1600,
  shininess = 0x1601,
  ambient_and_diffuse = 0x1602,
  modelview = 0x1700,
  projection = 0x1701,
  texture = 0x1702,
  flat = 0x1D00,
  smooth = 0x1D01,
  light0 = 0x4000,
  clamp_vertex_color = 0x891A,
};
}

std::optional<int> gl_constant_value(std::string_view name);
// "GL_LIGHT0", or the number.
std::string gl_constant_name(int value);

}  // namespace cg
