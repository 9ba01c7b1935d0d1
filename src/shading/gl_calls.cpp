#include "shading/gl_calls.h"

#include "math/look_at_taken.h"
#include "shading/gl_call_list.h"

namespace cg {

namespace {

void missing(GlCall& call, std::string_view mistake) { call.mistake = mistake, call.missing = true; }

void add_state(const Scene& scene, GlCallList& list) {
  const Shading& s = scene.shading;
  list.section = GlSection::state;
  GlCall& clear = list.add("glClearColor", {});
  clear.numbers = vector_numbers("display.background", scene.display.background);
  clear.numbers.push_back(fixed(1));
  GlCall& depth = list.add("glEnable", {"GL_DEPTH_TEST"});
  if (scene.mistakes.no_depth_test) missing(depth, "no_depth_test");
  if (scene.mistakes.swapped_front_face) {
    // With both sides lit, culling would hide the wrong side instead of showing it.
    if (!s.two_sided) list.add("glEnable", {"GL_CULL_FACE"});
    list.add("glFrontFace", {"GL_CW"}).mistake = "swapped_front_face";
  }
  GlCall& mode = list.add("glShadeModel", {s.mode == ShadingMode::flat ? "GL_FLAT" : "GL_SMOOTH"});
  mode.path = "shading.mode";
  if (s.mode == ShadingMode::phong)
    mode.notes.push_back(Words{"Phong shading needs a shader: GL_SMOOTH interpolates the vertices' colours",
                               "フォンシェーディングにはシェーダーが必要：GL_SMOOTH は頂点の色を補間する"});
  if (s.normal_length != NormalLength::off) {
    const char* how = s.normal_length == NormalLength::normalize ? "GL_NORMALIZE" : "GL_RESCALE_NORMAL";
    GlCall& normalize = list.add("glEnable", {how});
    normalize.path = "shading.normal_length";
    if (scene.mistakes.no_normalize) missing(normalize, "no_normalize");
  }
  if (s.clamp) return;
  GlCall& clamp = list.add("glClampColor", {"GL_CLAMP_VERTEX_COLOR", "GL_FALSE"});
  clamp.path = "shading.clamp";
  clamp.notes.push_back(
      Words{"seen only in a picture of floating-point numbers", "浮動小数点の画像でだけ違いが見える"});
}

const char* color_material_token(ColorMaterial tracked) {
  switch (tracked) {
    case ColorMaterial::off:
    case ColorMaterial::ambient_and_diffuse:
      return "GL_AMBIENT_AND_DIFFUSE";
    case ColorMaterial::ambient:
      return "GL_AMBIENT";
    case ColorMaterial::diffuse:
      return "GL_DIFFUSE";
    case ColorMaterial::specular:
      return "GL_SPECULAR";
    case ColorMaterial::emission:
      return "GL_EMISSION";
  }
  return "GL_AMBIENT_AND_DIFFUSE";
}

void add_light_model(const Scene& scene, GlCallList& list) {
  const Shading& s = scene.shading;
  list.section = GlSection::light_model;
  if (!lights_by_hand(scene.mistakes)) list.add("glEnable", {"GL_LIGHTING"});
  list.add_array("glLightModelfv", {"GL_LIGHT_MODEL_AMBIENT"}, "light_model_ambient", "shading.ambient", s.ambient,
                 fixed(1), Quantity::ambient);
  if (s.local_viewer)
    list.add("glLightModeli", {"GL_LIGHT_MODEL_LOCAL_VIEWER", "GL_TRUE"}).path = "shading.local_viewer";
  if (s.two_sided) list.add("glLightModeli", {"GL_LIGHT_MODEL_TWO_SIDE", "GL_TRUE"}).path = "shading.two_sided";
  if (!follows_color(scene) || field_of_calls(scene)) return;
  list.add("glColorMaterial", {"GL_FRONT_AND_BACK", color_material_token(s.color_material)}).path =
      "shading.color_material";
  GlCall& enable = list.add("glEnable", {"GL_COLOR_MATERIAL"});
  enable.path = "shading.color_material";
  if (scene.mistakes.no_color_material) missing(enable, "no_color_material");
}

void add_projection(const Camera& c, GlCallList& list) {
  list.section = GlSection::projection;
  list.add("glMatrixMode", {"GL_PROJECTION"});
  list.add("glLoadIdentity", {});
  const GlNumber near{.value = c.near_plane, .path = "camera.near"}, far{.value = c.far_plane, .path = "camera.far"};
  if (c.projection == Projection::perspective) {
    list.add("gluPerspective", {}).numbers = {
        {.value = c.fov, .path = "camera.fov"}, {.value = 1, .path = {}, .times_aspect = true}, near, far};
    return;
  }
  const auto half = [&](double sign, bool times_aspect) {
    const double factor = sign / 2;
    return GlNumber{
        .value = c.height * factor, .path = "camera.height", .factor = factor, .times_aspect = times_aspect};
  };
  list.add("glOrtho", {}).numbers = {half(-1, true), half(1, true), half(-1, false), half(1, false), near, far};
}

void add_look_at(const Camera& c, GlCallList& list) {
  list.section = GlSection::view;
  GlCall& look_at = list.add("gluLookAt", {});
  const auto [target, up] = look_at_taken(c.position, c.target, c.up);
  if (target != c.target)
    look_at.notes.push_back(
        Words{"an eye at its target looks nowhere: along -z", "視点が注視点と同じなので -z を向く"});
  if (up != c.up)
    look_at.notes.push_back(Words{"up along the view is none: another axis", "上方向が視線と平行なので別の軸にする"});
  for (const auto& [path, v] :
       {std::pair("camera.position", c.position), std::pair("camera.target", target), std::pair("camera.up", up)})
    for (const GlNumber& number : vector_numbers(path, v)) look_at.numbers.push_back(number);
}

void add_view_and_lights(const Scene& scene, GlCallList& list) {
  list.section = GlSection::view;
  list.add("glClear", {"GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT"});
  list.add("glMatrixMode", {"GL_MODELVIEW"});
  list.add("glLoadIdentity", {});
  if (scene.mistakes.light_before_view) add_light_calls(scene, list);
  add_look_at(scene.camera, list);
  if (!scene.mistakes.light_before_view) add_light_calls(scene, list);
}

// The normals of vertices, given to OpenGL or to the light model of one's own.
void add_normal(const Mistakes& m, GlCallList& list) {
  if (lights_by_hand(m)) {
    const char* normal = m.no_normals ? "no_normal" : m.flipped_normals ? "flipped( normal )" : "normal";
    GlCall& call = list.add("glColor3fv", {std::string("shade( vertex, ") + normal + " )"});
    call.mistake = m.no_normals ? "no_normals" : m.flipped_normals ? "flipped_normals" : "";
    return;
  }
  GlCall& call = m.flipped_normals ? list.add("glNormal3f", {"-normal[ 0 ]", "-normal[ 1 ]", "-normal[ 2 ]"})
                                   : list.add("glNormal3fv", {"normal"});
  if (m.flipped_normals) call.mistake = "flipped_normals";
  if (m.no_normals) missing(call, "no_normals");
}

void add_mesh(const Scene& scene, GlCallList& list) {
  list.section = GlSection::mesh;
  list.add("glBegin", {"GL_TRIANGLES"});
  if (field_of_calls(scene)) {
    GlCall& color = list.add("glColor3fv", {"radiosity"});
    color.quantity = Quantity::ambient;
    color.path = "shading.ambient_source";
    color.notes.push_back(Words{"emission + radiosity of this vertex", "発光 + この頂点のラジオシティ"});
  }
  add_texture_coordinates(scene, list);
  add_normal(scene.mistakes, list);
  list.add("glVertex3fv", {"vertex"});
  list.add("glEnd", {});
}

}  // namespace

std::vector<GlCall> gl_calls(const Scene& scene) {
  GlCallList list;
  add_state(scene, list);
  add_light_model(scene, list);
  add_projection(scene.camera, list);
  add_view_and_lights(scene, list);
  add_object_calls(scene, list);
  add_mesh(scene, list);
  for (GlCall& call : list.calls)
    for (GlNumber& number : call.numbers) number.value = finite(number.value);
  return std::move(list.calls);
}

}  // namespace cg
