#include "ui/actions.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "ui/app.h"
#include "ui/lesson_player.h"
#include "ui/opening.h"
#include "ui/recording.h"

namespace cg {
namespace {

constexpr std::array list{
    Action{Do::open, {"Open", "開く"}, "Ctrl+O", GLFW_KEY_O, true},
    Action{Do::save, {"Save", "保存"}, "Ctrl+S", GLFW_KEY_S, true},
    Action{Do::picture, {"Picture", "画像"}, "Ctrl+P", GLFW_KEY_P, true},
    Action{Do::export_scene, {"Export", "書き出し"}, "Ctrl+E", GLFW_KEY_E, true},
    Action{Do::undo, {"Undo", "元に戻す"}, "Ctrl+Z", GLFW_KEY_Z, true},
    Action{Do::redo, {"Redo", "やり直す"}, "Ctrl+Y", GLFW_KEY_Y, true},
    Action{Do::redo, {"Redo", "やり直す"}, "Ctrl+Shift+Z", GLFW_KEY_Z, true, true},
    Action{Do::fit, {"Fit into view", "全体を表示"}, "F", GLFW_KEY_F},
    Action{Do::turntable, {"Turntable", "回転台"}, "T", GLFW_KEY_T},
    Action{Do::swap, {"Swap left and right", "左右を入れ替える"}, "Tab", GLFW_KEY_TAB},
    Action{Do::view_two, {"Two pictures", "並べる"}, "1", GLFW_KEY_1},
    Action{Do::view_wipe, {"Wipe", "ワイプ"}, "2", GLFW_KEY_2},
    Action{Do::view_flip, {"Flip", "切替"}, "3", GLFW_KEY_3},
    Action{Do::view_difference, {"Difference", "差"}, "4", GLFW_KEY_4},
    Action{Do::view_false_colour, {"False colour", "擬似カラー"}, "5", GLFW_KEY_5},
    Action{Do::larger, {"Larger type", "文字を大きく"}, "Ctrl +", GLFW_KEY_EQUAL, true},
    Action{Do::smaller, {"Smaller type", "文字を小さく"}, "Ctrl −", GLFW_KEY_MINUS, true},
    Action{Do::usual_size, {"Usual size", "標準の大きさ"}, "Ctrl 0", GLFW_KEY_0, true},
    Action{Do::language, {"日本語 / English", "日本語 / English"}, "L", GLFW_KEY_L},
    Action{Do::theme, {"Light or dark", "明るい・暗い配色"}, "D", GLFW_KEY_D},
    Action{Do::lesson, {"Lesson", "授業"}, "S", GLFW_KEY_S},
    Action{Do::world, {"The scene from outside", "外から見る"}, "O", GLFW_KEY_O},
    Action{Do::mistakes, {"Break it on purpose", "わざと間違える"}, "K", GLFW_KEY_K},
    Action{Do::presets, {"Presets A and B", "プリセット A・B"}, "A", GLFW_KEY_A},
    Action{Do::flip_presets, {"Flip presets A and B", "プリセット A・B の切替"}, "X", GLFW_KEY_X},
    Action{Do::challenge, {"Match a picture", "絵の再現"}, "H", GLFW_KEY_H},
    Action{Do::code, {"Program", "プログラム"}, "C", GLFW_KEY_C},
    Action{Do::plan, {"Plan", "計画"}, "P", GLFW_KEY_P},
    Action{Do::mesh, {"Mesh", "メッシュ"}, "M", GLFW_KEY_M},
    Action{Do::trade, {"Speed against accuracy", "速さと精度"}, "R", GLFW_KEY_R},
    Action{Do::extremes, {"Extreme values", "極端な値"}, "E", GLFW_KEY_E},
    Action{Do::solver, {"Radiosity solver", "ラジオシティの解法"}, "G", GLFW_KEY_G},
    Action{Do::hemicube, {"Hemicube", "ヘミキューブ"}, "U", GLFW_KEY_U},
    Action{Do::next_step, {"Next step", "次のステップ"}, "Page Down", GLFW_KEY_PAGE_DOWN},
    Action{Do::previous_step, {"Previous step", "前のステップ"}, "Page Up", GLFW_KEY_PAGE_UP},
    Action{Do::play, {"Play a slider", "スライダを動かす"}, "Space", GLFW_KEY_SPACE},
    Action{Do::present, {"Present", "発表"}, "F5", GLFW_KEY_F5},
    Action{Do::record, {"Record", "録画"}, "Ctrl+R", GLFW_KEY_R, true},
    Action{Do::help, {"Keys", "キー"}, "F1", GLFW_KEY_F1},
};

// Keys that stand for the same as one of the list: the number pad, and + with Shift.
struct Also {
  int key;
  bool ctrl;
  Do what;
};
constexpr std::array also{Also{GLFW_KEY_KP_ADD, true, Do::larger}, Also{GLFW_KEY_KP_SUBTRACT, true, Do::smaller},
                          Also{GLFW_KEY_KP_0, true, Do::usual_size}, Also{GLFW_KEY_F11, false, Do::present}};

void show_side(App& app, Side side) { app.settings.side = app.settings.side == side ? Side::none : side; }

void zoom(App& app, double factor) {
  const double next = std::round(app.settings.zoom * factor * 20) / 20;
  app.settings.zoom = std::clamp(next, 0.5, 3.0);
}

// A step on or back. In the presentation a long text is turned first, so that a clicker reaches all of it.
void go_on(App& app, int by) {
  LessonPlayer& player = lessons_of(app);
  Reading& reading = player.reading;
  stop_sweep(app);
  if (!app.presenter.on) {
    app.settings.side = Side::lesson;
    return player.go(by);
  }
  if (by > 0 ? reading.at < reading.most - 1 : reading.at > 1)
    reading.turn = by;
  else
    player.go(by);
}

// What is on top goes first: the list of keys, a slider that plays, the probe.
void escape(App& app) {
  if (std::exchange(app.help, false)) return;
  if (app.sweep.item) return stop_sweep(app);
  app.probing = {};
}

}  // namespace

std::span<const Action> actions() { return list; }

const Action& action(Do what) {
  const auto* found = std::find_if(list.begin(), list.end(), [&](const Action& a) { return a.what == what; });
  assert(found != list.end());
  return *found;
}

void perform(App& app, Do what) {
  switch (what) {
    case Do::open:
      app.dialogue = {Dialogue::open, {}, true};
      break;
    case Do::save:
      save_or_ask(app);
      break;
    case Do::picture:
      app.dialogue = {Dialogue::picture, "picture.png", true};
      break;
    case Do::export_scene:
      app.dialogue = {Dialogue::export_scene, {}, true, app.dialogue.format};
      break;
    case Do::undo:
      app.scene = app.history.undo();
      break;
    case Do::redo:
      app.scene = app.history.redo();
      break;
    case Do::fit:
      app.fit_asked = true;
      break;
    case Do::turntable:
      app.turntable = !app.turntable;
      break;
    case Do::swap:
      std::swap(app.left, app.right);
      break;
    case Do::view_two:
    case Do::view_wipe:
    case Do::view_flip:
    case Do::view_difference:
    case Do::view_false_colour:
      app.settings.view = ViewMode(int(what) - int(Do::view_two));
      break;
    case Do::larger:
      zoom(app, 1.1);
      break;
    case Do::smaller:
      zoom(app, 1 / 1.1);
      break;
    case Do::usual_size:
      app.settings.zoom = 1;
      break;
    case Do::language:
      app.settings.language = app.language() == Language::english ? Language::japanese : Language::english;
      break;
    case Do::theme:
      app.settings.theme = app.settings.theme == Theme::dark ? Theme::light : Theme::dark;
      break;
    case Do::lesson:
    case Do::world:
    case Do::mistakes:
    case Do::presets:
    case Do::challenge:
    case Do::plan:
    case Do::mesh:
    case Do::trade:
    case Do::extremes:
    case Do::solver:
    case Do::hemicube:
      static_assert(int(Do::hemicube) - int(Do::lesson) == int(Side::hemicube) - int(Side::lesson),
                    "in the same order");
      show_side(app, Side(int(Side::lesson) + int(what) - int(Do::lesson)));
      break;
    case Do::flip_presets:
      flip_presets(app);
      break;
    case Do::code:
      app.settings.code = !app.settings.code;
      break;
    case Do::next_step:
    case Do::previous_step:
      go_on(app, what == Do::next_step ? 1 : -1);
      break;
    case Do::play:
      toggle_sweep(app);
      break;
    case Do::present:
      app.presenter.on = !app.presenter.on;
      break;
    case Do::record:
      toggle_recording(app);
      break;
    case Do::help:
      app.help = !app.help;
      break;
  }
}

void handle_keys(App& app, std::span<const KeyPress> pressed) {
  // ImGui wants text for a frame longer than the field is there.
  if (ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive()) return;
  for (const KeyPress& p : pressed) {
    if (presenter_takes(app, p)) continue;
    if (p.key == GLFW_KEY_ESCAPE) escape(app);
    if (app.dialogue.kind != Dialogue::none || p.other) continue;
    for (const Action& a : list) {
      if (a.key != p.key || a.ctrl != p.ctrl) continue;
      const bool shift_matters = a.key == GLFW_KEY_Z || !a.ctrl;  // + is = with Shift
      if (shift_matters && a.shift != p.shift) continue;
      if (p.repeat && a.what != Do::undo && a.what != Do::redo) continue;
      perform(app, a.what);
    }
    for (const Also& a : also)
      if (a.key == p.key && a.ctrl == p.ctrl && !p.repeat) perform(app, a.what);
  }
}

}  // namespace cg
