#include "ui/rich_text.h"

#include <cmath>
#include <vector>

#include "ui/app.h"
#include "ui/line_breaks.h"
#include "workbench/formula_colours.h"

namespace cg {
namespace {

// What is set in one go, and where a line may end.
struct Atom {
  const TextRun* run;
  std::string_view text;
  float width = 0, space = 0;  // pixels; `space` stands before it unless it begins a line
  bool may_break = false;
};

ImFont* font_of(const RichStyle& style, const TextRun& run) {
  switch (run.kind) {
    case TextRun::strong:
      return style.bold;
    case TextRun::code:
      return style.mono;
    default:
      return style.text;
  }
}

float width_of(const RichStyle& style, const TextRun& run, std::string_view text) {
  return run.kind == TextRun::formula ? typeset_width(style.math, text) : text_width(font_of(style, run), text);
}

// A formula may be broken behind its operators: they stay at the end of a line, as in running text.
std::vector<TextPiece> formula_pieces(std::string_view markup) {
  std::vector<TextPiece> out;
  bool space = false;
  bool after_sign = false;
  std::size_t start = 0;
  int depth = 0;
  for (std::size_t i = 0; i <= markup.size(); ++i) {
    const bool end = i == markup.size();
    if (!end && markup[i] == '{') ++depth;
    if (!end && markup[i] == '}') --depth;
    if (!end && (markup[i] != ' ' || depth > 0)) continue;
    if (i > start) {
      const std::string_view text = markup.substr(start, i - start);
      out.push_back({text, space, space && after_sign});
      after_sign = text == "+" || text == "=" || text == "−" || text == "-" || text == "≈" || text == "→";
    }
    space = true;
    start = i + 1;
  }
  return out;
}

// A formula of less than this share of the line is not broken.
constexpr float short_formula = 0.6f;

std::vector<Atom> atoms_of(App& app, std::span<const TextRun> runs, const RichStyle& style, float room) {
  std::vector<Atom> out;
  char32_t before = 0;
  bool space = false;
  for (const TextRun& run : runs) {
    noted(app, run.text);
    const bool formula = run.kind == TextRun::formula;
    const std::vector<TextPiece> pieces = formula ? formula_pieces(run.text) : pieces_of(run.text, before);
    const float blank = width_of(style, formula ? run : TextRun{}, " ");
    const bool whole = formula && typeset_width(style.math, run.text) < short_formula * room;
    bool first = true;
    for (const TextPiece& piece : pieces) {
      Atom atom{&run, piece.text, width_of(style, run, piece.text), piece.space_before ? blank : 0,
                piece.may_break && !whole};
      if (first && space) atom.space = width_of(style, TextRun{}, " "), atom.may_break = true;
      // A formula or code in Japanese text has no space before it, and may begin a line as a letter would.
      if (first && !space && formula) atom.may_break = may_break_between(before, 'x');
      first = false;
      out.push_back(atom);
    }
    if (pieces.empty()) {
      space = space || !run.text.empty();
      continue;
    }
    space = !formula && (run.text.back() == ' ' || run.text.back() == '\n');
    before = space ? 0 : formula ? U'x' : last_character(run.text);
  }
  return out;
}

float draw_formula(App& app, const RichStyle& style, ImVec2 at, std::string_view markup, Quantity& carried) {
  Look& look = app.look;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float start = at.x;
  for (const FormulaPart& part : coloured_parts(markup, carried)) {
    const float w = typeset_width(style.math, part.markup);
    const bool own = part.quantity != Quantity::none;
    if (own) {
      const ImVec2 low{at.x - look.px(1), at.y - style.line * 0.75f},
          high{at.x + w + look.px(1), at.y + style.line * 0.3f};
      if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, high)) app.lit_next = part.quantity;
      if (app.lit == part.quantity) draw->AddRectFilled(low, high, faded(look.of(part.quantity), 0.18f), look.px(3));
    }
    at.x += typeset(draw, style.math, at, own ? look.of(part.quantity) : style.colour, part.markup);
  }
  return at.x - start;
}

// The Japanese face has no bold cut: what is not ASCII is set twice, half a pixel apart.
void set_strong(const App& app, ImFont* font, ImVec2 at, ImU32 colour, std::string_view text) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const auto ascii = [](char c) { return static_cast<signed char>(c) >= 0; };
  while (!text.empty()) {
    const bool plain = ascii(text[0]);
    std::size_t end = 1;
    while (end < text.size() && ascii(text[end]) == plain) ++end;
    const std::string_view part = text.substr(0, end);
    const float width = set_text(draw, font, at, colour, part);
    if (!plain) set_text(draw, font, {at.x + std::max(1.0f, app.look.scale * 0.6f), at.y}, colour, part);
    at.x += width;
    text.remove_prefix(end);
  }
}

void draw_text(App& app, const RichStyle& style, const TextRun& run, ImVec2 at, float width, std::string_view text) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const Look& look = app.look;
  ImFont* font = font_of(style, run);
  if (run.kind == TextRun::code)
    draw->AddRectFilled({at.x - look.px(2), at.y - font->Ascent - look.px(1)},
                        {at.x + width + look.px(2), at.y - font->Descent + look.px(1)}, look.palette.raised,
                        look.px(3));
  if (run.kind == TextRun::strong)
    set_strong(app, font, at, style.colour, text);
  else
    set_text(draw, font, at, style.colour, text);
  if (run.kind == TextRun::emphasis) {
    const float y = std::floor(at.y + look.px(3)), thick = std::max(1.0f, look.px(1));
    draw->AddRectFilled({at.x, y}, {at.x + width, y + thick}, faded(style.colour, 0.6f));
  }
}

// Sets what stands on one line from `begin` on: neighbours of one run in one go.
void draw_line(App& app, const RichStyle& style, std::span<const Atom> line, ImVec2 at, Quantity& carried) {
  for (std::size_t i = 0; i < line.size();) {
    const Atom& first = line[i];
    if (i > 0) at.x += first.space;
    if (first.run->kind == TextRun::formula) {
      at.x += draw_formula(app, style, at, first.text, carried);
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    float width = first.width;
    while (end < line.size() && line[end].run == first.run) width += line[end].space + line[end].width, ++end;
    const Atom& last = line[end - 1];
    const std::string_view text(first.text.data(),
                                std::size_t(last.text.data() + last.text.size() - first.text.data()));
    draw_text(app, style, *first.run, at, width, text);
    carried = Quantity::none;
    at.x += width;
    i = end;
  }
}

}  // namespace

RichStyle body_style(const App& app) {
  const Fonts& f = app.look.fonts;
  return {f.text, f.bold, f.mono, {f.math, f.math_sub}, app.look.px(26), app.look.palette.text};
}

RichStyle formula_style(const App& app) {
  RichStyle style = body_style(app);
  style.math = {app.look.fonts.formula, app.look.fonts.formula_sub};
  style.line = app.look.px(38);
  return style;
}

void set_runs(App& app, std::span<const TextRun> runs, const RichStyle& style, float indent) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = std::max(ImGui::GetContentRegionAvail().x - indent, 1.0f);
  const std::vector<Atom> atoms = atoms_of(app, runs, style, room);
  Quantity carried = Quantity::none;
  float y = at.y, width = 0;
  std::size_t begin = 0, break_at = 0;
  const auto finish = [&](std::size_t end) {
    const ImVec2 baseline{at.x + indent, std::floor(y + style.line * 0.5f + style.text->Ascent * 0.36f)};
    draw_line(app, style, std::span(atoms).subspan(begin, end - begin), baseline, carried);
    y += style.line;
    begin = break_at = end;
    width = 0;
  };
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (i > begin && atoms[i].may_break) break_at = i;
    const float more = (i > begin ? atoms[i].space : 0) + atoms[i].width;
    if (i > begin && width + more > room && break_at > begin) {
      const std::size_t next = break_at;
      finish(next);
      for (std::size_t k = next; k < i; ++k) width += (k > next ? atoms[k].space : 0) + atoms[k].width;
      width += (i > next ? atoms[i].space : 0) + atoms[i].width;
    } else {
      width += more;
    }
  }
  finish(atoms.size());
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({room + indent, y - at.y});
}

}  // namespace cg
