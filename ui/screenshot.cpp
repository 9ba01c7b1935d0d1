#include "ui/screenshot.h"

#include <epoxy/gl.h>
// After epoxy.
#include <GLFW/glfw3.h>

#include <vector>

#include "params/file.h"
#include "ui/app.h"

namespace cg {

bool Screenshot::wanted(App& app) {
  if (file_.empty()) return false;
  app.animating = true;
  const bool ready = app.figures.valid && !app.errands->busy() && !app.look.glyphs.changed;
  calm_ = ready ? calm_ + 1 : 0;
  return calm_ > 5 || app.now > 20;
}

void Screenshot::take(GLFWwindow* window) const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  std::vector<unsigned char> rows(std::size_t(width) * std::size_t(height) * 3);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadBuffer(GL_BACK);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rows.data());
  std::string out = "P6\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  for (int y = height - 1; y >= 0; --y)
    out.append(reinterpret_cast<const char*>(rows.data()) + std::size_t(y) * std::size_t(width) * 3,
               std::size_t(width) * 3);
  save_file(file_, out);
}

}  // namespace cg
