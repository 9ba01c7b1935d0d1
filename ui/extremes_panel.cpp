// Extreme cases: a list with what came out of each, and under the one that was clicked what is right, what each
// technique gave, and the naive form beside the robust one.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/app.h"
#include "ui/extremes_desk.h"
#include "ui/formula.h"
#include "ui/layout.h"
#include "ui/lines.h"
#include "ui/number.h"
#include "ui/state_dump.h"
#include "ui/verdict_mark.h"
#include "ui/widgets.h"

namespace cg {
namespace {

void small_gap(const App& app) { ImGui::Dummy({1, app.look.px(4)}); }

std::string_view name_of(const App& app, std::string_view by) {
  const Language l = app.language();
  for (const Technique& t : app.techniques)
    if (t.id == by) return t.name.in(l);
  if (by == "software-float") return Words{"Software, float", "ソフトウェア（float）"}.in(l);
  if (by == "reader") return Words{"The program says", "プログラムの答え"}.in(l);
  if (by == "arithmetic") return Words{"The robust form", "頑健な式"}.in(l);
  return by;
}

// What one technique gave: its sign, its name, and how it is off.
void draw_result(App& app, const ExtremeCase& subject, const ExtremeResult& result) {
  Look& look = app.look;
  const Language l = app.language();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, baseline = at.y + look.px(15);
  draw_verdict_mark(app, {at.x + look.px(7), at.y + look.px(10)}, result.verdict);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  std::string figure;
  if (result.verdict == Verdict::right || result.verdict == Verdict::off || result.verdict == Verdict::driver)
    figure = subject.input ? "" : number_text(result.error, 0, 7);
  else
    figure = std::string(names_of<Verdict>[std::size_t(result.verdict)].label.in(l));
  const float w = text_width(look.fonts.small, noted(app, figure));
  draw->PushClipRect(at, {at.x + room - w - look.px(6), at.y + look.px(22)}, true);
  set_text(draw, look.fonts.small, {at.x + look.px(20), baseline}, look.palette.text,
           noted(app, name_of(app, result.by)));
  draw->PopClipRect();
  set_text(draw, look.fonts.small, {at.x + room - w, baseline}, look.palette.dim, figure);
  ImGui::Dummy({room, look.px(20) - ImGui::GetStyle().ItemSpacing.y});
  const bool tells = result.verdict != Verdict::right || subject.input;
  if (!tells || result.said.in(l).empty()) return;
  ImGui::Indent(look.px(20));
  small_text(app, result.said.in(l), look.palette.dim);
  ImGui::Unindent(look.px(20));
}

bool differs(double value, double right) {
  if (std::isnan(value) || std::isnan(right)) return std::isnan(value) != std::isnan(right);
  if (std::isinf(value) || std::isinf(right)) return value != right;
  return std::abs(value - right) > 1e-3 * std::max(std::abs(right), 1e-30);
}

void draw_formula_line(App& app, const Words& title, const std::string& formula) {
  small_text(app, title.in(app.language()), app.look.palette.dim);
  ImGui::PushFont(app.look.fonts.small_mono);
  ImGui::PushTextWrapPos(0);
  write(app, formula);
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
}

// The input over three columns: what the naive form makes of it, the robust one, and what is right.
void draw_rows(App& app, const std::vector<Naive::Row>& rows) {
  Look& look = app.look;
  const float room = ImGui::GetContentRegionAvail().x, column = std::floor(room / 3);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const auto line = [&](ImFont* font, const std::array<std::string, 3>& texts, const std::array<ImU32, 3>& inks) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    for (std::size_t i = 0; i < 3; ++i)
      set_text(draw, font, {at.x + float(i) * column, at.y + look.px(15)}, inks[i], noted(app, texts[i]));
    ImGui::Dummy({room, look.px(20) - ImGui::GetStyle().ItemSpacing.y});
  };
  const Language l = app.language();
  const Palette& p = look.palette;
  line(look.fonts.small,
       {std::string(Words{"naive", "素朴"}.in(l)), std::string(Words{"robust", "頑健"}.in(l)),
        std::string(Words{"right", "正解"}.in(l))},
       {p.dim, p.dim, p.dim});
  for (const Naive::Row& row : rows) {
    ImGui::PushFont(look.fonts.small_mono);
    ImGui::PushStyleColor(ImGuiCol_Text, p.dim);
    ImGui::PushTextWrapPos(0);
    write(app, row.input);
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
    line(look.fonts.small_mono,
         {number_text(row.naive, 0, 9), number_text(row.robust, 0, 9), number_text(row.right, 0, 9)},
         {differs(row.naive, row.right) ? p.error : p.text, differs(row.robust, row.right) ? p.error : p.text, p.text});
  }
}

void draw_naive(App& app, ExtremesDesk& desk, const ExtremeCase& subject) {
  const Naive& naive = *subject.naive;
  small_gap(app);
  draw_formula_line(app, {"Naive", "素朴な式"}, naive.naive_formula);
  draw_formula_line(app, {"Robust", "頑健な式"}, naive.robust_formula);
  small_text(app, naive.why.in(app.language()), app.look.palette.text);
  if (const auto rows = desk.rows(subject)) draw_rows(app, *rows);
}

// What a reader was given.
void draw_input(App& app, const std::string& text) {
  Look& look = app.look;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->ChannelsSplit(2);
  draw->ChannelsSetCurrent(1);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  ImGui::Dummy({1, look.px(1)});
  ImGui::Indent(look.px(6));
  ImGui::PushFont(look.fonts.small_mono);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room - look.px(12));
  write(app, text);
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  ImGui::Unindent(look.px(6));
  const float end = ImGui::GetCursorScreenPos().y;
  draw->ChannelsSetCurrent(0);
  draw->AddRectFilled(at, {at.x + room, end}, look.palette.raised, look.px(3));
  draw->ChannelsMerge();
  small_gap(app);
}

void draw_details(App& app, ExtremesDesk& desk, const ExtremeCase& subject) {
  const Language l = app.language();
  ImGui::PushFont(app.look.fonts.small_mono);
  ImGui::PushTextWrapPos(0);
  write(app, subject.parameter + (subject.value.empty() ? "" : " = " + subject.value));
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  if (subject.input) draw_input(app, subject.input->text);
  small_text(app, subject.right.in(l), app.look.palette.text);
  small_gap(app);
  const std::vector<ExtremeResult> results = desk.of(subject);
  if (results.empty()) small_text(app, "…", app.look.palette.dim);
  for (const ExtremeResult& result : results) draw_result(app, subject, result);
  if (subject.driver_fault) {
    const bool shows = std::any_of(results.begin(), results.end(),
                                   [](const ExtremeResult& r) { return r.verdict == Verdict::driver; });
    if (shows) small_text(app, subject.driver_fault->what.in(l), app.look.palette.dim);
  }
  if (subject.naive) draw_naive(app, desk, subject);
  small_gap(app);
}

// A row of the list; true when it was pressed.
bool draw_row(App& app, const ExtremeCase& subject, std::optional<Verdict> verdict, bool chosen) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos(), size{std::max(1.0f, ImGui::GetContentRegionAvail().x), look.px(25)};
  const bool pressed = ImGui::InvisibleButton("row", size);
  if (app.dump) app.dump->place("extreme:" + subject.id, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  if (!ImGui::IsItemVisible()) return pressed;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 high{at.x + size.x, at.y + size.y};
  const std::string_view name = subject.name.in(app.language());
  if (chosen || ImGui::IsItemHovered())
    draw->AddRectFilled({at.x - look.px(6), at.y}, {high.x + look.px(6), high.y}, look.palette.raised, look.px(3));
  draw_verdict_mark(app, {at.x + look.px(7), at.y + 0.5f * size.y}, verdict);
  // The value beside the name, where there is room: it tells cases of one name apart.
  const float from = at.x + look.px(22), baseline = at.y + look.px(17);
  const float free = high.x - from - text_width(look.fonts.small, noted(app, name)) - look.px(10);
  draw->PushClipRect(at, high, true);
  set_text(draw, look.fonts.small, {from, baseline}, look.palette.text, name);
  draw->PopClipRect();
  if (const float w = text_width(look.fonts.small_mono, noted(app, subject.value)); w <= free)
    set_text(draw, look.fonts.small_mono, {high.x - w, baseline}, look.palette.dim, subject.value);
  else if (wants_tooltip(app))
    tooltip(app, {}, name, subject.value);
  return pressed;
}

struct Tally {
  int all = 0, checked = 0, right = 0, failed = 0, driver = 0;
  void count(std::optional<Verdict> v) {
    ++all;
    if (!v) return;
    ++checked;
    right += *v == Verdict::right, failed += is_failure(*v), driver += *v == Verdict::driver;
  }
};

void draw_check(App& app, ExtremesDesk& desk, const Tally& tally) {
  const Language l = app.language();
  if (desk.checking_all()) {
    if (button(app, "stop", {.label = Words{"Stop", "中止"}.in(l)})) desk.stop();
    ImGui::SameLine(0, app.look.px(10));
    progress_bar(app, desk.fraction(), ImGui::GetContentRegionAvail().x);
  } else if (button(app, "check",
                    {.label = Words{"Check all", "すべて検査"}.in(l),
                     .tip = {"Every case with every technique, in the background", "全部の例を全手法で、裏で検査する"},
                     .chosen = tally.checked == 0})) {
    desk.check_all(app);
  }
  if (tally.checked == 0) return;
  const auto n = [](int count) { return std::to_string(count); };
  Text line(n(tally.right) + " right of " + n(tally.checked),
            n(tally.checked) + " 例中 " + n(tally.right) + " 例が正しい");
  if (tally.failed > 0) line = Text(line.en + ", " + n(tally.failed) + " not", line.ja + "・誤り " + n(tally.failed));
  if (tally.driver > 0)
    line =
        Text(line.en + ", " + n(tally.driver) + " the driver's fault", line.ja + "・ドライバの欠陥 " + n(tally.driver));
  small_text(app, line.in(l), tally.failed > 0 ? app.look.palette.error : app.look.palette.dim);
}

void draw_group(App& app, ExtremesDesk& desk, const Name& group, std::span<const ExtremeCase> cases) {
  Tally tally;
  for (const ExtremeCase& c : cases)
    if (c.group == group.id) tally.count(desk.verdict(c));
  if (tally.all == 0) return;
  const std::string count =
      "  " + (tally.checked ? std::to_string(tally.right) + " / " : "") + std::to_string(tally.all);
  const std::string en = std::string(group.label.en) + count, ja = std::string(group.label.ja) + count;
  const std::string id(group.id);
  // What was chosen is seen at the start; else the first group, as a sample.
  const bool has_chosen = std::any_of(cases.begin(), cases.end(), [&](const ExtremeCase& c) {
    return c.group == group.id && c.id == app.settings.extreme;
  });
  const bool first = app.settings.extreme.empty() && group.id == extreme_groups().front().id;
  if (!section(app, id.c_str(), Words{en, ja}, has_chosen || first)) return;
  for (const ExtremeCase& c : cases) {
    if (c.group != group.id) continue;
    ImGui::PushID(c.id.c_str());
    const bool chosen = app.settings.extreme == c.id;
    if (draw_row(app, c, desk.verdict(c), chosen)) {
      app.settings.extreme = chosen && !c.scene ? std::string() : c.id;
      desk.apply(app, c);
      desk.check(app, c);
    }
    if (chosen) {
      ImGui::Indent(app.look.px(8));
      draw_details(app, desk, c);
      ImGui::Unindent(app.look.px(8));
    }
    ImGui::PopID();
  }
}

}  // namespace

void draw_extremes_panel(App& app) {
  ExtremesDesk& desk = extremes_of(app);
  const std::span<const ExtremeCase> cases = extreme_cases();
  Tally tally;
  for (const ExtremeCase& c : cases) tally.count(desk.verdict(c));
  draw_check(app, desk, tally);
  if (tally.checked == 0)
    small_text(app,
               Words{"Click a case: the scene takes its extreme value, and what is right there stands under it.",
                     "例をクリックするとシーンがその極端な値になり、正しい答えが下に出る。"}
                   .in(app.language()),
               app.look.palette.dim);
  small_gap(app);
  for (const Name& group : extreme_groups()) draw_group(app, desk, group, cases);
}

}  // namespace cg
