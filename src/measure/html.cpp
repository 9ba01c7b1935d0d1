#include "measure/html.h"

namespace cg {

namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";  // U+FFFD

// How many bytes the character at the start of `s` has that both UTF-8 (RFC 3629) and XML 1.0 (2.2 Characters) allow;
// 0: there is none.
std::size_t character_size(std::string_view s) {
  const auto byte = [&](std::size_t i) { return i < s.size() ? static_cast<unsigned char>(s[i]) : 0u; };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' ? 1 : 0;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  unsigned point = first & (0x7fu >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    point = point << 6 | (byte(i) & 0x3f);
  }
  constexpr unsigned least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = point >= 0xd800 && point < 0xe000;
  return first < 0xc2 || first > 0xf4 || point < least[size] || point > 0x10ffff || surrogate || point == 0xfffe ||
                 point == 0xffff
             ? 0
             : size;
}

std::string escaped(std::string_view s) {
  std::string out;
  while (!s.empty()) {
    const std::size_t size = character_size(s);
    switch (s[0]) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += size == 0 ? replacement : s.substr(0, size);
    }
    s.remove_prefix(size == 0 ? 1 : size);
  }
  return out;
}

std::string opened(std::string_view name, Attributes attributes) {
  std::string out = "<" + std::string(name);
  for (const Attribute& a : attributes) out += " " + std::string(a.name) + "=\"" + escaped(a.value) + "\"";
  return out;
}

}  // namespace

Html Html::of_markup(std::string markup) {
  Html out;
  out.markup_ = std::move(markup);
  return out;
}

Html text(std::string_view bytes) { return Html::of_markup(escaped(bytes)); }

Html element(std::string_view name, Attributes attributes, const Html& content) {
  return Html::of_markup(opened(name, attributes) + ">" + content.markup() + "</" + std::string(name) + ">");
}
Html element(std::string_view name, const Html& content) { return element(name, {}, content); }
Html element(std::string_view name, Attributes attributes, std::string_view content) {
  return element(name, attributes, text(content));
}
Html void_element(std::string_view name, Attributes attributes) {
  return Html::of_markup(opened(name, attributes) + "/>");
}

}  // namespace cg
