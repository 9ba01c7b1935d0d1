// Every text a user sees, in both languages side by side, so that one cannot be written without the other.
#pragma once
#include <string>
#include <string_view>

namespace cg {

enum class Language { english, japanese };

// A fixed text, known when the program is built. UTF-8.
struct Words {
  std::string_view en, ja;
  constexpr std::string_view in(Language l) const { return l == Language::japanese ? ja : en; }
};

// A text made while the program runs (it names a file, a number). UTF-8.
struct Text {
  std::string en, ja;
  Text() = default;
  Text(std::string e, std::string j) : en(std::move(e)), ja(std::move(j)) {}
  Text(Words w) : en(w.en), ja(w.ja) {}
  const std::string& in(Language l) const { return l == Language::japanese ? ja : en; }
  friend bool operator==(const Text&, const Text&) = default;
};

}  // namespace cg
