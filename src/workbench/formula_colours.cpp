#include "workbench/formula_colours.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "scene/light.h"
#include "scene/material.h"

namespace cg {
namespace {

struct Symbol {
  std::string_view markup;
  Quantity quantity;
};

template <class T>
void add_symbols(std::vector<Symbol>& out) {
  std::apply(
      [&](const auto&... f) {
        const auto add = [&](const About& about) {
          if (about.quantity != Quantity::none && !about.symbol.empty()) out.push_back({about.symbol, about.quantity});
        };
        (add(f.about), ...);
      },
      fields_of<T>);
}

const std::vector<Symbol>& symbols() {
  static const std::vector<Symbol> all = [] {
    std::vector<Symbol> out;
    add_symbols<Material>(out);
    add_symbols<Light>(out);
    return out;
  }();
  return all;
}

bool is_letter(unsigned char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c >= 0x80; }

// The bytes of the symbol at the start of `s`: a letter with its index ("k_d", "I_{a}").
std::size_t symbol_size(std::string_view s) {
  std::size_t n = 1;
  while (n < s.size() && (static_cast<unsigned char>(s[n]) & 0xc0) == 0x80) ++n;
  if (n + 1 >= s.size() || s[n] != '_') return n;
  if (s[n + 1] == '{') return std::min(s.find('}', n), s.size() - 1) + 1;
  return n + 2;
}

// A function's name, as "cos": letters that are no quantities.
std::size_t word_size(std::string_view s) {
  const std::size_t n = std::min(s.find_first_not_of("abcdefghijklmnopqrstuvwxyz"), s.size());
  return n >= 3 ? n : 0;
}

// "_" or "^" and what it sets lower or higher.
std::size_t shifted_size(std::string_view s) {
  if (s.size() < 2) return s.size();
  if (s[1] == '{') return std::min(s.find('}'), s.size() - 1) + 1;
  return 1 + symbol_size(s.substr(1, s.find_first_of("_^", 2) - 1));
}

bool ends_term(std::string_view s) {
  constexpr std::array<std::string_view, 9> signs{"+", "-", "=", "[", "]", "−", "≈", "Σ", ","};
  return std::any_of(signs.begin(), signs.end(), [&](std::string_view sign) { return s.starts_with(sign); });
}

const Symbol* find_symbol(std::string_view markup) {
  for (const Symbol& s : symbols())
    if (s.markup == markup) return &s;
  return nullptr;
}

}  // namespace

std::vector<FormulaPart> coloured_parts(std::string_view markup, Quantity& carried) {
  std::vector<FormulaPart> out;
  const auto add = [&](std::size_t bytes, Quantity quantity) {
    if (!out.empty() && out.back().quantity == quantity)
      out.back().markup = {out.back().markup.data(), out.back().markup.size() + bytes};
    else
      out.push_back({markup.substr(0, bytes), quantity});
    markup.remove_prefix(bytes);
  };
  while (!markup.empty()) {
    if (ends_term(markup)) carried = Quantity::none;
    if (markup[0] == '_' || markup[0] == '^') {
      const std::size_t bytes = shifted_size(markup);
      const Symbol* exponent = markup[0] == '^' ? find_symbol(markup.substr(1, bytes - 1)) : nullptr;
      add(bytes, carried == Quantity::none && exponent ? exponent->quantity : carried);
    } else if (const std::size_t word = word_size(markup)) {
      add(word, carried);
    } else if (is_letter(static_cast<unsigned char>(markup[0]))) {
      const std::size_t bytes = symbol_size(markup);
      const std::string_view symbol = markup.substr(0, bytes);
      if (const Symbol* s = find_symbol(symbol)) carried = s->quantity;
      if (symbol == "I" || symbol == "I_i") carried = Quantity::none;
      add(bytes, carried);
    } else {
      add(1, carried);
    }
  }
  return out;
}

}  // namespace cg
