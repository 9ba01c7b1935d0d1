#include "shading/gl_call_list.h"
#include "shading/light_model.h"

namespace cg {

namespace {

// Why the light cannot be drawn at all, if so: the light model leaves such lights out too.
std::optional<Text> dark(const Scene& scene, const Light& light) {
  Scene alone;
  alone.lights = {light};
  alone.lights[0].enabled = true;
  const auto lighting = lighting_in_eye_space<double>(alone, view_matrix(scene.camera));
  if (lighting.lights.empty())
    return Text(Words{"a direction of length 0 is none: the light is off", "長さ 0 の方向では照らせないので消す"});
  if (lighting.lights[0].spot_cosine > -2 && lighting.lights[0].spot_direction == glm::dvec3(0))
    return Text(Words{"a cone without a direction is dark: the light is off", "向きのない円錐は光らないので消す"});
  return std::nullopt;
}

class OneLight {
 public:
  OneLight(const Scene& scene, int light, int gl_light, GlCallList& list)
      : scene_(scene),
        light_(scene.lights[std::size_t(light)]),
        path_("lights." + std::to_string(light) + "."),
        variable_(gl_light_variable(gl_light)),
        token_("GL_LIGHT" + std::to_string(gl_light)),
        list_(list) {}

  void add() {
    position();
    colour("GL_AMBIENT", "ambient", light_.ambient, Quantity::ambient);
    colour("GL_DIFFUSE", "diffuse", light_.diffuse, Quantity::diffuse);
    colour("GL_SPECULAR", "specular", light_.specular, Quantity::specular);
    attenuation();
    if (light_.kind == LightKind::spot && light_.cutoff != 180) cone();
    const std::optional<Text> why = dark(scene_, light_);
    GlCall& call = list_.add(light_.enabled && !why ? "glEnable" : "glDisable", {token_});
    call.path = path_ + "enabled";
    if (light_.enabled && why) call.notes.push_back(*why);
  }

 private:
  void position() {
    const bool directional = light_.kind == LightKind::directional, small = std::abs(light_.w) < 1e-6;
    GlNumber w{.value = finite(light_.w), .path = path_ + "w"};
    if (directional) w = {.value = 0, .path = {}};
    if (small || scene_.mistakes.directional_w) w.value = 0;
    GlCall& call = list_.add_array("glLightfv", {token_, "GL_POSITION"}, variable_ + "_position", path_ + "position",
                                   light_.position, w, Quantity::none);
    if (scene_.mistakes.directional_w && !directional && !small) call.mistake = "directional_w";
    if (scene_.mistakes.light_before_view) call.mistake = "light_before_view";
    if (!directional && small && light_.w != 0)
      call.notes.push_back(Words{"a w next to 0 is written as 0: directional", "0 に近い w は 0 と書く（平行光源）"});
  }

  void colour(const char* what, const char* name, const glm::dvec3& c, Quantity quantity) {
    list_.add_array("glLightfv", {token_, what}, variable_ + "_" + name, path_ + name, c, {.value = 1, .path = {}},
                    quantity);
  }

  GlCall& number(const char* what, const char* name, double value) {
    GlCall& call = list_.add("glLightf", {token_, what});
    call.numbers = {{.value = finite(value), .path = path_ + name}};
    return call;
  }

  void attenuation() {
    if (light_.kind == LightKind::directional) return;
    const bool none = light_.k_0 == 0 && light_.k_1 == 0 && light_.k_2 == 0;
    if (none)
      number("GL_CONSTANT_ATTENUATION", "k_0", 1)
          .notes.push_back(Words{"0, 0, 0 would be a division by zero: 1, 0, 0", "0, 0, 0 はゼロ除算なので 1, 0, 0"});
    else if (light_.k_0 != 1)
      number("GL_CONSTANT_ATTENUATION", "k_0", light_.k_0);
    if (light_.k_1 != 0) number("GL_LINEAR_ATTENUATION", "k_1", light_.k_1);
    if (light_.k_2 != 0) number("GL_QUADRATIC_ATTENUATION", "k_2", light_.k_2);
  }

  void cone() {
    number("GL_SPOT_CUTOFF", "cutoff", light_.cutoff);
    GlCall& direction = list_.add("glLightfv", {token_, "GL_SPOT_DIRECTION"});
    direction.variable = variable_ + "_direction";
    direction.numbers = vector_numbers(path_ + "direction", light_.direction);
    if (scene_.mistakes.light_before_view) direction.mistake = "light_before_view";
    if (light_.exponent != 0) number("GL_SPOT_EXPONENT", "exponent", light_.exponent);
  }

  const Scene& scene_;
  const Light& light_;
  std::string path_, variable_, token_;
  GlCallList& list_;
};

}  // namespace

void add_light_calls(const Scene& scene, GlCallList& list) {
  list.section = GlSection::lights;
  const bool all = scene.lights.size() <= std::size_t(gl_light_limit);
  int lights = 0;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    if (!all && (!scene.lights[i].enabled || dark(scene, scene.lights[i]))) continue;
    if (++lights > gl_light_limit) continue;
    const std::size_t first = list.calls.size();
    OneLight(scene, int(i), lights - 1, list).add();
    for (std::size_t k = first; k < list.calls.size(); ++k) list.calls[k].light = int(i);
  }
  if (lights <= gl_light_limit) return;
  const std::string n = std::to_string(lights);
  list.add("", {}).notes.push_back({"OpenGL's fixed function has 8 lights: the first 8 of " + n + " are drawn",
                                    "OpenGL の固定機能の光源は 8 個まで：" + n + " 個のうち最初の 8 個を描く"});
}

std::string gl_light_variable(int gl_light) { return "light" + std::to_string(gl_light); }

}  // namespace cg
