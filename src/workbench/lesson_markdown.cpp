// Markdown to blocks. The grammar is CommonMark's, read by Martin Mitáš's MD4C, which calls back in the order of the
// text: what is open stands on a stack and is put into what holds it when it closes.
#include "workbench/lesson_markdown.h"

#include <md4c.h>

#include <algorithm>
#include <array>
#include <new>

#include "params/input_error.h"

namespace cg {

namespace {

constexpr std::size_t deepest = 8;
constexpr std::string_view line_before_answer = "---";  // stands in the tree until its quotation is closed

// The entities that a text may need; the others are written as UTF-8.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> entities{
    {{"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&nbsp;", "\u00a0"}}};

// Of Japanese: two lines join without a blank between such characters.
bool is_wide(std::string_view three_bytes) {
  if (three_bytes.size() < 3) return false;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(three_bytes[i]); };
  const bool cjk = byte(0) >= 0xe3 && byte(0) <= 0xe9;
  return cjk || (byte(0) == 0xef && byte(1) >= 0xbc);  // fullwidth forms
}

class Builder {
 public:
  Builder(std::string_view markdown, const std::string& where) : markdown_(markdown), where_(where) {
    stack_.emplace_back();
  }

  std::vector<TextBlock> take() { return std::move(stack_.front().inner); }

  void enter(MD_BLOCKTYPE type, void* detail) {
    settle();
    if (type == MD_BLOCK_DOC) return;
    if (type == MD_BLOCK_TABLE)
      refuse_soon({"a table cannot be shown", "表は表示できない"}, {"use a list", "箇条書きにする"});
    TextBlock block;
    if (type == MD_BLOCK_H) {
      block.kind = TextBlock::heading;
      block.level = int(static_cast<MD_BLOCK_H_DETAIL*>(detail)->level);
      if (inside(TextBlock::quotation))
        refuse_soon({"a title in a quotation", "引用の中に見出しがある"},
                    {"leave a line with > alone before ---", "--- の前に > だけの行を入れる"});
    }
    if (type == MD_BLOCK_QUOTE) block.kind = TextBlock::quotation;
    if (type == MD_BLOCK_CODE) block.kind = TextBlock::code;
    if (type == MD_BLOCK_UL || type == MD_BLOCK_OL) {
      lists_.push_back({type == MD_BLOCK_OL, 0});
      if (type == MD_BLOCK_OL) lists_.back().number = int(static_cast<MD_BLOCK_OL_DETAIL*>(detail)->start) - 1;
    }
    if (type == MD_BLOCK_LI) start_item(block, *static_cast<MD_BLOCK_LI_DETAIL*>(detail));
    if (stack_.size() > 4 * deepest || lists_.size() > deepest)
      refuse({"nested more than 8 levels", "入れ子が 8 段を超えている"}, {"write it flatter", "浅くする"});
    stack_.push_back(std::move(block));
  }

  void leave(MD_BLOCKTYPE type) {
    settle();
    refuse_now();
    if (type == MD_BLOCK_DOC) return;
    TextBlock block = std::move(stack_.back());
    stack_.pop_back();
    if (block.line == 0) block.line = line_;  // it has no text: behind the last that was seen
    TextBlock& outer = stack_.back();
    const auto append = [&](std::vector<TextBlock> blocks) {
      for (TextBlock& b : blocks) outer.inner.push_back(std::move(b));
    };
    if (outer.line == 0) outer.line = block.line;
    if (type == MD_BLOCK_UL || type == MD_BLOCK_OL) {
      lists_.pop_back();
      append(std::move(block.inner));
    } else if (type == MD_BLOCK_LI) {
      std::vector<TextBlock> below = std::move(block.inner);
      block.inner.clear();
      outer.inner.push_back(std::move(block));
      append(std::move(below));
    } else if (type == MD_BLOCK_P && is_item(outer) && outer.runs.empty() && outer.inner.empty()) {
      outer.runs = std::move(block.runs);
    } else if (type == MD_BLOCK_HR) {
      block.id = line_before_answer;
      if (inside(TextBlock::quotation)) outer.inner.push_back(std::move(block));
    } else if (type == MD_BLOCK_QUOTE) {
      close_quotation(block);
      outer.inner.push_back(std::move(block));
    } else if (type == MD_BLOCK_CODE) {
      close_code(block);
      outer.inner.push_back(std::move(block));
    } else {
      close_paragraph(block);
      if (!block.runs.empty()) outer.inner.push_back(std::move(block));
    }
  }

  void enter_span(MD_SPANTYPE type) {
    settle();
    if (type == MD_SPAN_IMG)
      refuse_soon({"a picture cannot be shown", "画像は表示できない"},
                  {"show it as the step's scene", "シーンで見せる"});
    spans_.push_back(type);
  }
  void leave_span(MD_SPANTYPE type) {
    settle();
    last_display_ = type == MD_SPAN_LATEXMATH_DISPLAY;
    spans_.pop_back();
  }

  void text(MD_TEXTTYPE type, std::string_view text) {
    if (text.data() >= markdown_.data() && text.data() < markdown_.data() + markdown_.size())
      see_line(std::size_t(text.data() - markdown_.data()));
    refuse_now();
    TextBlock& block = stack_.back();
    if (type == MD_TEXT_HTML)
      refuse({"HTML cannot be shown", "HTML は表示できない"}, {"write &lt; for <", "< は &lt; と書く"});
    if (type == MD_TEXT_BR || type == MD_TEXT_SOFTBR) {
      soft_break_ = !block.runs.empty();
    } else if (block.kind == TextBlock::code) {
      block.id += text;  // the code itself, until it is closed
    } else if (type == MD_TEXT_ENTITY) {
      add(entity(text));
    } else {
      if (type == MD_TEXT_NORMAL && text.find('$') != text.npos)
        refuse({"a $ without a second one", "$ が閉じていない"},
               {"write a formula as $k_d$", "式は $k_d$ のように書く"});
      add(text);
    }
  }

 private:
  struct List {
    bool numbered;
    int number;
  };

  [[noreturn]] void refuse(Text found, Text accepted) const {
    throw InputError(where_, std::move(found), std::move(accepted), line_);
  }
  // What just begins has no line before its first text.
  void refuse_soon(Text found, Text accepted) {
    if (!refusal_) refusal_ = {std::move(found), std::move(accepted)};
  }
  void refuse_now() {
    if (refusal_) refuse(refusal_->first, refusal_->second);
  }

  bool inside(TextBlock::Kind kind) const {
    return std::any_of(stack_.begin(), stack_.end(), [&](const TextBlock& b) { return b.kind == kind; });
  }
  static bool is_item(const TextBlock& b) {
    return b.kind == TextBlock::bullet || b.kind == TextBlock::numbered || b.kind == TextBlock::task;
  }

  void start_item(TextBlock& block, const MD_BLOCK_LI_DETAIL& item) {
    block.kind = lists_.back().numbered ? TextBlock::numbered : TextBlock::bullet;
    block.number = ++lists_.back().number;
    block.level = int(lists_.size()) - 1;
    if (!item.is_task) return;
    block.kind = TextBlock::task;
    block.number = item.task_mark != ' ';  // a choice: whether it is right
  }

  void see_line(std::size_t offset) {
    for (; counted_ < offset; ++counted_) line_ += markdown_[counted_] == '\n';
    for (auto block = stack_.rbegin(); block != stack_.rend() && block->line == 0; ++block) block->line = line_;
  }

  TextRun::Kind kind_of_run() const {
    if (spans_.empty()) return TextRun::plain;
    switch (spans_.back()) {
      case MD_SPAN_EM:
        return TextRun::emphasis;
      case MD_SPAN_STRONG:
        return TextRun::strong;
      case MD_SPAN_CODE:
        return TextRun::code;
      case MD_SPAN_LATEXMATH:
      case MD_SPAN_LATEXMATH_DISPLAY:
        return TextRun::formula;
      default:
        return TextRun::plain;
    }
  }

  void add(std::string_view text) {
    std::vector<TextRun>& runs = stack_.back().runs;
    const TextRun::Kind kind = kind_of_run();
    std::string joint;
    if (soft_break_ && !runs.empty()) {
      const std::string& before = runs.back().text;
      const bool wide =
          before.size() >= 3 && is_wide(std::string_view(before).substr(before.size() - 3)) && is_wide(text);
      joint = wide ? "" : " ";
    }
    soft_break_ = false;
    if (!runs.empty() && runs.back().kind == kind && (kind != TextRun::formula || in_formula_)) {
      runs.back().text += joint;
    } else {
      // A blank is text, never the end or the beginning of a formula.
      const bool behind_formula = !joint.empty() && runs.back().kind == TextRun::formula;
      if (behind_formula && kind == TextRun::formula) runs.push_back({TextRun::plain, joint});
      if (!behind_formula && !runs.empty()) runs.back().text += joint;
      runs.push_back({kind, behind_formula && kind != TextRun::formula ? joint : ""});
    }
    in_formula_ = kind == TextRun::formula;
    runs.back().text += text;
  }
  // What follows is another span: two formulas beside each other stay two.
  void settle() { in_formula_ = false; }

  std::string entity(std::string_view text) const {
    for (const auto& [name, character] : entities)
      if (name == text) return std::string(character);
    refuse({std::string(text) + " is not known", std::string(text) + " は使えない"},
           {"write the character itself in UTF-8", "文字そのものを UTF-8 で書く"});
  }

  void close_paragraph(TextBlock& block) {
    const bool display = last_display_ && block.runs.size() == 1 && block.runs[0].kind == TextRun::formula;
    if (display && block.kind == TextBlock::paragraph) block.kind = TextBlock::formula;
    last_display_ = false;
  }

  static void close_code(TextBlock& block) {
    const std::string text = std::move(block.id);
    block.id.clear();
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      block.lines.push_back(text.substr(at, end - at));
      at = end + 1;
    }
  }

  // What stands before the line is asked, with the choices; what stands behind it is the answer.
  void close_quotation(TextBlock& block) {
    const auto is_line = [](const TextBlock& b) { return b.id == line_before_answer; };
    const auto line = std::find_if(block.inner.begin(), block.inner.end(), is_line);
    const bool question = line != block.inner.end();
    std::vector<TextBlock> asked;
    for (auto b = block.inner.begin(); b != line; ++b) {
      if (b->kind == TextBlock::task && !question)
        refuse({"a question without an answer", "問いに答えがない"},
               {"write > --- and the answer behind the choices", "選択肢の後に > --- と答えを書く"});
      if (b->kind == TextBlock::task)
        block.choices.push_back({std::move(b->runs), b->number != 0});
      else
        asked.push_back(std::move(*b));
    }
    if (!question) {
      block.inner = std::move(asked);
      return;
    }
    block.kind = TextBlock::question;
    block.answer.assign(std::make_move_iterator(line + 1), std::make_move_iterator(block.inner.end()));
    std::erase_if(block.answer, is_line);
    block.inner = std::move(asked);
    const bool right = std::any_of(block.choices.begin(), block.choices.end(), [](const auto& c) { return c.right; });
    if (block.answer.empty() || block.inner.empty() || (!block.choices.empty() && !right))
      refuse({"a question without a question, a right choice or an answer", "問い、正しい選択肢、答えのどれかがない"},
             {"write the question, choices - [ ] and - [x], ---, the answer",
              "問い、選択肢 - [ ] と - [x]、---、答えの順に書く"});
  }

  const std::string_view markdown_;
  const std::string& where_;
  std::vector<TextBlock> stack_;  // the first is the document
  std::vector<List> lists_;
  std::vector<MD_SPANTYPE> spans_;
  bool soft_break_ = false, in_formula_ = false;
  bool last_display_ = false;  // the span that was left last was a formula on a line of its own, $$
  std::optional<std::pair<Text, Text>> refusal_;
  std::size_t counted_ = 0;
  long line_ = 1;  // of the text that was seen last
};

// MD4C is C: an exception waits until it has returned.
struct Reading {
  Builder builder;
  std::exception_ptr problem;

  template <class Do>
  static int guarded(void* reading, Do&& act) {
    auto& self = *static_cast<Reading*>(reading);
    try {
      act(self.builder);
      return 0;
    } catch (...) {
      self.problem = std::current_exception();
      return 1;
    }
  }
};

}  // namespace

std::string take_id(std::vector<TextRun>& runs) {
  if (runs.empty() || runs.back().kind != TextRun::plain) return {};
  std::string& text = runs.back().text;
  const std::size_t open = text.rfind("{#");
  if (open == text.npos || !text.ends_with('}')) return {};
  const std::string id = text.substr(open + 2, text.size() - open - 3);
  text.erase(text.find_last_not_of(' ', open == 0 ? text.npos : open - 1) + 1);
  if (open == 0) text.clear();
  if (text.empty()) runs.pop_back();
  return id;
}

std::vector<TextBlock> markdown_blocks(std::string_view markdown, const std::string& where) {
  Reading reading{Builder(markdown, where), nullptr};
  MD_PARSER parser{};
  parser.flags = MD_FLAG_LATEXMATHSPANS | MD_FLAG_TASKLISTS | MD_FLAG_TABLES;
  parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* r) {
    return Reading::guarded(r, [&](Builder& b) { b.enter(type, detail); });
  };
  parser.leave_block = [](MD_BLOCKTYPE type, void*, void* r) {
    return Reading::guarded(r, [&](Builder& b) { b.leave(type); });
  };
  parser.enter_span = [](MD_SPANTYPE type, void*, void* r) {
    return Reading::guarded(r, [&](Builder& b) { b.enter_span(type); });
  };
  parser.leave_span = [](MD_SPANTYPE type, void*, void* r) {
    return Reading::guarded(r, [&](Builder& b) { b.leave_span(type); });
  };
  parser.text = [](MD_TEXTTYPE type, const MD_CHAR* text, MD_SIZE size, void* r) {
    return Reading::guarded(r, [&](Builder& b) { b.text(type, {text, size}); });
  };
  const int status = md_parse(markdown.data(), MD_SIZE(markdown.size()), &parser, &reading);
  if (reading.problem) std::rethrow_exception(reading.problem);
  if (status != 0) throw std::bad_alloc();
  return reading.builder.take();
}

}  // namespace cg
