// The hemicube of one patch: its five faces unfolded, what it sees by them, and the form factors that come of it.
#include <algorithm>
#include <array>

#include "ui/app.h"
#include "ui/hemicube_figures.h"
#include "ui/hemicube_marks.h"
#include "ui/layout.h"
#include "ui/lines.h"
#include "ui/parameter.h"
#include "ui/radiosity_desk.h"
#include "ui/row.h"
#include "ui/widgets.h"

namespace cg {
namespace {

void draw_shows(App& app) {
  constexpr auto& names = names_of<HemicubeShow>;
  constexpr std::array<Words, names.size()> tips{
      {{"Which patch each pixel sees. A click keeps it lit, a double click shows its own hemicube",
        "各画素に見えるパッチ。クリックで選び、ダブルクリックでそのパッチのヘミキューブへ移る"},
       {"What the patch sees: the solved light, or the materials", "パッチから見えるもの。解いた光か素材の色"},
       {"What each pixel counts", "各画素の重み"},
       {"The hemisphere and its shadow on the base", "半球と底面への射影"}}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, app.look.px(3));
    ImGui::PushID(int(i));
    if (tab(app, "show", names[i].label.in(app.language()), std::size_t(app.settings.hemicube) == i))
      app.settings.hemicube = HemicubeShow(i);
    if (wants_tooltip(app)) tooltip(app, {}, tips[i].in(app.language()), {});
    ImGui::PopID();
  }
  ImGui::Dummy({1, app.look.px(4)});
}

// What was drawn beside the window becomes textures; without pictures there is no OpenGL to draw with.
void take_pictures(App& app, HemicubeDesk& desk) {
  HemicubeArt& art = desk.art;
  const HemicubeDesk::State& state = desk.state();
  if (state.sight && art.sight != state.sight) {
    if (app.panes) art.picture.upload(state.sight->picture);
    art.picture.magnify(true);
    art.sight = state.sight;
  }
  if (state.pair && art.pair != state.pair) {
    const bool same = art.pair && art.pair->sight == state.pair->sight && art.pair->item == state.pair->item;
    if (app.panes && !same) art.others.upload(state.pair->others);
    art.others.magnify(true);
    art.pair = state.pair;
  }
}

void draw_controls(App& app, const HemicubeSight& sight) {
  const double last = double(sight.ground->patches.patches.size()) - 1;
  const About about{.name = "patch",
                    .range = {0, std::max(last, 1.0)},
                    .label = {"Patch", "パッチ"},
                    .help = {"Whose hemicube is shown. A click in a picture chooses one too.",
                             "ヘミキューブを見るパッチ。画像のクリックでも選べる。"}};
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {app.look.px(8), app.look.px(4)});
  const RowChange c = number_row(
      app,
      {.id = "patch", .symbol = "i", .about = &about, .value = double(std::max(app.settings.patch, 0)), .whole = true});
  ImGui::PopStyleVar();
  const auto choose_patch = [&](double number) {
    if (number >= 0 && number <= last) app.settings.patch = int(number);
  };
  if (c.moved) choose_patch(std::round(*c.moved));
  if (c.typed) {
    int number = -1;
    const Slot slot{"patch", &about, &number, &number};
    try {
      assign_text(slot, *c.typed);
      choose_patch(number);
    } catch (const InputError& e) {
      say(app, e);
    }
  }
  parameters(app, slots(app.scene), "radiosity.", {"resolution", "samples"});
}

// Where the matrix of the scene is made in another way than what is shown.
void draw_notes(App& app, const HemicubeDesk& desk) {
  const Radiosity& r = app.scene.radiosity;
  const Language l = app.language();
  const auto note = [&](const Words& words) { small_text(app, words.in(l), app.look.palette.dim); };
  if (desk.state().trouble) small_text(app, desk.state().trouble->in(l), app.look.palette.error);
  if (r.form_factors == FormFactors::hemicube && r.item_buffer == ItemBuffer::gl && !desk.draws_by_gl())
    note({"Drawn here by the software rasteriser.", "ここではソフトウェアで描いている。"});
  if (r.form_factors == FormFactors::hemicube && r.normalise == Normalise::reciprocal)
    note({"Rows are shown before they are made reciprocal.", "相反則に合わせる前の行を示す。"});
  if (r.form_factors == FormFactors::hemicube) return;
  const std::string method(names_of<FormFactors>[std::size_t(r.form_factors)].label.in(l));
  small_text(app,
             l == Language::english ? "The scene takes its form factors from: " + method + "."
                                    : "シーンの形態係数の計算法は「" + method + "」。",
             app.look.palette.dim);
}

}  // namespace

void draw_hemicube_panel(App& app) {
  HemicubeDesk& desk = hemicube_of(app);
  const Palette& p = app.look.palette;
  if (desk.turn_pointed()) app.animating = true;
  SolutionHandle solution;
  if (app.radiosity) solution = desk_of(app).state().newest.solution;
  desk.update(app.scene, solution, app.settings);
  for (Lines& lines : hemicube_lines(app)) app.pointed_next.push_back(std::move(lines));
  if (desk.busy()) app.next_frame = std::min(app.next_frame, app.now + 0.1);
  take_pictures(app, desk);
  draw_shows(app);
  if (desk.state().message) return small_text(app, desk.state().message->in(app.language()), p.error);
  if (!desk.art.sight && desk.state().trouble)
    return small_text(app, desk.state().trouble->in(app.language()), p.error);
  if (!desk.art.sight)
    return small_text(app, Words{"Dividing the scene into patches …", "シーンをパッチに分けている…"}.in(app.language()),
                      p.dim);
  const float room = ImGui::GetContentRegionAvail().x;
  // As wide as the panel, but not so high that the numbers below are gone.
  const float side = std::floor(std::clamp(ImGui::GetWindowHeight() * 0.5f, app.look.px(200), room));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::floor(0.5f * (room - side)));
  const bool nusselt = desk.art.sight->show == HemicubeShow::nusselt;
  const PointedPixel pixel = nusselt ? draw_nusselt(app, desk, side, side) : draw_hemicube_cross(app, desk, side);
  ImGui::SetCursorScreenPos(
      {ImGui::GetWindowPos().x + ImGui::GetStyle().WindowPadding.x, ImGui::GetCursorScreenPos().y});
  draw_pixel_lines(app, desk, pixel);
  draw_controls(app, *desk.art.sight);
  ImGui::Dummy({1, app.look.px(2)});
  draw_pair(app, desk);
  draw_notes(app, desk);
  draw_weights(app, desk);
  draw_row_bars(app, desk);
}

}  // namespace cg
