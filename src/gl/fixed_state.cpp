#include "gl/fixed_state.h"

#include <epoxy/gl.h>

#include "shading/gl_calls.h"
#include "shading/plan_maker.h"

namespace cg {

namespace {

template <class Get>
glm::vec3 three(const Get& get) {
  GLfloat v[4] = {0, 0, 0, 0};
  get(v);
  return {v[0], v[1], v[2]};
}

EyeMaterial<float> current_material() {
  const auto colour = [](GLenum name) { return three([&](GLfloat* v) { glGetMaterialfv(GL_FRONT, name, v); }); };
  EyeMaterial<float> m{};
  m.k_a = colour(GL_AMBIENT), m.k_d = colour(GL_DIFFUSE), m.k_s = colour(GL_SPECULAR), m.emission = colour(GL_EMISSION);
  if (!glIsEnabled(GL_COLOR_MATERIAL)) return m;
  // What follows glColor may reach the material only when it is drawn.
  const glm::vec3 color = three([](GLfloat* v) { glGetFloatv(GL_CURRENT_COLOR, v); });
  GLint followed = 0;
  glGetIntegerv(GL_COLOR_MATERIAL_PARAMETER, &followed);
  const bool both = followed == GL_AMBIENT_AND_DIFFUSE;
  if (both || followed == GL_AMBIENT) m.k_a = color;
  if (both || followed == GL_DIFFUSE) m.k_d = color;
  if (followed == GL_SPECULAR) m.k_s = color;
  if (followed == GL_EMISSION) m.emission = color;
  return m;
}

EyeLight<float> current_light(GLenum name) {
  const auto colour = [&](GLenum which) { return three([&](GLfloat* v) { glGetLightfv(name, which, v); }); };
  const auto number = [&](GLenum which) {
    GLfloat v = 0;
    glGetLightfv(name, which, &v);
    return v;
  };
  EyeLight<float> light{};
  light.ambient = colour(GL_AMBIENT), light.diffuse = colour(GL_DIFFUSE), light.specular = colour(GL_SPECULAR);
  GLfloat position[4];
  glGetLightfv(name, GL_POSITION, position);
  light.directional = position[3] == 0;
  light.spot_cosine = number(GL_SPOT_CUTOFF) == 180 ? -2 : 0;
  light.k_0 = number(GL_CONSTANT_ATTENUATION), light.k_1 = number(GL_LINEAR_ATTENUATION);
  light.k_2 = number(GL_QUADRATIC_ATTENUATION);
  return light;
}

bool is_on(GLenum name) {
  GLint on = 0;
  glGetIntegerv(name, &on);
  return on != 0;
}

bool any_texture() {
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  bool any = false;
  for (int unit = 0; unit < gl_texture_unit_limit; ++unit) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    any = any || glIsEnabled(GL_TEXTURE_2D);
  }
  glActiveTexture(GLenum(active));
  return any;
}

}  // namespace

void record_fixed_state(PassRecorder& record) {
  EyeLighting<float> lighting{};
  lighting.ambient = three([](GLfloat* v) { glGetFloatv(GL_LIGHT_MODEL_AMBIENT, v); });
  for (int i = 0; i < gl_light_limit; ++i)
    if (glIsEnabled(GLenum(GL_LIGHT0 + i))) lighting.lights.push_back(current_light(GLenum(GL_LIGHT0 + i)));
  const LightParts parts = light_parts(lighting, current_material());
  for (const char* id : part_ids(parts, is_on(GL_LIGHT_MODEL_LOCAL_VIEWER), is_on(GL_LIGHT_MODEL_TWO_SIDE),
                                 is_on(GL_CLAMP_VERTEX_COLOR)))
    record.item(id);
  if (glIsEnabled(GL_LIGHTING)) record.item("vertex-lighting");
  if (any_texture()) record.item("layers");
  if (glIsEnabled(GL_ALPHA_TEST)) record.item("alpha-test");
  if (glIsEnabled(GL_COLOR_MATERIAL)) record.item("color-material");
}

}  // namespace cg
