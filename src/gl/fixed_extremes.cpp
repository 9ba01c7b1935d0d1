#include "gl/fixed_extremes.h"

#include <epoxy/gl.h>

#include <cfloat>
#include <cmath>

#include "shading/gl_calls.h"

namespace cg {

namespace {

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

// Whether the squares of a length stay inside float.
bool squares_in_float(double length) { return length > 1e-15 && length < 1e15; }

// `reach` is how far the picture's objects are from the eye.
bool light_as_listed(const Scene& scene, const EyeLight<double>& light, double reach) {
  const Light& given = scene.lights[std::size_t(light.index)];
  const double length = length_and_unit(given.position).length;
  if (light.spot_cosine > -2 && !squares_in_float(length_and_unit(given.direction).length)) return false;
  for (const double x : {given.position.x, given.position.y, given.position.z, given.w})
    if (!(std::abs(x) < 1e15)) return false;
  if (light.directional) return squares_in_float(length);
  if (const double k = std::max({light.k_0, light.k_1, light.k_2}); k != 0 && !squares_in_float(k)) return false;
  const double from_eye = length_and_unit(light.position).length;
  const double largest = std::max(length / std::abs(given.w), length_and_unit(scene.camera.position).length);
  return from_eye < far_away && largest <= 16 * std::max(from_eye, reach);
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

void send_lights_from_eye(const Scene& scene, const EyeLighting<double>& lighting, double eye_unit) {
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

EyeLighting<float> lighting_as_sent(const EyeLighting<double>& lighting, bool as_listed, double eye_unit) {
  EyeLighting<float> out{
      glm::vec3(lighting.ambient), {}, lighting.reflection, lighting.local_viewer, lighting.two_sided, lighting.clamp};
  for (const EyeLight<double>& light : lighting.lights) {
    if (int(out.lights.size()) == gl_light_limit) break;
    const bool cone = light.spot_cosine > -2;
    if (!as_listed && cone && light.spot_direction == glm::dvec3(0)) continue;
    Attenuation a{light.k_0, light.k_1, light.k_2, 1};
    if (!as_listed) a = attenuation_in_unit(light, eye_unit);
    EyeLight<float> sent{};
    sent.ambient = glm::vec3(light.ambient * a.share), sent.diffuse = glm::vec3(light.diffuse * a.share);
    sent.specular = glm::vec3(light.specular * a.share);
    sent.directional = light.directional || (!as_listed && is_far(light, eye_unit));
    sent.spot_cosine = cone ? 0.f : -2.f;
    sent.k_0 = float(a.k_0), sent.k_1 = float(a.k_1), sent.k_2 = float(a.k_2);
    out.lights.push_back(sent);
  }
  return out;
}

bool lights_as_listed(const Scene& scene, const EyeLighting<double>& lighting, const std::vector<DrawItem>& items) {
  double reach = 0;
  for (const DrawItem& item : items) {
    const glm::dmat4 to_eye(item.surface_to_eye);
    if (eye_unit(to_eye, item.surface->radius, scene.shading.normal_length) != 1) return false;
    reach = std::max(reach, length_and_unit(glm::dvec3(to_eye[3])).length);
  }
  return std::all_of(lighting.lights.begin(), lighting.lights.end(),
                     [&](const EyeLight<double>& light) { return light_as_listed(scene, light, reach); });
}

bool is_emission_of_nan(const EyeMaterial<double>& m, const EyeLighting<double>& lighting) {
  const glm::dvec3 sum = m.emission + lighting.ambient * m.k_a;
  return std::isnan(sum.x) || std::isnan(sum.y) || std::isnan(sum.z);
}

void send_emission_of_nan(const EyeMaterial<double>& m, const EyeLighting<double>& lighting) {
  if (!is_emission_of_nan(m, lighting)) return;
  Four emission = four(m.emission, 1);
  for (int c = 0; c < 3; ++c)
    if (std::isnan(m.emission[c] + lighting.ambient[c] * m.k_a[c])) emission.v[c] = lighting.clamp ? -FLT_MAX : NAN;
  glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, emission.v);
}

std::vector<Text> fixed_function_notes(const Scene& scene, const EyeLighting<double>& lighting,
                                       const std::vector<DrawItem>& items) {
  std::vector<Text> notes;
  auto add = [&](Text note) {
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(std::move(note));
  };
  for (const GlCall& call : gl_calls(scene))
    if (call.section == GlSection::material || call.function.empty())
      for (const Text& note : call.notes) add(note);
  for (const Object& object : scene.objects) {
    const glm::dmat3 m(matrix(object.transform));
    const double size = largest_column(glm::dmat4(m));
    if (object.visible && !(std::abs(glm::determinant(size > 0 ? m * (1 / size) : m)) > 1e-20))
      add(Words{"an object is scaled flat: OpenGL cannot invert its matrix, so its normals are wrong here",
                "平らに潰れた物体がある：OpenGL は行列を逆にできず、法線が正しくない"});
  }
  bool some_far = false;
  for (const EyeLight<double>& light : lighting.lights) {
    const std::string i = std::to_string(light.index);
    some_far = some_far || is_far(light, 1);
    if (is_far(light, 1))
      add({"light " + i + " is so far away that it is sent as directional",
           "光源 " + i + " は非常に遠いので平行光源として送る"});
  }
  if (!items.empty() && !some_far && !lights_as_listed(scene, lighting, items))
    add(Words{"sizes and distances here are too extreme for float: lights are sent relative to the eye",
              "大きさや距離が float には極端すぎるので、光源は視点からの相対位置で送る"});
  return notes;
}

}  // namespace cg
