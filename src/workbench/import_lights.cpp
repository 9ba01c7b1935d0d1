// glLight, glLightModel, glMaterial, glColor and what is enabled, as a program that is read calls them.
#include "params/numbers.h"
#include "workbench/import_constants.h"
#include "workbench/import_machine.h"

namespace cg {

namespace {

using namespace gl_constant;

Text name_of(int token) {
  const std::string name = gl_constant_name(token);
  return {name, name};
}

Text text_of_number(double v) { return {number_text(v), number_text(v)}; }

GlLightState* light_of(GlState& s, GlCallReader& call, int token) {
  if (token >= light0 && token < light0 + 8) {
    GlLightState& light = s.lights[std::size_t(token - light0)];
    if (!light.touched && token == light0) light.diffuse = light.specular = glm::dvec3(1);
    if (!light.touched) light.line = call.line;
    light.touched = true;
    return &light;
  }
  call.refuse({"the lights are GL_LIGHT0 to GL_LIGHT7", "光源は GL_LIGHT0 から GL_LIGHT7 まで"});
  return nullptr;
}

// One number of a light; OpenGL refuses one outside its range.
void set_number(GlLightState& light, GlCallReader& call, int what, double v) {
  const bool inside = what == spot_cutoff     ? (v >= 0 && v <= 90) || v == 180
                      : what == spot_exponent ? v >= 0 && v <= 128
                                              : v >= 0;
  if (!inside)
    return call.refuse({"OpenGL refuses {0} for {1}", "OpenGL は {1} に {0} を受け付けない"},
                       {text_of_number(v), name_of(what)});
  if (what == spot_cutoff) light.cutoff = v, light.coned = v != 180;
  if (what == spot_exponent) light.exponent = v;
  if (what == constant_attenuation) light.k_0 = v;
  if (what == linear_attenuation) light.k_1 = v;
  if (what == quadratic_attenuation) light.k_2 = v;
  if (what >= constant_attenuation && what <= quadratic_attenuation)
    light.fading = light.k_0 != 1 || light.k_1 != 0 || light.k_2 != 0;
}

bool is_number_of_light(int what) { return what >= spot_exponent && what <= quadratic_attenuation; }

void set_light(GlState& s, GlLightState& light, GlCallReader& call, int what, bool array) {
  if (is_number_of_light(what)) {
    if (const auto v = call.numbers(2, 1, array)) set_number(light, call, what, (*v)[0]);
  } else if (!array) {
    call.refuse({"{0} needs an array, as glLightfv takes", "{0} には配列が必要（glLightfv を使う）"}, {name_of(what)});
  } else if (what == ambient || what == diffuse || what == specular) {
    if (const auto c = call.colour(2))
      (what == ambient ? light.ambient : what == diffuse ? light.diffuse : light.specular) = *c;
  } else if (what == position) {
    const auto v = call.numbers(2, 4, true);
    light.position_left_out = !v;
    if (!v) return;
    light.position = {(*v)[0], (*v)[1], (*v)[2], (*v)[3]};
    light.position_matrix = s.modelview, light.position_line = call.line;
  } else if (what == spot_direction) {
    const auto v = call.numbers(2, 3, true);
    if (!v) return;
    light.direction = {(*v)[0], (*v)[1], (*v)[2]};
    light.direction_matrix = s.modelview, light.direction_line = call.line;
  } else {
    call.refuse({"glLight knows no {0}", "glLight に {0} はない"}, {name_of(what)});
  }
}

void set_light_model(GlState& s, GlCallReader& call, bool array) {
  const auto what = call.token(0);
  if (!what) return;
  if (*what == light_model_ambient) {
    if (!array) return call.refuse({"GL_LIGHT_MODEL_AMBIENT needs an array", "GL_LIGHT_MODEL_AMBIENT には配列が必要"});
    if (const auto c = call.colour(1)) s.ambient = *c;
    return;
  }
  const auto v = call.numbers(1, 1, array);
  if (!v) return;
  if (*what == light_model_local_viewer)
    s.local_viewer = (*v)[0] != 0;
  else if (*what == light_model_two_side)
    s.two_sided = (*v)[0] != 0;
  else
    call.complain({"{0} is not read", "{0} は読み込めない"}, {name_of(*what)});
}

void set_material(GlState& s, GlCallReader& call, bool array) {
  const auto face = call.token(0), what = call.token(1);
  if (!face || !what) return;
  if (*face == back) return call.refuse({"back faces have no material of their own here", "裏面専用の素材は扱えない"});
  if (*face != front && *face != front_and_back)
    return call.refuse({"glMaterial knows no {0}", "glMaterial に {0} はない"}, {name_of(*face)});
  GlMaterialState& m = s.material;
  if (*what == shininess) {
    const auto v = call.numbers(2, 1, array);
    if (v && (*v)[0] >= 0 && (*v)[0] <= 128)
      m.n = (*v)[0];
    else if (v)
      call.refuse({"OpenGL refuses {0} for GL_SHININESS, which ends at 128",
                   "GL_SHININESS は 0 から 128 で、OpenGL は {0} を受け付けない"},
                  {text_of_number((*v)[0])});
    return;
  }
  const bool colour =
      *what == ambient || *what == diffuse || *what == specular || *what == emission || *what == ambient_and_diffuse;
  if (!colour) return call.refuse({"glMaterial knows no {0}", "glMaterial に {0} はない"}, {name_of(*what)});
  if (!array)
    return call.refuse({"{0} needs an array, as glMaterialfv takes", "{0} には配列が必要（glMaterialfv を使う）"},
                       {name_of(*what)});
  const auto c = call.colour(2);
  if (!c) return;
  if (*what == ambient || *what == ambient_and_diffuse) m.k_a = *c, m.ambient_set = true;
  if (*what == diffuse || *what == ambient_and_diffuse) m.k_d = *c, m.diffuse_set = true;
  if (*what == specular) m.k_s = *c;
  if (*what == emission) m.emission = *c;
}

void set_color(GlState& s, GlCallReader& call, const GlSuffix& suffix) {
  const double unit = suffix.type == "ub" ? 255 : 1;
  if (suffix.type != "f" && suffix.type != "d" && suffix.type != "ub")
    return call.refuse({"numbers of this type are not read", "この型の数は読み込めない"});
  const auto v = call.numbers(0, 3, suffix.array);
  if (!v) return;
  s.material.color = glm::dvec3((*v)[0], (*v)[1], (*v)[2]) / unit;
  s.material.color_line = call.line;
}

void enable(GlState& s, GlCallReader& call, bool on) {
  const auto what = call.token(0);
  if (!what) return;
  if (*what >= light0 && *what < light0 + 8) {
    GlLightState& light = *light_of(s, call, *what);
    light.enabled = on, light.disabled = !on;
    return;
  }
  on ? void(s.enabled.insert(*what)) : void(s.enabled.erase(*what));
  const std::string name = gl_constant_name(*what);
  for (const std::string_view effect : {"GL_TEXTURE_2D", "GL_TEXTURE_1D", "GL_FOG", "GL_BLEND"})
    if (on && name == effect) call.complain({"{0} is not read", "{0} は読み込めない"}, {name_of(*what)});
}

}  // namespace

bool read_light_call(GlState& s, GlCallReader& call) {
  if (const auto suffix = gl_suffix(call.function, "glLightModel"); suffix && suffix->count == 0) {
    set_light_model(s, call, suffix->array);
    return true;
  }
  const auto suffix = gl_suffix(call.function, "glLight");
  if (!suffix || suffix->count != 0) return false;
  const auto light = call.token(0), what = call.token(1);
  if (!light || !what) return true;
  if (GlLightState* l = light_of(s, call, *light)) set_light(s, *l, call, *what, suffix->array);
  return true;
}

bool read_material_call(GlState& s, GlCallReader& call) {
  if (call.function == "glColorMaterial") {
    const auto face = call.token(0), what = call.token(1);
    if (face && what && *face == back)
      call.refuse({"back faces have no material of their own here", "裏面専用の素材は扱えない"});
    else if (face && what)
      s.color_material = *what;
    return true;
  }
  if (const auto suffix = gl_suffix(call.function, "glMaterial"); suffix && suffix->count == 0) {
    set_material(s, call, suffix->array);
    return true;
  }
  const auto suffix = gl_suffix(call.function, "glColor");
  if (!suffix || suffix->count < 3) return false;
  set_color(s, call, *suffix);
  return true;
}

bool read_state_call(GlState& s, GlCallReader& call) {
  const std::string_view f = call.function;
  if (f == "glEnable" || f == "glDisable") {
    enable(s, call, f == "glEnable");
  } else if (f == "glShadeModel") {
    if (const auto mode = call.token(0)) s.flat = *mode == flat;
  } else if (f == "glFrontFace") {
    if (const auto way = call.token(0)) s.clockwise = *way == cw, s.front_face_line = call.line;
  } else if (f == "glClearColor") {
    if (const auto v = call.numbers(0, 3, false)) s.background = {(*v)[0], (*v)[1], (*v)[2]};
  } else if (f == "glClampColor" || f == "glClampColorARB") {
    const auto what = call.token(0), on = call.token(1);
    if (what && on && *what == clamp_vertex_color) s.clamp = *on != 0;
  } else if (f == "glPolygonMode") {
    call.complain({"glPolygonMode is not read: faces are filled", "glPolygonMode は読み込めない：面は塗りつぶす"});
  } else {
    return false;
  }
  return true;
}

}  // namespace cg
