// A lesson's Markdown as sections, one a step, checked so that the window can draw what it is given.
#include "workbench/lesson_text.h"

#include <algorithm>

#include "params/input_error.h"
#include "workbench/lesson_markdown.h"

namespace cg {

namespace {

constexpr std::size_t largest_text = std::size_t(1) << 20;
constexpr std::size_t longest_name = 40, longest_path = 100;  // bytes
constexpr std::string_view name_letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.";
constexpr std::string_view id_letters = "abcdefghijklmnopqrstuvwxyz0123456789-_";

// How many bytes the UTF-8 character at the start of `s` has; 0: it is none (RFC 3629).
std::size_t character_length(std::string_view s) {
  const auto byte = [&](std::size_t i) { return i < s.size() ? static_cast<unsigned char>(s[i]) : 0u; };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xc0) == 0x80; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return follows(1) ? 2 : 0;
  if (first >= 0xe0 && first < 0xf0) {
    const bool shortest = (first != 0xe0 || second >= 0xa0) && (first != 0xed || second < 0xa0);
    return shortest && follows(1) && follows(2) ? 3 : 0;
  }
  if (first >= 0xf0 && first < 0xf5) {
    const bool shortest = (first != 0xf0 || second >= 0x90) && (first != 0xf4 || second < 0x90);
    return shortest && follows(1) && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

void check_characters(std::string_view text, const std::string& where) {
  if (text.size() > largest_text)
    throw InputError(where, {"the text is too long", "テキストが長すぎる"}, {"1 MiB is read", "1 MiB まで読める"});
  long line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text.substr(at));
    if (length == 0 || text[at] == '\0')
      throw InputError(where, {"this is not UTF-8", "UTF-8 でない"}, {"save it as UTF-8", "UTF-8 で保存する"}, line);
    line += text[at] == '\n';
    at += length;
  }
}

// Calls for each {{name}} of a text, and for what stands between; `unclosed` where one does not end.
template <class Plain, class Name, class Unclosed>
void walk_numbers(std::string_view text, Plain&& plain, Name&& name, Unclosed&& unclosed) {
  while (!text.empty()) {
    const std::size_t open = text.find("{{");
    plain(text.substr(0, open));
    if (open == text.npos) return;
    text.remove_prefix(open + 2);
    const std::size_t close = text.find("}}");
    const std::string_view inner = text.substr(0, close);
    if (close == text.npos || inner.empty() || inner.size() > longest_path ||
        inner.find_first_not_of(name_letters) != inner.npos)
      return unclosed(inner);
    name(inner);
    text.remove_prefix(close + 2);
  }
}

template <class Each>
void each_run(std::vector<TextBlock>& blocks, Each&& each) {
  for (TextBlock& block : blocks) {
    for (TextRun& run : block.runs) each(run, block.line);
    for (TextChoice& choice : block.choices)
      for (TextRun& run : choice.runs) each(run, block.line);
    each_run(block.inner, each);
    each_run(block.answer, each);
  }
}

// The beginning of a text, whole characters of it.
std::string excerpt(std::string_view text) {
  std::size_t end = std::min<std::size_t>(text.size(), 20);
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return std::string(text.substr(0, end));
}

void check_runs(std::vector<TextBlock>& blocks, const std::string& where) {
  each_run(blocks, [&](const TextRun& run, long line) {
    walk_numbers(
        run.text, [](std::string_view) {}, [](std::string_view) {},
        [&](std::string_view inner) {
          throw InputError(
              where, {"{{" + excerpt(inner) + " is no number's name", "{{" + excerpt(inner) + " は数の名前でない"},
              {"write {{name}}", "{{name}} のように書く"}, line);
        });
    if (run.kind == TextRun::formula &&
        std::count(run.text.begin(), run.text.end(), '{') != std::count(run.text.begin(), run.text.end(), '}'))
      throw InputError(where, {"a brace of the formula does not close", "式の波括弧が閉じていない"},
                       {"write e^{-x}", "e^{-x} のように書く"}, line);
  });
}

bool is_id(const std::string& id) {
  return !id.empty() && id.size() <= longest_name && id.find_first_not_of(id_letters) == id.npos;
}

// Tasks carry their id at the end of their text.
void name_tasks(std::vector<TextBlock>& blocks, const std::string& where) {
  for (TextBlock& block : blocks) {
    if (block.kind != TextBlock::task) continue;
    block.id = take_id(block.runs);
    block.number = 0;
    if (!is_id(block.id))
      throw InputError(where, {"the task has no name", "課題に名前がない"},
                       {"end it in {#name}, in small letters and not too long", "終わりに短い小文字で {#name} と書く"},
                       block.line);
  }
}

std::string plain_text(const std::vector<TextRun>& runs) {
  std::string out;
  for (const TextRun& run : runs) out += run.text;
  return out;
}

TextSection start_section(TextBlock& heading, const LessonText& text, const std::string& where) {
  TextSection section;
  section.line = heading.line;
  section.id = take_id(heading.runs);
  section.title = plain_text(heading.runs);
  const bool first = text.sections.empty();
  if (first != (heading.level == 1))
    throw InputError(
        where,
        first ? Text{"the lesson has no title", "レッスンに題がない"}
              : Text{"a second title of the lesson", "レッスンの題が二つある"},
        {"begin with # Title; each step has ## Title {#id}", "先頭に「# 題」、各ステップに「## 題 {#id}」と書く"},
        heading.line);
  if (first) return section;
  if (!is_id(section.id))
    throw InputError(
        where, {"the step has no id", "ステップに id がない"},
        {"write ## Title {#id}, in small letters and not too long", "「## 題 {#id}」のように短い小文字で書く"},
        heading.line);
  for (const TextSection& other : text.sections)
    if (other.id == section.id)
      throw InputError(where, {"the id " + section.id + " is used twice", "id「" + section.id + "」が二度使われている"},
                       {"give each step its own", "ステップごとに別の id にする"}, heading.line);
  return section;
}

}  // namespace

LessonText parse_lesson_text(std::string_view markdown, const std::string& where) {
  check_characters(markdown, where);
  if (markdown.starts_with("\xef\xbb\xbf")) markdown.remove_prefix(3);
  LessonText text;
  for (TextBlock& block : markdown_blocks(markdown, where)) {
    if (block.kind == TextBlock::heading && block.level <= 2)
      text.sections.push_back(start_section(block, text, where));
    else if (text.sections.empty())
      throw InputError(where, {"the lesson has no title", "レッスンに題がない"},
                       {"begin with # Title", "先頭に「# 題」と書く"}, block.line);
    else
      text.sections.back().blocks.push_back(std::move(block));
  }
  if (text.sections.empty())
    throw InputError(where, {"the text is empty", "テキストが空"}, {"begin with # Title", "先頭に「# 題」と書く"}, 1);
  for (TextSection& section : text.sections) {
    name_tasks(section.blocks, where);
    check_runs(section.blocks, where);
  }
  return text;
}

std::string filled(std::string_view text, const TextOfNumber& number) {
  std::string out;
  walk_numbers(
      text, [&](std::string_view plain) { out += plain; },
      [&](std::string_view name) { out += number(name).value_or("…"); },
      [&](std::string_view inner) { out += "{{" + std::string(inner); });
  return out;
}

std::vector<TextBlock> filled(std::vector<TextBlock> blocks, const TextOfNumber& number) {
  each_run(blocks, [&](TextRun& run, long) { run.text = filled(run.text, number); });
  return blocks;
}

std::vector<std::string> numbers_in(const std::vector<TextBlock>& blocks) {
  std::vector<TextBlock> all = blocks;
  std::vector<std::string> names;
  each_run(all, [&](const TextRun& run, long) {
    walk_numbers(
        run.text, [](std::string_view) {},
        [&](std::string_view name) {
          if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
        },
        [](std::string_view) {});
  });
  return names;
}

}  // namespace cg
