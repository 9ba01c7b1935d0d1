#include "ui/matrix_view.h"

#include <algorithm>
#include <cmath>

#include "ui/app.h"
#include "ui/state_dump.h"

namespace cg {

namespace {

// A row or a column of cells as a frame around it, never thinner than can be seen.
void mark(ImDrawList* draw, ImVec2 low, ImVec2 high, ImU32 colour, float thick) {
  draw->AddRect({low.x - thick, low.y - thick}, {high.x + thick, high.y + thick}, IM_COL32(0, 0, 0, 150), 0, 0,
                2.5f * thick);
  draw->AddRect({low.x - thick, low.y - thick}, {high.x + thick, high.y + thick}, colour, 0, 0, thick);
}

}  // namespace

MatrixColours matrix_colours(Theme theme) {
  // Okabe and Ito's blue and orange; on white as dark as letters in them are.
  if (theme == Theme::light) return {{255, 255, 255}, {150, 90, 0}, {0, 80, 140}, {214, 218, 224}};
  return {{10, 11, 13}, {240, 190, 60}, {120, 200, 255}, {38, 42, 49}};
}

void MatrixView::want(const SolutionHandle& solution, int side, MatrixChannel wanted) {
  side = std::clamp(side, 1, 4096);
  // The image does not depend on the light's sources.
  const bool same = wanted_.solution && solution && same_system(*wanted_.solution, *solution);
  if (same && wanted_.channel == wanted &&
      (wanted_.side == side || std::size_t(std::min(side, wanted_.side)) >= solution->matrix->size()))
    return;
  wanted_ = {solution, side, wanted};
  std::uint64_t serial = 0;
  {
    const std::lock_guard lock(mutex_);
    serial = ++asked_;
    if (!same) newest_ = nullptr;
  }
  worker_.submit(
      [this, solution, side, wanted, serial](Progress& progress) {
        auto made = std::make_shared<MatrixPicture>(
            matrix_picture(system_of(*solution->patches, solution->matrix), side, wanted, progress));
        {
          const std::lock_guard lock(mutex_);
          if (serial < asked_) return;
          newest_ = std::move(made), answered_ = serial;
        }
        if (wake_) wake_();
      },
      true);
}

std::shared_ptr<const MatrixPicture> MatrixView::picture() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

void MatrixView::upload(const App& app, const std::shared_ptr<const MatrixPicture>& picture) {
  if (picture == uploaded_ && theme_ == app.settings.theme) return;
  texture_.upload(picture_of(*picture, matrix_colours(app.settings.theme)));
  uploaded_ = picture, theme_ = app.settings.theme;
}

const MatrixCell* MatrixView::draw(App& app, float side, const SolverState* now) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos(), high{at.x + side, at.y + side};
  ImGui::InvisibleButton("matrix", {std::max(side, 1.0f), std::max(side, 1.0f)});
  if (app.dump) app.dump->place("matrix", at, high);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(at, high, look.palette.pane);
  const std::shared_ptr<const MatrixPicture> p = picture();
  if (!p || p->side == 0) return nullptr;
  shown_ = p;
  if (app.panes) {  // else there is no OpenGL, as in a test
    upload(app, p);
    texture_.magnify(true);
    draw->AddImage(texture_.id(), at, high);
  }
  const auto place = [&](int cell) { return side * float(cell) / float(p->side); };
  const float thick = std::max(1.0f, look.px(1));
  if (now && now->active && *now->active < p->rows) {
    const int cell = p->cell_of(*now->active);
    const bool shoots = now->task->options.solver == RadiositySolver::southwell ||
                        now->task->options.solver == RadiositySolver::progressive;
    draw->PushClipRect({at.x - 2 * thick, at.y - 2 * thick}, {high.x + 2 * thick, high.y + 2 * thick}, true);
    if (shoots)
      mark(draw, {at.x + place(cell), at.y}, {at.x + place(cell + 1), high.y}, look.of(Quantity::emission), thick);
    else
      mark(draw, {at.x, at.y + place(cell)}, {high.x, at.y + place(cell + 1)}, look.of(Quantity::emission), thick);
    draw->PopClipRect();
  }
  if (!ImGui::IsItemHovered()) return nullptr;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto cell_at = [&](float along) { return std::clamp(int(along / side * float(p->side)), 0, p->side - 1); };
  const int x = cell_at(mouse.x - at.x), y = cell_at(mouse.y - at.y);
  const ImVec2 low{at.x + place(x), at.y + place(y)};
  mark(draw, low, {at.x + place(x + 1), at.y + place(y + 1)}, IM_COL32(255, 255, 255, 255), thick);
  if (p->first_of(y) >= p->known) return nullptr;
  return &shown_->at(x, y);
}

}  // namespace cg
