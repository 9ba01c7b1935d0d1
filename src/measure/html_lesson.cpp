#include "measure/html_lesson.h"

#include <array>

#include "workbench/formula_colours.h"

namespace cg {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<signed char>(c) < 0; }

// What follows a "_" or "^" at the start of `s`: the group in braces, or one letter. Removes it from `s`.
std::string_view take_group(std::string_view& s) {
  s.remove_prefix(1);
  if (s.starts_with('{')) {
    const std::size_t close = std::min(s.find('}'), s.size());
    const std::string_view group = s.substr(1, close - 1);
    s.remove_prefix(std::min(close + 1, s.size()));
    return group;
  }
  std::size_t n = s.empty() ? 0 : 1;
  while (n < s.size() && (static_cast<unsigned char>(s[n]) & 0xc0) == 0x80) ++n;
  const std::string_view group = s.substr(0, n);
  s.remove_prefix(n);
  return group;
}

// The letters at the start of `s`. Signs beyond ASCII (·, √, ≈) are none of them, Greek is.
std::size_t letters(std::string_view s) {
  std::size_t n = 0;
  while (n < s.size() && is_letter(s[n])) {
    const bool ascii = static_cast<signed char>(s[n]) >= 0;
    const unsigned char lead = static_cast<unsigned char>(s[n]);
    if (!ascii && lead != 0xce && lead != 0xcf) break;  // U+0380..U+03FF
    n += ascii ? 1 : 2;
  }
  return std::min(n, s.size());
}

Html set(std::string_view s) {
  Html out;
  while (!s.empty()) {
    if (s[0] == '_' || s[0] == '^') {
      const std::string_view tag = s[0] == '_' ? "sub" : "sup";
      out += element(tag, set(take_group(s)));
    } else if (const std::size_t n = letters(s)) {
      const bool function = n >= 3 && static_cast<signed char>(s[0]) > 0;  // cos, max
      out += function ? text(s.substr(0, n)) : element("i", text(s.substr(0, n)));
      s.remove_prefix(n);
    } else {
      std::size_t end = 1;
      while (end < s.size() && s[end] != '_' && s[end] != '^' && letters(s.substr(end)) == 0) ++end;
      out += text(s.substr(0, end));
      s.remove_prefix(end);
    }
  }
  return out;
}

Html run_html(const TextRun& run) {
  switch (run.kind) {
    case TextRun::plain:
      return text(run.text);
    case TextRun::emphasis:
      return element("em", text(run.text));
    case TextRun::strong:
      return element("strong", text(run.text));
    case TextRun::code:
      return element("code", text(run.text));
    case TextRun::formula:
      return formula_html(run.text);
  }
  return {};
}

Html question_html(const TextBlock& block, Language language) {
  Html choices;
  for (const TextChoice& choice : block.choices)
    choices += element("li", {{"class", choice.right ? "right" : "choice"}},
                       text(choice.right ? "☒ " : "☐ ") + runs_html(choice.runs));
  Html out = blocks_html(block.inner, language);
  if (!choices.empty()) out += element("ul", {{"class", "choices"}}, choices);
  out += element("div", {{"class", "answer"}}, blocks_html(block.answer, language));
  return element("blockquote", {{"class", "question"}}, out);
}

Html task_html(const TextBlock& block, Language language) {
  const std::string_view label = Words{"Task", "課題"}.in(language);
  return element("p", {{"class", "task"}}, element("b", text(label)) + text(" ") + runs_html(block.runs));
}

Html listing_html(const TextBlock& block) {
  std::string lines;
  for (const std::string& line : block.lines) lines += line + "\n";
  return element("pre", element("code", text(lines)));
}

Html item_html(const TextBlock& block) {
  const std::string mark = block.kind == TextBlock::numbered ? std::to_string(block.number) + "." : "•";
  const std::string level = "item level-" + std::to_string(std::min(block.level, 3));
  return element("p", {{"class", level}}, element("span", {{"class", "mark"}}, text(mark)) + runs_html(block.runs));
}

Html block_html(const TextBlock& block, Language language) {
  switch (block.kind) {
    case TextBlock::heading:
      return element("h4", runs_html(block.runs));
    case TextBlock::paragraph:
      return element("p", runs_html(block.runs));
    case TextBlock::bullet:
    case TextBlock::numbered:
      return item_html(block);
    case TextBlock::code:
      return listing_html(block);
    case TextBlock::formula:
      return element("p", {{"class", "display"}}, runs_html(block.runs));
    case TextBlock::quotation:
      return element("blockquote", blocks_html(block.inner, language));
    case TextBlock::task:
      return task_html(block, language);
    case TextBlock::question:
      return question_html(block, language);
  }
  return {};
}

}  // namespace

std::string_view class_of(Quantity quantity) {
  constexpr std::array<std::string_view, 7> classes{
      "", "q-ambient", "q-diffuse", "q-specular", "q-reflection", "q-transmission", "q-emission"};
  return classes[std::size_t(quantity)];
}

Html formula_html(std::string_view markup) {
  Html out;
  Quantity carried = Quantity::none;
  for (const FormulaPart& part : coloured_parts(markup, carried)) {
    const std::string_view name = class_of(part.quantity);
    out += name.empty() ? set(part.markup) : element("span", {{"class", name}}, set(part.markup));
  }
  return element("span", {{"class", "formula"}}, out);
}

Html runs_html(std::span<const TextRun> runs) {
  Html out;
  for (const TextRun& run : runs) out += run_html(run);
  return out;
}

Html blocks_html(std::span<const TextBlock> blocks, Language language) {
  Html out;
  for (const TextBlock& block : blocks) out += block_html(block, language);
  return out;
}

}  // namespace cg
