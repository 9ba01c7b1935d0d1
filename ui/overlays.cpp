// What lies over the window: what was to be said, the list of keys.
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <string>

#include "ui/actions.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/layout.h"

namespace cg {

void say(App& app, Text text) {
  if (app.toasts.size() >= 5) app.toasts.erase(app.toasts.begin());
  app.toasts.push_back({std::move(text), false, app.now + 6});
}

void say(App& app, const InputError& error) {
  say(app, Text(error.message(Language::english), error.message(Language::japanese)));
  app.toasts.back().error = true;
  app.toasts.back().until = app.now + 15;
}

void write(App& app, std::string_view text) {
  noted(app, text);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
}
void write(App& app, const Words& words) { write(app, words.in(app.language())); }
void write(App& app, const Text& text) { write(app, text.in(app.language())); }

void draw_toasts(App& app, ImVec2 size) {
  std::erase_if(app.toasts, [&](const Toast& t) { return !(t.until > app.now); });
  Look& look = app.look;
  float bottom = size.y - look.px(20);
  for (std::size_t i = app.toasts.size(); i-- > 0;) {
    Toast& toast = app.toasts[i];
    app.next_frame = std::min(app.next_frame, toast.until + 0.01);
    const std::string_view text = noted(app, toast.text);
    const float wrap = std::min(look.px(620), size.x - look.px(60));
    if (!(wrap > look.px(40))) return;
    ImFont* font = look.fonts.text;
    const ImVec2 extent =
        font->CalcTextSizeA(font->FontSize, FLT_MAX, wrap - look.px(36), text.data(), text.data() + text.size());
    const ImVec2 box{extent.x + look.px(36), extent.y + look.px(22)};
    ImGui::SetNextWindowPos({std::floor(0.5f * (size.x - box.x)), std::floor(bottom - box.y)});
    ImGui::SetNextWindowSize(box);
    const std::string id = "toast " + std::to_string(i);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, look.palette.raised);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, look.px(6));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {look.px(20), look.px(11)});
    ImGui::Begin(id.c_str(), nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
    const ImVec2 at = ImGui::GetWindowPos();
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + look.px(5), at.y + box.y},
                                              toast.error ? look.palette.error : look.palette.accent, look.px(6),
                                              ImDrawFlags_RoundCornersLeft);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + extent.x + 1);
    write(app, text);
    ImGui::PopTextWrapPos();
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) toast.until = 0;
    ImGui::End();
    bottom -= box.y + look.px(8);
  }
}

void draw_help(App& app) {
  if (!app.help) return;
  Look& look = app.look;
  const ImVec2 size = ImGui::GetWindowSize(), origin = ImGui::GetWindowPos();
  ImGui::SetNextWindowPos({origin.x + 0.5f * size.x, origin.y + 0.5f * size.y}, 0, {0.5f, 0.5f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {look.px(28), look.px(22)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, look.px(8));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.palette.raised);
  ImGui::Begin("keys", &app.help,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  const Language l = app.language();
  const ImVec2 top = ImGui::GetCursorScreenPos();
  float y = top.y;
  auto line = [&](int column, std::string_view keys, std::string_view what) {
    const float x = top.x + float(column) * look.px(390);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    set_text(draw, look.fonts.mono, {x, y + look.px(18)}, look.palette.dim, noted(app, keys));
    set_text(draw, look.fonts.text, {x + look.px(170), y + look.px(18)}, look.palette.text, noted(app, what));
    y += look.px(26);
  };
  auto title = [&](int column, const Words& words) {
    set_text(ImGui::GetWindowDrawList(), look.fonts.bold, {top.x + float(column) * look.px(390), y + look.px(18)},
             look.palette.text, noted(app, words));
    y += look.px(34);
  };
  const std::size_t first = (actions().size() + 7) / 2;  // the rest stands above the mouse, in the second column
  title(0, {"Keys", "キー"});
  for (std::size_t i = 0; i < std::min(first, actions().size()); ++i)
    line(0, actions()[i].keys, actions()[i].label.in(l));
  const float bottom = y;
  y = top.y + look.px(34);
  for (std::size_t i = first; i < actions().size(); ++i) line(1, actions()[i].keys, actions()[i].label.in(l));
  constexpr std::array<std::pair<Words, Words>, 6> mouse{
      {{{"Click a value", "数値をクリック"}, {"Type it", "値を入力"}},
       {{"Wheel on a value", "数値でホイール"}, {"Turn it a little", "少しずつ変える"}},
       {{"Shift", "Shift"}, {"Ten times finer", "10 倍細かく動かす"}},
       {{"Click a picture", "画像をクリック"}, {"Numbers of the pixel", "その画素の数値を出す"}},
       {{"Click a term", "項をクリック"}, {"Draw it alone", "その項だけを描く"}},
       {{"Drop a file", "ファイルをドロップ"}, {"Open it", "開く"}}}};
  y += look.px(10);
  title(1, {"Mouse", "マウス"});
  for (const auto& [where, what] : mouse) line(1, where.in(l), what.in(l));
  ImGui::Dummy({look.px(390 + 360), std::max(bottom, y) - top.y});
  if (ImGui::IsMouseClicked(0) && !ImGui::IsWindowHovered() && !ImGui::IsWindowAppearing()) app.help = false;
  ImGui::End();
}

}  // namespace cg
