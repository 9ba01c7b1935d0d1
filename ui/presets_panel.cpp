// Presets A and B: kept, shown in turn by one key, and what differs between them, line by line to be taken over.
#include <algorithm>
#include <array>
#include <string>

#include "params/slots.h"
#include "ui/actions.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/layout.h"
#include "ui/lines.h"
#include "ui/presets.h"
#include "ui/widgets.h"

namespace cg {
namespace {

constexpr std::array<const char*, 2> letters{"A", "B"};

void small_gap(const App& app) { ImGui::Dummy({1, app.look.px(4)}); }

// The letter, and what is kept there at the right end.
void name_line(App& app, std::string_view letter, std::string_view name) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, baseline = at.y + look.px(19);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  set_text(draw, look.fonts.bold, {at.x, baseline}, look.palette.text, letter);
  const float w = std::min(text_width(look.fonts.small, noted(app, name)), room - look.px(30));
  draw->PushClipRect({at.x + room - w, at.y}, {at.x + room, at.y + look.px(26)}, true);
  set_text(draw, look.fonts.small, {at.x + room - w, baseline}, look.palette.dim, name);
  draw->PopClipRect();
  ImGui::Dummy({room, look.px(22)});
}

// One of the two: its letter, what it is, and what can be done with it.
void draw_one(App& app, int which) {
  const Language l = app.language();
  const std::optional<Scene>& kept = app.presets.kept[std::size_t(which)];
  ImGui::PushID(which);
  name_line(app, letters[std::size_t(which)],
            kept ? std::string_view(app.presets.names[std::size_t(which)]) : Words{"empty", "空"}.in(l));
  const bool shown = kept && app.scene == *kept;
  if (button(app, "store",
             {.label = Words{"Store", "控える"}.in(l),
              .tip = {"Keeps the scene as it is now", "今のシーンを控える"},
              .enabled = !shown}))
    store_preset(app, which);
  ImGui::SameLine(0, app.look.px(4));
  if (button(app, "show", {.label = Words{"Show", "見る"}.in(l), .chosen = shown, .enabled = bool(kept)}))
    show_preset(app, which);
  ImGui::SameLine(0, app.look.px(4));
  if (button(app, "save",
             {.label = Words{"Save …", "保存…"}.in(l),
              .tip = {"As a preset, C or a GLUT program", "プリセット・C・GLUT プログラムとして"},
              .enabled = bool(kept)})) {
    show_preset(app, which);
    perform(app, Do::export_scene);
  }
  ImGui::PopID();
}

std::string value_text(const Tree& value, Language l) {
  if (value.is_null()) return std::string(Words{"none", "なし"}.in(l));
  if (value.members()) return std::string(Words{"there", "あり"}.in(l));
  if (const std::string* text = value.string()) return *text;
  const Tree::List* list = value.list();
  if (!list) return to_json(value, 0);
  std::string text;
  for (const Tree& item : *list) text += (text.empty() ? "" : "  ") + to_json(item, 0);
  return text;
}

// A value that is pressed to be taken over: true then. Marked where it is that of the scene in hand.
bool draw_value(App& app, const ParameterDifference& d, int which, bool in_hand, ImVec2 at, float width) {
  Look& look = app.look;
  const float h = look.px(22);
  const std::string text = value_text(which == 0 ? d.a : d.b, app.language());
  ImGui::SetCursorScreenPos(at);
  ImGui::PushID(which);
  const bool pressed = ImGui::InvisibleButton("take", {width, h});
  ImGui::PopID();
  const bool can = bool(app.presets.kept[std::size_t(which)]), hovered = ImGui::IsItemHovered() && can;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (hovered) draw->AddRectFilled(at, {at.x + width, at.y + h}, look.palette.raised, look.px(3));
  if (in_hand)
    draw->AddRectFilled({at.x, at.y + look.px(4)}, {at.x + look.px(2), at.y + h - look.px(4)}, look.palette.accent);
  draw->PushClipRect(at, {at.x + width, at.y + h}, true);
  set_text(draw, look.fonts.small_mono, {at.x + look.px(7), at.y + look.px(15.5f)},
           in_hand ? look.palette.text : look.palette.dim, noted(app, text));
  draw->PopClipRect();
  if (wants_tooltip(app))
    tooltip(app, d.path,
            can ? Words{"Click: this value for the scene", "クリックでこの値を取り込む"}.in(app.language()) : "", text);
  if (pressed && can) take_over(app, d.path, which);
  return pressed && can;
}

// The label and the path, and under them the two values beside each other; true where one was taken over.
bool draw_difference(App& app, const ParameterDifference& d, const Slots& now) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, half = 0.5f * room;
  const Quantity quantity = d.about ? d.about->quantity : Quantity::none;
  ImGui::PushID(d.path.c_str());
  const std::string_view label =
      d.about ? d.about->label.in(app.language()) : Words{"Only on one side", "片方だけにある"}.in(app.language());
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float w = set_text(draw, look.fonts.small, {at.x, at.y + look.px(15)},
                           quantity == Quantity::none ? look.palette.text : look.of(quantity), noted(app, label));
  draw->PushClipRect(at, {at.x + room, at.y + look.px(22)}, true);
  set_text(draw, look.fonts.small_mono, {at.x + w + look.px(10), at.y + look.px(15)}, faded(look.palette.dim, 0.8f),
           d.path);
  draw->PopClipRect();
  const auto slot = std::find_if(now.begin(), now.end(), [&](const Slot& s) { return s.path == d.path; });
  const std::optional<Tree> value = slot == now.end() ? std::nullopt : std::optional(slot_tree(*slot));
  const bool took_a = draw_value(app, d, 0, value && *value == d.a, {at.x, at.y + look.px(20)}, half);
  const bool took_b = draw_value(app, d, 1, value && *value == d.b, {at.x + half, at.y + look.px(20)}, half);
  if (quantity != Quantity::none && ImGui::IsWindowHovered() &&
      ImGui::IsMouseHoveringRect(at, {at.x + room, at.y + look.px(42)}))
    app.lit_next = quantity;
  ImGui::SetCursorScreenPos({at.x, at.y + look.px(46)});
  ImGui::PopID();
  return took_a || took_b;
}

void draw_differences(App& app) {
  const Language l = app.language();
  const auto& kept = app.presets.kept;
  if (!kept[0] && !kept[1]) {
    small_text(app,
               Words{"Store the scene in A, change it, store it in B; then X shows them in turn.",
                     "シーンを A に控え、変えてから B に控える。X キーで切り替えて見比べる。"}
                   .in(l),
               app.look.palette.dim);
    return;
  }
  const auto differences = app.presets.differences(app.scene);  // a copy: what is taken over changes them
  std::string title(Words{"Differences", "違い"}.in(l));
  title += "  A · ";
  title += kept[0] && kept[1] ? "B" : Words{"the scene now", "今のシーン"}.in(l);
  if (!kept[0]) title = std::string(Words{"Differences  the scene now · B", "違い  今のシーン · B"}.in(l));
  heading(app, title);
  if (differences.empty()) small_text(app, Words{"None", "なし"}.in(l), app.look.palette.dim);
  const Slots now = slots(app.scene);
  constexpr std::size_t most = 100;
  for (std::size_t i = 0; i < std::min(differences.size(), most); ++i)
    if (draw_difference(app, differences[i], now)) return;  // the slots are stale
  if (differences.size() > most) small_text(app, "…", app.look.palette.dim);
}

// What was not understood of a C file, with its lines.
void draw_complaints(App& app) {
  PresetShelf& shelf = app.presets;
  if (shelf.imported.empty()) return;
  const Language l = app.language();
  heading(app, Words{"Read from C", "C から読み込み"}.in(l));
  ImGui::PushFont(app.look.fonts.small_mono);
  write(app, shelf.imported);
  ImGui::PopFont();
  if (shelf.complaints.empty())
    small_text(app, Words{"All of it was understood.", "すべて読み取れました。"}.in(l), app.look.palette.dim);
  for (const Complaint& c : shelf.complaints) {
    std::string text = c.line > 0 ? std::to_string(c.line) + ": " : std::string();
    small_text(app, text + c.text.in(l), app.look.palette.text);
  }
  if (button(app, "forget", {.label = Words{"Close", "閉じる"}.in(l), .quiet = true})) shelf.imported.clear();
  small_gap(app);
}

}  // namespace

void draw_presets_panel(App& app) {
  draw_complaints(app);
  draw_one(app, 0);
  small_gap(app);
  draw_one(app, 1);
  small_gap(app);
  const Action& flip = action(Do::flip_presets);
  if (button(app, "flip",
             {.label = Words{"Flip A and B", "A と B を切り替える"}.in(app.language()),
              .tip = flip.label,
              .shortcut = flip.keys,
              .enabled = app.presets.kept[0] || app.presets.kept[1]}))
    perform(app, Do::flip_presets);
  small_gap(app);
  draw_differences(app);
}

}  // namespace cg
