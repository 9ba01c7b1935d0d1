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
  void set(const std::string& name, const glm::vec2& v) { glUniform2fv(location(name), 1, &v.x); }
  void set(const std::string& name, const glm::vec3& v) { glUniform3fv(location(name), 1, &v.x); }
  void set(const std::string& name, const glm::mat3& m) { glUniformMatrix3fv(location(name), 1, GL_FALSE, &m[0].x); }
  void set(const std::string& name, const glm::mat4& m) { glUniformMatrix4fv(location(name), 1, GL_FALSE, &m[0].x); }
  // The lights that add something on the material, and the material. `changeable`: what layers may make of it.
  void set(const EyeLighting<float>& lighting, const EyeMaterial<float>& material,
           const EyeMaterial<float>& changeable);
  // The numbers of one of `features().layers`, by its index there.
  void set(int layer, const TextureLayer& numbers);

  const ShaderFeatures& features() const { return features_; }
  double compile_ms() const { return compile_ms_; }
  GLuint name() const { return program_; }

 private:
  struct LightLocations {
    GLint ambient, diffuse, specular, position, spot_direction, spot_cosine, spot_exponent, k_0, k_1, k_2, directional;
  };
  void find_lights();
  GLint location(const std::string& name);
  ShaderFeatures features_;
  double compile_ms_ = 0;
  GLuint program_ = 0;
  std::vector<LightLocations> lights_;
  std::map<std::string, GLint> locations_;
};

// Belongs to one context: every call on its thread.
class ProgramCache {
 public:
  // `kept`, if not null: whether it was there already.
  Program& get(const ShaderFeatures& features, bool* kept = nullptr);
  void clear();
  std::size_t size() const { return programs_.size(); }

 private:
  std::map<ShaderFeatures, Program> programs_;
};

}  // namespace cg
