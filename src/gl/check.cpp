#include "gl/check.h"

#include <epoxy/gl.h>

#include <stdexcept>
#include <string>

#include "params/input_error.h"

namespace cg {

namespace {

std::string token(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
  }
  return "error " + std::to_string(error);
}

}  // namespace

void check_gl(const char* where) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  while (glGetError() != GL_NO_ERROR) {
  }
  if (error == GL_OUT_OF_MEMORY)
    throw InputError("OpenGL", Words{"there is not enough memory for this scene", "このシーンにはメモリーが足りません"},
                     Words{"a smaller mesh or picture would work", "メッシュか画像を小さくすれば描けます"});
  throw std::logic_error(std::string(where) + ": " + token(error));
}

}  // namespace cg
