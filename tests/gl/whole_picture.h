// A fragment shader run once for each pixel of a square picture of floats, in the context that is current.
#pragma once
#include <epoxy/gl.h>

#include <glm/vec4.hpp>
#include <vector>

#include "gl/check.h"

namespace cg {

class WholePicture {
 public:
  WholePicture(int side, const char* fragment) : side_(side), program_(make_program(fragment)) {
    GLuint array, target, buffer;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenTextures(1, &target);
    glBindTexture(GL_TEXTURE_2D, target);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, side, side, 0, GL_RGBA, GL_FLOAT, nullptr);
    glGenFramebuffers(1, &buffer);
    glBindFramebuffer(GL_FRAMEBUFFER, buffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
    glViewport(0, 0, side, side);
    check_gl("set up");
  }

  static GLuint make_program(const char* fragment) {
    constexpr const char* vertex =
        "#version 330 core\n"
        "void main() { gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0); }\n";
    const GLuint program = glCreateProgram();
    for (const auto& [kind, text] : {std::pair{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}) {
      const GLuint s = glCreateShader(GLenum(kind));
      glShaderSource(s, 1, &text, nullptr);
      glCompileShader(s);
      glAttachShader(program, s);
    }
    glLinkProgram(program);
    return program;
  }

  // One value a pixel, to be fetched, not filtered; bound to the unit.
  GLuint table(const std::vector<glm::vec4>& values, int unit) const {
    GLuint t;
    glGenTextures(1, &t);
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, t);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, side_, side_, 0, GL_RGBA, GL_FLOAT, values.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return t;
  }

  GLuint program() const { return program_; }
  void use() const { glUseProgram(program_); }
  // By the program in use; row 0 is the lowest.
  std::vector<glm::vec4> draw() const {
    std::vector<glm::vec4> out(std::size_t(side_) * std::size_t(side_));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glReadPixels(0, 0, side_, side_, GL_RGBA, GL_FLOAT, out.data());
    check_gl("read");
    return out;
  }

 private:
  int side_;
  GLuint program_;
};

}  // namespace cg
