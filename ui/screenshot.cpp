#include "ui/screenshot.h"

#include <epoxy/gl.h>
// After epoxy.
#include <GLFW/glfw3.h>

#include <algorithm>
#include <vector>

#include "image/image_file.h"
#include "ui/app.h"
#include "ui/hemicube_desk.h"
#include "ui/lesson_player.h"
#include "ui/radiosity_desk.h"
#include "ui/solver_panel.h"

namespace cg {

bool Screenshot::wanted(App& app, bool fonts_busy) {
  if (file_.empty()) return false;
  app.animating = true;
  const bool lesson = app.lessons && (app.lessons->loading() || app.lessons->busy());
  const bool solving = app.radiosity && app.radiosity->state().busy;
  const bool ready = app.figures.valid && !lesson && !solving && !solver_at_work(app) && !looks_at_hemicube(app) &&
                     !app.errands->busy() && !fonts_busy && !app.look.glyphs.changed;
  calm_ = ready ? calm_ + 1 : 0;
  return calm_ > 5 || app.now > 20;
}

Picture window_picture(GLFWwindow* window) {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  std::vector<glm::u8vec4> rows(std::size_t(width) * std::size_t(height));
  glReadBuffer(GL_BACK);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
  Picture picture(width, height);
  for (int y = 0; y < height; ++y)
    std::copy_n(rows.data() + std::size_t(height - 1 - y) * std::size_t(width), width, picture.row(y));
  return picture;
}

void Screenshot::take(GLFWwindow* window) const { write_image(file_, window_picture(window)); }

}  // namespace cg
