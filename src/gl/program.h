// Linked GLSL programs, made once for each set of features.
#pragma once
#include <epoxy/gl.h>

#include <map>
#include <string>

#include "gl/shader_source.h"

namespace cg {

class Program {
 public:
  // Throws std::logic_error with the driver's log: the sources are ours.
  explicit Program(const ShaderSource& source, const ShaderFeatures& features);

  void use() const { glUseProgram(program_); }
  void release() { glDeleteProgram(program_); }
  // Uniforms that the program does not have are left out silently: OpenGL drops those it does not use.
  void set(const std::string& name, float v) { glUniform1f(location(name), v); }
  void set(const std::string& name, int v) { glUniform1i(location(name), v); }
  void set(const std::string& name, const glm::vec3& v) { glUniform3fv(location(name), 1, &v.x); }
  void set(const std::string& name, const glm::mat3& m) { glUniformMatrix3fv(location(name), 1, GL_FALSE, &m[0].x); }
  void set(const std::string& name, const glm::mat4& m) { glUniformMatrix4fv(location(name), 1, GL_FALSE, &m[0].x); }
  void set(const EyeLighting<float>& lighting);
  void set(const EyeMaterial<float>& material);

 private:
  GLint location(const std::string& name);
  GLuint program_ = 0;
  std::map<std::string, GLint> locations_;
};

// Belongs to one context: every call on its thread.
class ProgramCache {
 public:
  Program& get(const ShaderFeatures& features);
  void clear();
  std::size_t size() const { return programs_.size(); }

 private:
  std::map<ShaderFeatures, Program> programs_;
};

}  // namespace cg
