// HTML that cannot be broken by what it shows: text becomes markup only by being escaped. The markup is XML as well, so
// that it can be read back by any parser.
#pragma once
#include <initializer_list>
#include <string>
#include <string_view>

namespace cg {

class Html {
 public:
  Html() = default;
  // Markup made by the program itself: a drawing, a style sheet.
  static Html of_markup(std::string markup);

  const std::string& markup() const { return markup_; }
  bool empty() const { return markup_.empty(); }
  Html& operator+=(const Html& more) {
    markup_ += more.markup_;
    return *this;
  }
  friend Html operator+(Html a, const Html& b) { return a += b; }

 private:
  std::string markup_;
};

struct Attribute {
  std::string_view name;
  std::string_view value;  // as it is meant, not escaped
};
using Attributes = std::initializer_list<Attribute>;

// Any bytes as text: what is not UTF-8, and what XML has no place for, becomes U+FFFD.
Html text(std::string_view bytes);

// <name ...>content</name>
Html element(std::string_view name, Attributes attributes, const Html& content);
Html element(std::string_view name, const Html& content);
Html element(std::string_view name, Attributes attributes, std::string_view content);
// <name .../>: img, meta, link, br, hr
Html void_element(std::string_view name, Attributes attributes = {});

}  // namespace cg
