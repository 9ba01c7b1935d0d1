#include "gl/program.h"

#include <stdexcept>

#include "gl/check.h"
#include "gl/surface_buffers.h"
#include "scene/cpu_clock.h"
#include "shading/layers.h"

namespace cg {

namespace {

GLuint compile(GLenum kind, const std::string& source) {
  const GLuint shader = glCreateShader(kind);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok) return shader;
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader, GLsizei(log.size()), &length, log.data());
  glDeleteShader(shader);
  throw std::logic_error("shader: " + log.substr(0, std::size_t(length)));
}

}  // namespace

Program::Program(const ShaderSource& source, const ShaderFeatures& features) : features_(features) {
  CpuClock clock;
  const GLuint vertex = compile(GL_VERTEX_SHADER, source.vertex);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, source.fragment);
  program_ = glCreateProgram();
  glAttachShader(program_, vertex);
  glAttachShader(program_, fragment);
  glBindAttribLocation(program_, position_attribute, "position");
  glBindAttribLocation(program_, normal_attribute, "normal");
  if (features.has("RADIOSITY")) glBindAttribLocation(program_, radiosity_attribute, "radiosity");
  if (optional(!features.layers.empty()))
    for (GLuint pair = 0; pair < most_layers / 2; ++pair)
      glBindAttribLocation(program_, uv_attribute + pair, ("uv_pair" + std::to_string(pair)).c_str());
  GLuint output = 0;
  glBindFragDataLocation(program_, output++, "colour");
  if (features.has("IDS")) glBindFragDataLocation(program_, output++, "id");
  if (features.has("NORMALS")) glBindFragDataLocation(program_, output++, "normal_out");
  glLinkProgram(program_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint ok = 0;
  glGetProgramiv(program_, GL_LINK_STATUS, &ok);
  if (ok) {
    find_lights();
    compile_ms_ = clock.lap_ms();
    return;
  }
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetProgramInfoLog(program_, GLsizei(log.size()), &length, log.data());
  glDeleteProgram(program_);
  throw std::logic_error("program: " + log.substr(0, std::size_t(length)));
}

GLint Program::location(const std::string& name) {
  const auto [found, added] = locations_.try_emplace(name, -1);
  if (added) found->second = glGetUniformLocation(program_, name.c_str());
  return found->second;
}

void Program::find_lights() {
  for (int i = 0; i < features_.lights; ++i) {
    const std::string light = "lights[" + std::to_string(i) + "].";
    const auto at = [&](const char* name) { return glGetUniformLocation(program_, (light + name).c_str()); };
    lights_.push_back({at("ambient"), at("diffuse"), at("specular"), at("position"), at("spot_direction"),
                       at("spot_cosine"), at("spot_exponent"), at("k_0"), at("k_1"), at("k_2"), at("directional")});
  }
}

void Program::set(const EyeLighting<float>& lighting, const EyeMaterial<float>& m,
                  const EyeMaterial<float>& changeable) {
  const auto vector = [](GLint to, const glm::vec3& v) {
    if (to >= 0) glUniform3fv(to, 1, &v.x);
  };
  const auto number = [](GLint to, float v) {
    if (to >= 0) glUniform1f(to, v);
  };
  std::size_t next = 0;
  for (const EyeLight<float>& light : lighting.lights) {
    if (next == lights_.size()) break;
    if (!light_parts(light, changeable).lit()) continue;
    const LightLocations& to = lights_[next++];
    vector(to.diffuse, light.diffuse), vector(to.position, light.position);
    if constexpr (only_plain) continue;
    vector(to.ambient, light.ambient), vector(to.specular, light.specular);
    vector(to.spot_direction, light.spot_direction);
    number(to.spot_cosine, light.spot_cosine), number(to.spot_exponent, light.spot_exponent);
    number(to.k_0, light.k_0), number(to.k_1, light.k_1), number(to.k_2, light.k_2);
    if (to.directional >= 0) glUniform1i(to.directional, light.directional);
  }
  if constexpr (only_plain) return set("material.k_d", m.k_d);
  const std::string material = features_.has("LAYERED_MATERIAL") ? "given." : "material.";
  if (features_.has("AMBIENT")) set("ambient", lighting.ambient);
  if (features_.has("K_A")) set(material + "k_a", m.k_a);
  if (features_.has("DIFFUSE")) set(material + "k_d", m.k_d);
  if (features_.has("SPECULAR")) set(material + "k_s", m.k_s), set(material + "n", m.n);
  if (features_.has("EMISSION")) set(material + "emission", m.emission);
}

void Program::set(int layer, const TextureLayer& numbers) {
  const std::string n = "[" + std::to_string(layer) + "]", to = "layers" + n + ".";
  const TextureTransform<float> matrix(numbers.matrix);
  const glm::vec2 u = matrix.difference({1, 0}), v = matrix.difference({0, 1});
  set("pictures" + n, layer);
  set(to + "u", glm::vec2(u.x, v.x)), set(to + "v", glm::vec2(u.y, v.y)), set(to + "offset", matrix.point({0, 0}));
  set(to + "scale", float(numbers.scale)), set(to + "amount", float(numbers.amount));
  if (features_.has("BLEND")) set(to + "blend_colour", glm::vec3(numbers.blend_colour));
  if (!features_.has("LEVEL_ZERO")) return;
  const Sampling& s = numbers.sampling;
  glUniform2i(location(to + "wrap"), int(s.wrap_s), int(s.wrap_t));
  set(to + "linear", int(s.mag_filter == MagFilter::linear));
  const glm::vec3 border(s.border);
  glUniform4f(location(to + "border"), border.r, border.g, border.b, float(s.border_alpha));
}

Program& ProgramCache::get(const ShaderFeatures& features, bool* kept) {
  const auto found = programs_.find(features);
  if (kept) *kept = found != programs_.end();
  if (found != programs_.end()) return found->second;
  return programs_.emplace(features, Program(surface_shaders(features), features)).first->second;
}

void ProgramCache::clear() {
  for (auto& [features, program] : programs_) program.release();
  programs_.clear();
}

}  // namespace cg
