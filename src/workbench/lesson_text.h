// The text of a lesson as plain blocks that a window can draw, read from Markdown (CommonMark, by MD4C):
//
//   # The lesson's title
//   What the lesson is about.
//   ## A step's title {#its-id}
//   A paragraph with *emphasis*, **strong**, `code` and a formula $k_d (N·L)$; {{ratio}} is a number of the step.
//   $$I = I_a k_a + Σ I_i [k_d (N·L) + k_s (R·V)^n]$$
//   - [ ] Make the highlight half as wide. {#half}          a task, outside a quotation
//   > What happens to the highlight when n doubles?          a question: what comes before the line ---
//   > - [ ] It gets brighter.
//   > - [x] It gets narrower.
//   > ---
//   > Because ...                                            is asked, what comes behind it is the answer
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cg {

// A piece of a line. A formula is in the markup of ui/formula.h's typeset(). {{name}} in a text stands for a number:
// filled() puts it in.
struct TextRun {
  enum Kind { plain, emphasis, strong, code, formula } kind = plain;
  std::string text;  // UTF-8, no line break
  friend bool operator==(const TextRun&, const TextRun&) = default;
};

// One of the answers that a question offers.
struct TextChoice {
  std::vector<TextRun> runs;
  bool right = false;
  friend bool operator==(const TextChoice&, const TextChoice&) = default;
};

struct TextBlock {
  enum Kind {
    heading,    // runs; level 3 or more, the others are the lesson's and the steps' titles
    paragraph,  // runs
    bullet,     // runs; one item of a list, `level` 0 is the outermost
    numbered,   // the same, `number` before it
    code,       // `lines`, as a listing
    formula,    // runs[0] is a formula on a line of its own
    quotation,  // `inner`
    task,       // runs, and `id` names the step's task
    question    // `inner` is asked, with `choices` (maybe none); `answer` is shown when the reader asks for it
  } kind = paragraph;
  std::vector<TextRun> runs;
  int level = 0, number = 0;
  std::string id;
  std::vector<std::string> lines;
  std::vector<TextBlock> inner, answer;
  std::vector<TextChoice> choices;
  long line = 0;  // where it begins in its file, 1-based; 0 where that is not known
  friend bool operator==(const TextBlock&, const TextBlock&) = default;
};

struct TextSection {
  std::string id, title;
  std::vector<TextBlock> blocks;
  long line = 0;  // of the heading
  friend bool operator==(const TextSection&, const TextSection&) = default;
};

// sections[0] is the lesson's own: its title, no id, what stands before the first step.
struct LessonText {
  std::vector<TextSection> sections;
  friend bool operator==(const LessonText&, const LessonText&) = default;
};

// Reads the Markdown of a lesson. Throws InputError with `where` and the line: not UTF-8, no title, a step without an
// id or with one that is used twice, a table or HTML (which the window does not draw), a question without an answer,
// a formula or {{ }} that does not end, more than 1 MiB, lists or quotations nested more than 8 levels.
LessonText parse_lesson_text(std::string_view markdown, const std::string& where);

// What stands for {{name}}; nothing: not known yet, "…" is put in.
using TextOfNumber = std::function<std::optional<std::string>(std::string_view name)>;

std::string filled(std::string_view text, const TextOfNumber& number);
std::vector<TextBlock> filled(std::vector<TextBlock> blocks, const TextOfNumber& number);

// The names between {{ and }}, in order, each once, in all that the blocks hold.
std::vector<std::string> numbers_in(const std::vector<TextBlock>& blocks);

}  // namespace cg
