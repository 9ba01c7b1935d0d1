#include "gl/program.h"

#include <stdexcept>

#include "gl/check.h"
#include "gl/surface_buffers.h"

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

Program::Program(const ShaderSource& source, const ShaderFeatures& features) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, source.vertex);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, source.fragment);
  program_ = glCreateProgram();
  glAttachShader(program_, vertex);
  glAttachShader(program_, fragment);
  glBindAttribLocation(program_, position_attribute, "position");
  glBindAttribLocation(program_, normal_attribute, "normal");
  GLuint output = 0;
  glBindFragDataLocation(program_, output++, "colour");
  if (features.has("IDS")) glBindFragDataLocation(program_, output++, "id");
  if (features.has("NORMALS")) glBindFragDataLocation(program_, output++, "normal_out");
  glLinkProgram(program_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint ok = 0;
  glGetProgramiv(program_, GL_LINK_STATUS, &ok);
  if (ok) return;
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

void Program::set(const EyeLighting<float>& lighting) {
  set("ambient", lighting.ambient);
  for (std::size_t i = 0; i < lighting.lights.size(); ++i) {
    const EyeLight<float>& light = lighting.lights[i];
    const std::string name = "lights[" + std::to_string(i) + "].";
    set(name + "ambient", light.ambient);
    set(name + "diffuse", light.diffuse);
    set(name + "specular", light.specular);
    set(name + "position", light.position);
    set(name + "spot_direction", light.spot_direction);
    set(name + "spot_cosine", light.spot_cosine);
    set(name + "spot_exponent", light.spot_exponent);
    set(name + "k_0", light.k_0);
    set(name + "k_1", light.k_1);
    set(name + "k_2", light.k_2);
    set(name + "directional", int(light.directional));
  }
}

void Program::set(const EyeMaterial<float>& m) {
  set("material.k_a", m.k_a);
  set("material.k_d", m.k_d);
  set("material.k_s", m.k_s);
  set("material.emission", m.emission);
  set("material.n", m.n);
}

Program& ProgramCache::get(const ShaderFeatures& features) {
  if (const auto found = programs_.find(features); found != programs_.end()) return found->second;
  return programs_.emplace(features, Program(surface_shaders(features), features)).first->second;
}

void ProgramCache::clear() {
  for (auto& [features, program] : programs_) program.release();
  programs_.clear();
}

}  // namespace cg
