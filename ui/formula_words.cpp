#include "ui/formula_words.h"

#include <algorithm>
#include <cctype>

namespace cg {
namespace {

bool letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool word_letter(char c) { return letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The bytes of a word of formulas: no blanks, no Japanese, which begins at U+2E80 and has no blanks between words.
std::size_t word_length(std::string_view text) {
  std::size_t n = 0;
  while (n < text.size() && text[n] != ' ' && static_cast<unsigned char>(text[n]) < 0xe3) {
    ++n;
    while (n < text.size() && (static_cast<unsigned char>(text[n]) & 0xc0) == 0x80) ++n;
  }
  return n;
}

bool has_index_or_exponent(std::string_view word) {
  if (word.find('^') != word.npos) return true;
  for (std::size_t i = 1; i + 1 < word.size(); ++i) {
    const bool letter_before = letter(word[i - 1]) && (i < 2 || !word_letter(word[i - 2]));
    const bool letter_behind = word_letter(word[i + 1]) && (i + 2 >= word.size() || !word_letter(word[i + 2]));
    if (word[i] == '_' && letter_before && letter_behind) return true;
  }
  return false;
}

// A sign, or a letter that is no word of the sentence.
bool may_join(std::string_view word) {
  static constexpr std::string_view signs[] = {"+",  "−",   "-", "=",     "·",     "/",    "r",
                                               "r²", "r²)", "n", "(N·L)", "(N·H)", "(R·V)"};
  return std::find(std::begin(signs), std::end(signs), word) != std::end(signs);
}

struct Word {
  std::size_t begin, end;
  bool formula;
};

// The words between blanks and Japanese, less the punctuation of the sentence at their end.
std::vector<Word> words_of(std::string_view text) {
  std::vector<Word> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t n = word_length(text.substr(at));
    if (n == 0) {
      ++at;
      continue;
    }
    std::size_t end = at + n;
    while (end > at && std::string_view(".,:;").find(text[end - 1]) != std::string_view::npos) --end;
    words.push_back({at, end, has_index_or_exponent(text.substr(at, end - at))});
    at += n;
  }
  return words;
}

}  // namespace

std::vector<TextRun> formula_runs(std::string_view text) {
  std::vector<Word> words = words_of(text);
  const auto next_to = [&](std::size_t a, std::size_t b) {  // with one blank between
    return words[a].end + 1 == words[b].begin && text[words[a].end] == ' ';
  };
  const auto joins = [&](std::size_t i) {
    return may_join(text.substr(words[i].begin, words[i].end - words[i].begin));
  };
  for (std::size_t i = 1; i < words.size(); ++i)
    if (words[i - 1].formula && next_to(i - 1, i) && joins(i)) words[i].formula = true;
  for (std::size_t i = words.size(); i-- > 1;)
    if (words[i].formula && next_to(i - 1, i) && joins(i - 1)) words[i - 1].formula = true;
  std::vector<TextRun> runs;
  std::size_t at = 0;
  const auto add = [&](TextRun::Kind kind, std::size_t end) {
    if (end > at) runs.push_back({kind, std::string(text.substr(at, end - at))});
    at = end;
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].formula) continue;
    add(TextRun::plain, words[i].begin);
    while (i + 1 < words.size() && words[i + 1].formula && next_to(i, i + 1)) ++i;
    add(TextRun::formula, words[i].end);
  }
  add(TextRun::plain, text.size());
  return runs;
}

}  // namespace cg
