// The matrix 1 - rho F as an image in the window: made on a thread of its own, asked with the mouse.
#pragma once
#include <functional>
#include <memory>
#include <mutex>

#include "radiosity/matrix_picture.h"
#include "ui/settings.h"
#include "ui/solver_desk.h"
#include "ui/texture.h"

namespace cg {

struct App;

class MatrixView {
 public:
  // `wake` is called on another thread when there is something new.
  explicit MatrixView(std::function<void()> wake) : wake_(std::move(wake)) {}

  // Once a frame in which it is seen: asks for the image with at most `side` cells a side. It stays where nothing of it
  // changed.
  void want(const SolutionHandle& solution, int side, MatrixChannel channel);
  // The newest; null before the first, or where it is of another system than was wanted last.
  std::shared_ptr<const MatrixPicture> picture() const;
  bool busy() const { return worker_.busy(); }

  // At ImGui's cursor, `side` pixels: the image, the row of the next step, of a shot its column. Returns the cell under
  // the mouse; null: none. Needs the window's OpenGL context, once there is a picture.
  const MatrixCell* draw(App& app, float side, const SolverState* now);

  MatrixChannel channel = MatrixChannel::mean;

 private:
  struct Wanted {
    SolutionHandle solution;
    int side = 0;
    MatrixChannel channel = MatrixChannel::mean;
  };
  void upload(const App& app, const std::shared_ptr<const MatrixPicture>& picture);

  const std::function<void()> wake_;
  Wanted wanted_;  // of the window's thread, as what follows
  std::shared_ptr<const MatrixPicture> shown_, uploaded_;
  Theme theme_ = Theme::dark;
  Texture texture_;
  mutable std::mutex mutex_;  // guards what follows
  std::shared_ptr<const MatrixPicture> newest_;
  std::uint64_t asked_ = 0, answered_ = 0;
  Worker worker_;  // last: it uses what stands above
};

// The colours of the image in a theme.
MatrixColours matrix_colours(Theme theme);

}  // namespace cg
