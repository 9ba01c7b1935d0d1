#include "ui/lesson_blocks.h"

#include <algorithm>
#include <cmath>

#include "ui/app.h"
#include "ui/lesson_player.h"
#include "ui/lines.h"
#include "ui/number.h"
#include "ui/rich_text.h"
#include "ui/widgets.h"

namespace cg {
namespace {

void space(const App& app, float units) { ImGui::Dummy({1, app.look.px(units)}); }

// The baseline of the first line of what is set at `top`.
float first_baseline(const RichStyle& style, float top) {
  return std::floor(top + style.line * 0.5f + style.text->Ascent * 0.36f);
}

void draw_heading(App& app, const TextBlock& block, float indent) {
  std::vector<TextRun> runs = block.runs;
  for (TextRun& run : runs)
    if (run.kind == TextRun::plain) run.kind = TextRun::strong;
  set_runs(app, runs, body_style(app), indent);
}

void draw_item(App& app, const TextBlock& block, float indent) {
  const RichStyle style = body_style(app);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float in = indent + app.look.px(20 + 18 * float(block.level));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (block.kind == TextBlock::numbered) {
    const std::string number = std::to_string(block.number) + ".";
    set_text(draw, style.text,
             {at.x + in - app.look.px(6) - text_width(style.text, number), first_baseline(style, at.y)},
             app.look.palette.dim, number);
  } else {
    draw->AddCircleFilled({at.x + in - app.look.px(11), at.y + style.line * 0.5f}, app.look.px(2.5f),
                          app.look.palette.dim);
  }
  set_runs(app, block.runs, style, in);
}

// A listing. Lines that begin with + or − are what was changed: what went is dim, what came has a bar beside it.
void draw_code(App& app, const TextBlock& block, float indent) {
  Look& look = app.look;
  RichStyle style = body_style(app);
  style.text = style.bold = look.fonts.small_mono;
  style.line = look.px(20);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  draw->ChannelsSplit(2);
  draw->ChannelsSetCurrent(1);
  space(app, 4);
  const float blank = text_width(style.text, " ");
  for (const std::string& line : block.lines) {
    const std::size_t first = std::min(line.find_first_not_of(' '), line.size());
    const bool added = line.starts_with("+ "), removed = line.starts_with("- ");
    style.colour = removed ? look.palette.dim : look.palette.text;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const TextRun run{TextRun::plain, line.substr(first)};
    set_runs(app, std::span(&run, 1), style, indent + look.px(10) + float(first) * blank);
    if (added)
      draw->AddRectFilled({at.x + indent, at.y}, {at.x + indent + look.px(3), ImGui::GetCursorScreenPos().y},
                          look.palette.accent);
  }
  space(app, 4);
  const ImVec2 end = ImGui::GetCursorScreenPos();
  draw->ChannelsSetCurrent(0);
  draw->AddRectFilled({start.x + indent, start.y}, {start.x + room, end.y}, look.palette.raised, look.px(4));
  draw->ChannelsMerge();
}

void draw_formula(App& app, const TextBlock& block, float indent) {
  if (block.runs.empty()) return;
  RichStyle style = formula_style(app);
  const float room = ImGui::GetContentRegionAvail().x - indent;
  if (typeset_width(style.math, block.runs[0].text) > room) {  // then in the size of running text, in lines
    style = body_style(app);
    style.line = app.look.px(32);
  }
  set_runs(app, block.runs, style, indent);
}

// A round mark: empty, or with a tick where the task is done.
void draw_tick(App& app, ImVec2 c, bool done) {
  const Look& look = app.look;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float r = look.px(8.5f), thick = std::max(1.0f, look.px(3) * 0.6f);
  if (!done) {
    draw->AddCircle(c, r, look.palette.dim, 0, thick);
    return;
  }
  const ImU32 green = look.of(Quantity::reflection);
  draw->AddCircleFilled(c, r, green);
  const ImVec2 tick[3] = {{c.x - r * 0.45f, c.y}, {c.x - r * 0.1f, c.y + r * 0.4f}, {c.x + r * 0.5f, c.y - r * 0.4f}};
  draw->AddPolyline(tick, 3, IM_COL32(255, 255, 255, 255), 0, thick * 1.2f);
}

// "now 21.4 deg, goal 10.7 ± 0.2"
Text state_text(const LessonPlayer& player, const std::string& id, const TaskState& state) {
  if (state.problem) return *state.problem;
  if (!state.result) return {"…", "…"};
  std::string unit;
  for (const LessonTask& task : player.current()->tasks)
    if (task.id == id && task.measuring.what && task.measuring.what->unit != "1")
      unit = task.measuring.what->unit == "deg" ? "°" : " " + std::string(task.measuring.what->unit);
  const auto text = [&](double v) { return number_text(v, 0, 6) + unit; };
  const TaskResult& r = *state.result;
  const std::string now = text(r.value), goal = text(r.goal) + " ± " + text(r.tolerance);
  return {"now " + now + ",  goal " + goal, "いま " + now + "　目標 " + goal};
}

void draw_task(App& app, LessonPlayer& player, const TextBlock& block, float indent) {
  const RichStyle style = body_style(app);
  const TaskState& state = player.task(block.id);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float in = indent + app.look.px(28);
  draw_tick(app, {at.x + indent + app.look.px(10), at.y + style.line * 0.5f}, state.done);
  set_runs(app, block.runs, style, in);
  RichStyle small = style;
  small.text = small.bold = app.look.fonts.small;
  small.line = app.look.px(22);
  small.colour = state.problem                        ? app.look.palette.error
                 : state.result && state.result->done ? app.look.palette.text
                                                      : app.look.palette.dim;
  const TextRun run{TextRun::plain, state_text(player, block.id, state).in(app.language())};
  set_runs(app, std::span(&run, 1), small, in);
}

// One of the answers: a letter, and after the reveal whether it is right, by a mark and not by colour alone.
void draw_choice(App& app, const TextChoice& choice, int index, Answer& answer, float indent) {
  Look& look = app.look;
  const RichStyle style = body_style(app);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, in = indent + look.px(34);
  draw->ChannelsSplit(2);
  draw->ChannelsSetCurrent(1);
  set_runs(app, choice.runs, style, in);
  const ImVec2 end = ImGui::GetCursorScreenPos();
  ImGui::PushID(index);
  ImGui::SetCursorScreenPos({at.x + indent, at.y});
  const bool pressed = ImGui::InvisibleButton("choice", {std::max(1.0f, room - indent), end.y - at.y - look.px(2)});
  const bool hovered = ImGui::IsItemHovered() && !answer.revealed;
  ImGui::PopID();
  if (pressed && !answer.revealed) answer.chosen = index;
  const bool chosen = answer.chosen == index, shown = answer.revealed;
  draw->ChannelsSetCurrent(0);
  if (chosen || hovered)
    draw->AddRectFilled({at.x + indent, at.y}, {at.x + room, end.y - look.px(2)},
                        chosen ? look.palette.raised_hover : look.palette.raised, look.px(4));
  draw->ChannelsMerge();
  const char letter[2] = {char('A' + index), 0};
  const std::string mark = !shown ? std::string(letter) : choice.right ? "✓" : chosen ? "✗" : std::string(letter);
  const ImU32 colour = !shown || !(choice.right || chosen) ? look.palette.dim
                       : choice.right                      ? look.of(Quantity::reflection)
                                                           : look.palette.error;
  set_text(draw, look.fonts.bold, {at.x + indent + look.px(10), first_baseline(style, at.y)}, colour, noted(app, mark));
  ImGui::SetCursorScreenPos(end);
}

void draw_question(App& app, LessonPlayer& player, const TextBlock& block, std::size_t& questions, float indent) {
  Look& look = app.look;
  Answer& answer = player.answer(questions++);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float in = indent + look.px(14);
  ImGui::PushID(int(questions));
  draw_blocks(app, player, block.inner, questions, in);
  for (std::size_t i = 0; i < block.choices.size(); ++i) draw_choice(app, block.choices[i], int(i), answer, in);
  if (answer.revealed) {
    space(app, 2);
    draw_blocks(app, player, block.answer, questions, in);
  } else {
    const bool ready = block.choices.empty() || answer.chosen >= 0;
    const Words label = ready ? Words{"Why?", "理由を見る"} : Words{"Choose first", "まず選ぶ"};
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({at.x + in, at.y + look.px(4)});
    if (button(app, "reveal", {.label = label.in(app.language()), .enabled = ready})) answer.revealed = true;
    space(app, 2);
  }
  ImGui::PopID();
  ImGui::GetWindowDrawList()->AddRectFilled({start.x + indent, start.y + look.px(3)},
                                            {start.x + indent + look.px(3), ImGui::GetCursorScreenPos().y - look.px(3)},
                                            look.palette.line);
}

void draw_block(App& app, LessonPlayer& player, const TextBlock& block, std::size_t& questions, float indent) {
  switch (block.kind) {
    case TextBlock::heading:
      space(app, 6);
      return draw_heading(app, block, indent);
    case TextBlock::paragraph:
      return set_runs(app, block.runs, body_style(app), indent);
    case TextBlock::bullet:
    case TextBlock::numbered:
      return draw_item(app, block, indent);
    case TextBlock::code:
      return draw_code(app, block, indent);
    case TextBlock::formula:
      return draw_formula(app, block, indent);
    case TextBlock::quotation: {
      const ImVec2 start = ImGui::GetCursorScreenPos();
      draw_blocks(app, player, block.inner, questions, indent + app.look.px(14));
      ImGui::GetWindowDrawList()->AddRectFilled(
          {start.x + indent, start.y},
          {start.x + indent + app.look.px(2), ImGui::GetCursorScreenPos().y - app.look.px(8)}, app.look.palette.line);
      return;
    }
    case TextBlock::task:
      return draw_task(app, player, block, indent);
    case TextBlock::question:
      return draw_question(app, player, block, questions, indent);
  }
}

bool is_item(const TextBlock& block) { return block.kind == TextBlock::bullet || block.kind == TextBlock::numbered; }

}  // namespace

void draw_blocks(App& app, LessonPlayer& player, const std::vector<TextBlock>& blocks, std::size_t& questions,
                 float indent) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {app.look.px(8), 0});
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    draw_block(app, player, blocks[i], questions, indent);
    const bool close = i + 1 < blocks.size() && is_item(blocks[i]) && is_item(blocks[i + 1]);
    space(app, close ? 2 : 9);
  }
  ImGui::PopStyleVar();
}

}  // namespace cg
