// A knob's trade: what theory says, measured on demand, as a plot whose points the mouse asks about and the scene
// takes.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "measure/verdict.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/layout.h"
#include "ui/lines.h"
#include "ui/number.h"
#include "ui/trade_desk.h"
#include "ui/widgets.h"

namespace cg {
namespace {

void small_gap(const App& app) { ImGui::Dummy({1, app.look.px(4)}); }

// "h^1.98" as typeset() takes it: "h^{1.98}".
std::string grouped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    out += text[i];
    if (text[i] != '^') continue;
    const auto digit = [&](std::size_t k) { return k < text.size() && text[k] >= '0' && text[k] <= '9'; };
    std::size_t end = i + 1;
    if (end < text.size() && text[end] == '-') ++end;
    while (digit(end) || (end < text.size() && text[end] == '.' && digit(end + 1))) ++end;
    if (end == i + 1) continue;
    out += "{" + std::string(text.substr(i + 1, end - i - 1)) + "}";
    i = end - 1;
  }
  return out;
}

const Knob* chosen_knob(const App& app) {
  const std::span<const Knob> all = knobs();
  for (const Knob& knob : all)
    if (knob.id == app.settings.knob) return &knob;
  return all.empty() ? nullptr : &all.front();
}

void choose_knob(App& app, const Knob& knob) {
  const std::string shown(noted(app, knob.name));
  if (!begin_list(app, "##knob", shown.c_str(), ImGui::GetContentRegionAvail().x)) return;
  for (const Knob& one : knobs()) {
    ImGui::PushID(one.id.data(), one.id.data() + one.id.size());
    if (ImGui::Selectable(std::string(noted(app, one.name)).c_str(), one.id == knob.id))
      app.settings.knob = std::string(one.id);
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

// "error ∝ h^2", with the series' name where there are several.
void draw_laws(App& app, const Knob& knob) {
  Look& look = app.look;
  for (const Prediction& p : knob.predictions) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float baseline = at.y + look.px(17), right = at.x + ImGui::GetContentRegionAvail().x;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const Words title{"Theory: error ∝ ", "理論：誤差 ∝ "};
    float x = at.x + set_text(draw, look.fonts.small, {at.x, baseline}, look.palette.dim, noted(app, title));
    const float small = look.fonts.small->FontSize / look.fonts.text->FontSize;
    const TypeSize type{look.fonts.math, look.fonts.math_sub, small, small};
    x += typeset(draw, type, {x, baseline}, look.palette.text, noted(app, grouped(p.law)));
    if (knob.series.size() > 1 && p.series < knob.series.size()) {
      const std::string_view name = noted(app, knob.series[p.series].name);
      const float w = std::min(text_width(look.fonts.small, name), right - x - look.px(8));
      draw->PushClipRect({right - w, at.y}, {right, at.y + look.px(22)}, true);
      set_text(draw, look.fonts.small, {right - w, baseline}, look.palette.dim, name);
      draw->PopClipRect();
    }
    ImGui::Dummy({1, look.px(20)});
  }
}

void draw_measure(App& app, TradeDesk& desk, const Knob& knob, bool measured) {
  const Language l = app.language();
  const Knob* running = desk.running();
  if (running && running->id == knob.id) {
    if (button(app, "stop", {.label = Words{"Stop", "中止"}.in(l)})) desk.stop();
    ImGui::SameLine(0, app.look.px(10));
    progress_bar(app, desk.fraction(), ImGui::GetContentRegionAvail().x);
    return;
  }
  if (button(app, "measure",
             {.label = (measured ? Words{"Measure again", "測り直す"} : Words{"Measure", "測る"}).in(l),
              .tip = running ? Words{"What is being measured now is stopped", "今の測定は中止される"}
                             : Words{"The scene as it stands, in the background", "今のシーンを裏で測る"},
              .chosen = !measured}))
    desk.measure(app, knob);
  if (!measured) return;
  ImGui::SameLine(0, app.look.px(6));
  if (button(app, "save",
             {.label = Words{"Save …", "保存…"}.in(l), .tip = {"As CSV, JSON or SVG", "CSV・JSON・SVG で"}}))
    app.dialogue = {Dialogue::trade, {}, true, 2, std::string(knob.id)};
}

// One of the two pictures of a setting: `what` under it.
void draw_thumbnail(App& app, const Texture& texture, bool there, ImVec2 at, float side, std::string_view what) {
  Look& look = app.look;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 high{at.x + side, at.y + side};
  draw->AddRectFilled(at, high, look.palette.pane, look.px(2));
  if (there && !texture.empty()) {
    const float w = float(texture.width()), h = float(texture.height()), s = side / std::max(w, h);
    const ImVec2 low{std::floor(at.x + 0.5f * (side - w * s)), std::floor(at.y + 0.5f * (side - h * s))};
    draw->AddImage(texture.id(), low, {low.x + w * s, low.y + h * s});
  } else {
    set_text(draw, look.fonts.small, {at.x + look.px(8), at.y + look.px(20)}, look.palette.dim, noted(app, "…"));
  }
  draw->PushClipRect(at, {high.x, high.y + look.px(22)}, true);
  set_text(draw, look.fonts.small, {at.x, high.y + look.px(16)}, look.palette.dim, noted(app, what));
  draw->PopClipRect();
}

std::string ms_text(const Spread& ms) {
  return short_number(ms.median) + " ms  (" + short_number(ms.low) + "–" + short_number(ms.high) + ")";
}

std::string unit_text(const Knob& knob) { return knob.error_unit == "1" ? "" : " " + std::string(knob.error_unit); }

void draw_point(App& app, TradeDesk& desk, const MeasuredTrade& measured, std::size_t point) {
  const Language l = app.language();
  const Trade& trade = measured.trade;
  const Knob& knob = *trade.knob;
  const Setting& setting = trade.ladder.settings[point];
  const TradePoint& p = trade.points[point];
  const auto picture = desk.picture(app, knob, point);
  const bool there = desk.shows(picture);
  if (picture && !there) app.animating = true;  // the next frame has the textures
  const ImU32 ink = app.look.palette.text;
  small_pair_line(app, Words{"CPU time", "CPU 時間"}.in(l), ms_text(p.ms), ink);
  std::string rmse = short_number(p.errors.rmse) + unit_text(knob);
  if (p.errors.confidence > 0) rmse += " ±" + short_number(p.errors.confidence, 2);
  small_pair_line(app, "RMSE", rmse, ink);
  small_pair_line(app, Words{"Max", "最大"}.in(l), short_number(p.errors.max) + unit_text(knob), ink);
  small_gap(app);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, gap = app.look.px(8), side = std::floor(0.5f * (room - gap));
  const std::string difference =
      std::string(Words{"Difference", "基準との差"}.in(l)) +
      (picture && picture->gain > 1 ? " ×" + number_text(picture->gain, 0, 8) : std::string());
  draw_thumbnail(app, desk.shown(), there, at, side, setting.label.in(l));
  draw_thumbnail(app, desk.difference(), there, {at.x + side + gap, at.y}, side, difference);
  ImGui::Dummy({room, side + app.look.px(24)});
}

// What the error stands against: time, or the knob's own abscissa.
void choose_plot(App& app, const Knob& knob, bool& against_time) {
  const std::string letter(knob.abscissa.letter);
  const Text over_time(Words{"Error over time", "時間と誤差"});
  const Text over_knob("Error over " + letter, letter + " と誤差");
  ImGui::PushID("plots");
  if (tab(app, "time", over_time.in(app.language()), against_time)) against_time = true;
  ImGui::SameLine(0, app.look.px(3));
  if (tab(app, "slope", over_knob.in(app.language()), !against_time)) against_time = false;
  ImGui::PopID();
}

// In the panel, or large in place of the pictures.
void choose_size(App& app, TradeDesk& desk) {
  const std::string_view label =
      desk.large ? Words{"Pictures", "絵に戻る"}.in(app.language()) : Words{"Large", "大きく"}.in(app.language());
  const float width = tab_width(app, label), room = ImGui::GetContentRegionMax().x;
  ImGui::SameLine(0, app.look.px(3));
  if (ImGui::GetCursorPosX() + width > room)
    ImGui::NewLine();
  else
    ImGui::SetCursorPosX(room - width);
  if (tab(app, "large", label, desk.large)) desk.large = !desk.large;
}

void draw_verdicts(App& app, const Trade& trade) {
  const Language l = app.language();
  const Knob& knob = *trade.knob;
  for (const PredictionCheck& check : trade.checks) {
    const Prediction& p = knob.predictions[check.prediction];
    small_gap(app);
    if (knob.series.size() > 1 && p.series < knob.series.size()) heading(app, knob.series[p.series].name.in(l));
    small_text(app, grouped(check.verdict.in(l)), app.look.palette.text);
    small_text(app, grouped(p.why.in(l)), app.look.palette.dim);
    small_text(app, p.source, app.look.palette.dim);
  }
  for (const Text& note : trade.notes) small_text(app, note.in(l), app.look.palette.text);
}

void draw_conditions(App& app, const Trade& trade) {
  const Language l = app.language();
  std::string line = trade.scene + "  " + std::to_string(trade.width) + "×" + std::to_string(trade.height) + "  ";
  line += Text(std::to_string(trade.repeats) + " repeats", "反復 " + std::to_string(trade.repeats) + " 回").in(l);
  small_gap(app);
  small_text(app, line, app.look.palette.dim);
  small_text(app, trade.machine.cpu, app.look.palette.dim);
  if (!trade.machine.renderer.empty()) small_text(app, trade.machine.renderer, app.look.palette.dim);
}

int chosen_point(const TradeDesk& desk, const Knob& knob) {
  const auto found = desk.chosen.find(std::string(knob.id));
  return found == desk.chosen.end() ? -1 : int(found->second);
}

// The point under the mouse, or -1; a click takes it.
int plot_to_point_at(App& app, TradeDesk& desk, const Knob& knob, const MeasuredTrade& measured, ImVec2 size) {
  PlotView& view = desk.against_time ? desk.speed_view : desk.convergence_view;
  const auto& plot = desk.against_time ? measured.speed : measured.convergence;
  const PlotMouse mouse = draw_plot(app, view, "plot", plot, size, chosen_point(desk, knob));
  if (mouse.hovered < 0) return -1;
  const int point = int(plot->points[std::size_t(mouse.hovered)].index);
  if (mouse.clicked) {
    desk.chosen[std::string(knob.id)] = std::size_t(point);
    take_setting(app, measured, std::size_t(point));
  }
  return point;
}

void draw_measured(App& app, TradeDesk& desk, const Knob& knob, const std::shared_ptr<const MeasuredTrade>& measured) {
  choose_plot(app, knob, desk.against_time);
  choose_size(app, desk);
  int focus = desk.pointed;
  if (!desk.large) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = std::clamp(1.12f * width, app.look.px(240), app.look.px(480));
    focus = plot_to_point_at(app, desk, knob, *measured, {width, height});
  }
  if (focus < 0) focus = chosen_point(desk, knob);
  if (focus >= 0 && focus < int(measured->trade.points.size()))
    draw_point(app, desk, *measured, std::size_t(focus));
  else
    small_text(app,
               Words{"Rest the mouse on a point to see its picture; click it and the scene takes that setting.",
                     "点にマウスを置くと絵が出る。クリックするとシーンがその設定になる。"}
                   .in(app.language()),
               app.look.palette.dim);
  small_gap(app);
  small_text(app, knob.error.in(app.language()), app.look.palette.dim);
  draw_verdicts(app, measured->trade);
  draw_conditions(app, measured->trade);
}

}  // namespace

bool draw_large_trade(App& app, ImVec2 size) {
  if (!app.trades) return false;
  TradeDesk& desk = *app.trades;
  desk.pointed = -1;
  if (!desk.large || app.settings.side != Side::trade) return false;
  const Knob* knob = chosen_knob(app);
  const auto measured = knob ? desk.of(*knob) : nullptr;
  if (!measured || size.x < app.look.px(200) || size.y < app.look.px(160)) return false;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y}, app.look.palette.panel);
  desk.pointed = plot_to_point_at(app, desk, *knob, *measured, size);
  return true;
}

void draw_trade_panel(App& app) {
  const Knob* knob = chosen_knob(app);
  if (!knob) return;
  const Language l = app.language();
  TradeDesk& desk = trades_of(app);
  choose_knob(app, *knob);
  small_gap(app);
  const auto measured = desk.of(*knob);
  if (!measured) {
    small_text(app, knob->help.in(l), app.look.palette.dim);
    small_gap(app);
    draw_laws(app, *knob);
    small_gap(app);
  }
  draw_measure(app, desk, *knob, measured != nullptr);
  if (const auto problem = desk.problem(*knob)) small_text(app, problem->in(l), app.look.palette.error);
  small_gap(app);
  if (measured) return draw_measured(app, desk, *knob, measured);
  for (const Prediction& p : knob->predictions) {
    small_text(app, grouped(p.why.in(l)), app.look.palette.dim);
    small_text(app, p.source, app.look.palette.dim);
    small_gap(app);
  }
}

}  // namespace cg
