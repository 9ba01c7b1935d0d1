#include "gl/fixed_lighting.h"

#include <epoxy/gl.h>

#include <cfloat>
#include <cmath>

namespace cg {

namespace {

constexpr double largest_shininess = 128, smallest_shininess = 1e-6;
// A light farther than this (in eye units) is sent as directional: the square of its distance would leave float.
constexpr double far_away = 1e15;

struct Four {
  GLfloat v[4];
};

// Within float's range; NaN becomes 0.
GLfloat limited(double x) {
  return std::isnan(x) ? 0 : GLfloat(std::min(std::max(x, -double(FLT_MAX)), double(FLT_MAX)));
}

Four four(const glm::dvec3& v, double w) { return {{limited(v.x), limited(v.y), limited(v.z), GLfloat(w)}}; }

double largest_column(const glm::dmat4& m) {
  double largest = 0;
  for (int c = 0; c < 3; ++c) largest = std::max(largest, length_and_unit(glm::dvec3(m[c])).length);
  return largest;
}

bool is_far(const EyeLight<double>& light, double eye_unit) {
  return !light.directional && length_and_unit(light.position).length * eye_unit > far_away;
}

// Mesa's fixed function has (N.L)^(N.L) for the highlight where the exponent is exactly 0 and a light fades or has
// a cone (ffvertex_prog.c: emit_lit after a replicated N.L).
bool meets_zero_exponent_fault(double n, const EyeLighting<double>& lighting) {
  bool some = false;
  for (const EyeLight<double>& light : lighting.lights) some = some || !light.directional || light.spot_cosine > -2;
  return some && n < smallest_shininess;
}

// The emission, which also stands for a NaN that has no light as its cause: clamped, OpenGL would make it white, where
// the other techniques make it black.
Four emission_to_send(const EyeMaterial<double>& m, const EyeLighting<double>& lighting) {
  Four emission = four(m.emission, 1);
  for (int c = 0; c < 3; ++c)
    if (std::isnan(m.emission[c] + lighting.ambient[c] * m.k_a[c])) emission.v[c] = lighting.clamp ? -FLT_MAX : NAN;
  return emission;
}

struct Attenuation {
  double k_0, k_1, k_2, share;  // share: to be multiplied into the light's colours
};

Attenuation attenuation_in_unit(const EyeLight<double>& light, double eye_unit) {
  if (light.directional) return {1, 0, 0, 1};
  if (is_far(light, eye_unit)) {
    const double r = length_and_unit(light.position).length;
    const double d = light.k_0 + r * (light.k_1 + r * light.k_2);
    return {1, 0, 0, d > 0 ? 1 / d : 1};
  }
  Attenuation a{light.k_0, light.k_1 / eye_unit, light.k_2 / eye_unit / eye_unit, 1};
  const double largest = std::max({a.k_0, a.k_1, a.k_2});
  if (!(largest > 0)) return {1, 0, 0, 1};  // (0, 0, 0) would be a division by zero in OpenGL
  if (largest > 1e15 || largest < 1e-15) a = {a.k_0 / largest, a.k_1 / largest, a.k_2 / largest, 1 / largest};
  return a;
}

void send_light(GLenum name, const Scene& scene, const EyeLight<double>& light, double eye_unit) {
  const Light& given = scene.lights[std::size_t(light.index)];
  const bool directional = light.directional || is_far(light, eye_unit);
  const Attenuation a = attenuation_in_unit(light, eye_unit);
  glLightfv(name, GL_AMBIENT, four(light.ambient * a.share, 1).v);
  glLightfv(name, GL_DIFFUSE, four(light.diffuse * a.share, 1).v);
  glLightfv(name, GL_SPECULAR, four(light.specular * a.share, 1).v);
  const glm::dvec3 from_eye = light.directional ? given.position : given.position / given.w - scene.camera.position;
  glLightfv(name, GL_POSITION, directional ? four(unit(from_eye), 0).v : four(from_eye * eye_unit, 1).v);
  glLightf(name, GL_CONSTANT_ATTENUATION, limited(a.k_0));
  glLightf(name, GL_LINEAR_ATTENUATION, limited(a.k_1));
  glLightf(name, GL_QUADRATIC_ATTENUATION, limited(a.k_2));
  const bool cone = light.spot_cosine > -2;
  glLightf(name, GL_SPOT_CUTOFF, cone ? GLfloat(given.cutoff) : 180);
  if (cone) {
    glLightfv(name, GL_SPOT_DIRECTION, four(unit(given.direction), 0).v);
    glLightf(name, GL_SPOT_EXPONENT, GLfloat(given.exponent));
  }
  glEnable(name);
}

GLenum color_material_mode(ColorMaterial tracked) {
  switch (tracked) {
    case ColorMaterial::off:
    case ColorMaterial::ambient_and_diffuse:
      return GL_AMBIENT_AND_DIFFUSE;
    case ColorMaterial::ambient:
      return GL_AMBIENT;
    case ColorMaterial::diffuse:
      return GL_DIFFUSE;
    case ColorMaterial::specular:
      return GL_SPECULAR;
    case ColorMaterial::emission:
      return GL_EMISSION;
  }
  return GL_AMBIENT_AND_DIFFUSE;
}

}  // namespace

double eye_unit(const glm::dmat4& surface_to_eye, double surface_radius, NormalLength length) {
  // Where normals are taken as they come, only the surface's own unit may be taken out: it is not the object's scale.
  const double size = length == NormalLength::off ? surface_radius : largest_column(surface_to_eye);
  if (!(size > 0) || (size >= 0x1p-10 && size <= 0x1p10)) return 1;
  return std::exp2(-std::round(std::log2(size)));
}

glm::mat4 projection_in_unit(glm::mat4 projection, double eye_unit) {
  for (int c = 0; c < 3; ++c) projection[c] *= float(1 / eye_unit);
  return projection;
}

glm::mat4 modelview_in_unit(glm::mat4 modelview, double eye_unit) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 3; ++r) modelview[c][r] *= float(eye_unit);
  return modelview;
}

void send_lights(const Scene& scene, const EyeLighting<double>& lighting, double eye_unit) {
  const glm::mat4 rotation(glm::mat4(glm::mat3(view_matrix(scene.camera))));
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(&rotation[0].x);
  int sent = 0;
  for (const EyeLight<double>& light : lighting.lights) {
    if (sent == gl_light_limit) break;
    if (light.spot_cosine > -2 && light.spot_direction == glm::dvec3(0)) continue;  // a cone without an axis is dark
    send_light(GLenum(GL_LIGHT0 + sent++), scene, light, eye_unit);
  }
  while (sent < gl_light_limit) glDisable(GLenum(GL_LIGHT0 + sent++));
}

void send_light_model(const Shading& shading, bool two_sided, bool local_viewer) {
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, four(shading.ambient, 1).v);
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, local_viewer);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, two_sided);
  glShadeModel(shading.mode == ShadingMode::flat ? GL_FLAT : GL_SMOOTH);
  glClampColor(GL_CLAMP_VERTEX_COLOR, shading.clamp ? GL_TRUE : GL_FALSE);
  glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
  glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
  auto enable = [](GLenum what, bool on) { (on ? glEnable : glDisable)(what); };
  enable(GL_NORMALIZE, shading.normal_length == NormalLength::normalize);
  enable(GL_RESCALE_NORMAL, shading.normal_length == NormalLength::rescale);
  glEnable(GL_LIGHTING);
}

void send_material(const Material& material, ColorMaterial tracked, const EyeLighting<double>& lighting) {
  // The tracked colours are sent twice, here and by glColor: Mesa does not copy a current colour that is the same
  // as before, though glMaterial has written over it since.
  const EyeMaterial<double> m = eye_material<double>(material, tracked);
  glDisable(GL_COLOR_MATERIAL);
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, four(m.k_a, 1).v);
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, four(m.k_d, 1).v);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, four(m.k_s, 1).v);
  glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, emission_to_send(m, lighting).v);
  const double n = meets_zero_exponent_fault(m.n, lighting) ? smallest_shininess : m.n;
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, GLfloat(std::min(n, largest_shininess)));
  if (tracked == ColorMaterial::off) return;
  glColorMaterial(GL_FRONT_AND_BACK, color_material_mode(tracked));
  glEnable(GL_COLOR_MATERIAL);
  glColor3fv(four(material.color, 1).v);
}

std::vector<Text> fixed_function_notes(const Scene& scene, const EyeLighting<double>& lighting) {
  std::vector<Text> notes;
  if (const std::size_t lights = lighting.lights.size(); lights > std::size_t(gl_light_limit)) {
    const std::string n = std::to_string(lights);
    notes.push_back({"OpenGL's fixed function has 8 lights: the first 8 of " + n + " are drawn",
                     "OpenGL の固定機能の光源は 8 個まで：" + n + " 個のうち最初の 8 個を描く"});
  }
  double largest_n = 0;
  bool zero_exponent = false, singular = false;
  for (const Object& object : scene.objects) {
    if (!object.visible) continue;
    const double n = material_of(scene, object).n;
    largest_n = std::max(largest_n, n);
    zero_exponent = zero_exponent || meets_zero_exponent_fault(n, lighting);
    const glm::dmat3 m(matrix(object.transform));
    const double size = largest_column(glm::dmat4(m));
    singular = singular || !(std::abs(glm::determinant(size > 0 ? m * (1 / size) : m)) > 1e-20);
  }
  if (largest_n > largest_shininess)
    notes.push_back(Words{"GL_SHININESS ends at 128: a larger n is drawn as 128",
                          "GL_SHININESS は 128 まで：それより大きい n は 128 として描く"});
  if (zero_exponent)
    notes.push_back(Words{"n = 0 is sent as 0.000001: some drivers get 0 wrong where a light has a position or a cone",
                          "n = 0 は 0.000001 として送る：位置か円錐のある光源で 0 を誤るドライバーがあるため"});
  if (singular)
    notes.push_back(Words{"an object is scaled flat: OpenGL cannot invert its matrix, so its normals are wrong here",
                          "平らに潰れた物体がある：OpenGL は行列を逆にできず、法線が正しくない"});
  for (const EyeLight<double>& light : lighting.lights) {
    const std::string i = std::to_string(light.index);
    if (is_far(light, 1))
      notes.push_back({"light " + i + " is so far away that it is sent as directional",
                       "光源 " + i + " は非常に遠いので平行光源として送る"});
  }
  return notes;
}

}  // namespace cg
