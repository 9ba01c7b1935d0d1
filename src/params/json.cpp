// JSON text to a Tree and back (RFC 8259). The only file that sees the JSON library.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "params/input_error.h"
#include "params/numbers.h"
#include "params/tree.h"

namespace cg {

namespace {

constexpr std::size_t largest_text = std::size_t(16) << 20;
constexpr std::size_t deepest = 64;

// Walks the text and remembers how far the parser has read, so that every error has a line and a column.
class Reading {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Reading(const char* at, const char** furthest) : at_(at), furthest_(furthest) {}
  reference operator*() const { return *at_; }
  Reading& operator++() {
    *furthest_ = ++at_;
    return *this;
  }
  Reading operator++(int) {
    Reading before = *this;
    ++*this;
    return before;
  }
  bool operator==(const Reading& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  const char** furthest_;
};

// Receives the parser's events; unfinished lists and objects stand on a stack.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Tree root;
  Text problem;  // empty: none

  bool null() override { return add(Tree()); }
  bool boolean(bool v) override { return add(v); }
  bool number_integer(number_integer_t v) override { return add(double(v)); }
  bool number_unsigned(number_unsigned_t v) override { return add(double(v)); }
  bool number_float(number_float_t v, const string_t&) override { return add(v); }
  bool string(string_t& v) override { return add(std::move(v)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Tree(Tree::Members{})); }
  bool start_array(std::size_t) override { return open(Tree(Tree::List{})); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& k) override {
    if (!unfinished_.back().seen.insert(k).second) {
      problem = {"the key \"" + k + "\" stands twice in one object", "キー「" + k + "」が同じ階層に二度あります"};
      return false;
    }
    unfinished_.back().key = std::move(k);
    return true;
  }

  bool parse_error(std::size_t, const std::string& token, const nlohmann::json::exception& e) override {
    if (e.id == 406)
      problem = {"the number " + token + " is too large for a double", "数 " + token + " は double に収まりません"};
    else if (token.empty() || token == "<U+0000>")
      problem = {"the text ends too early", "途中で終わっています"};
    else
      problem = {"this is not JSON at '" + token + "'", "'" + token + "' の所で JSON になっていません"};
    return false;
  }

 private:
  struct Unfinished {
    Tree tree;
    std::string key;                       // of the member that comes next
    std::unordered_set<std::string> seen;  // keys so far
  };

  bool add(Tree v) {
    if (unfinished_.empty()) {
      root = std::move(v);
      return true;
    }
    Unfinished& into = unfinished_.back();
    if (auto* list = std::get_if<Tree::List>(&into.tree.value))
      list->push_back(std::move(v));
    else
      std::get<Tree::Members>(into.tree.value).emplace_back(std::move(into.key), std::move(v));
    return true;
  }

  bool open(Tree empty) {
    if (unfinished_.size() == deepest) {
      problem = {"nested more than 64 levels deep", "入れ子が 64 段より深くなっています"};
      return false;
    }
    unfinished_.push_back({std::move(empty), {}, {}});
    return true;
  }

  bool close() {
    Tree done = std::move(unfinished_.back().tree);
    unfinished_.pop_back();
    return add(std::move(done));
  }

  std::vector<Unfinished> unfinished_;
};

// What the parser read last, short enough for one line of a message.
void shorten(std::string& text) {
  constexpr std::size_t longest = 160;
  if (text.size() <= longest) return;
  std::size_t cut = longest;
  while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xc0) == 0x80) --cut;  // not inside a character
  text = text.substr(0, cut) + "…";
}

void append_quoted(std::string& out, const std::string& text) {
  out += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append(std::string& out, const Tree& tree, int indent, int level) {
  const auto line = [&](int to) {
    if (indent > 0) out += '\n', out.append(std::size_t(to * indent), ' ');
  };
  if (const double* v = tree.number()) {
    // "-0" would be read back as the integer 0, and there is no text for what is not finite.
    out += !std::isfinite(*v) ? "null" : *v == 0 && std::signbit(*v) ? "-0.0" : number_text(*v);
  } else if (const bool* b = tree.boolean()) {
    out += *b ? "true" : "false";
  } else if (const std::string* text = tree.string()) {
    append_quoted(out, *text);
  } else if (const Tree::List* list = tree.list()) {
    // Numbers (a colour, a position) stay on one line.
    const bool flat = std::all_of(list->begin(), list->end(), [](const Tree& t) { return !t.list() && !t.members(); });
    out += '[';
    for (std::size_t i = 0; i < list->size(); ++i) {
      if (i) out += flat && indent > 0 ? ", " : ",";
      if (!flat) line(level + 1);
      append(out, (*list)[i], indent, level + 1);
    }
    if (!flat) line(level);
    out += ']';
  } else if (const Tree::Members* members = tree.members()) {
    out += '{';
    for (std::size_t i = 0; i < members->size(); ++i) {
      if (i) out += ',';
      line(level + 1);
      append_quoted(out, (*members)[i].first);
      out += indent > 0 ? ": " : ":";
      append(out, (*members)[i].second, indent, level + 1);
    }
    if (!members->empty()) line(level);
    out += '}';
  } else {
    out += "null";
  }
}

}  // namespace

Tree parse_json(std::string_view text, const std::string& where) {
  if (text.size() > largest_text) throw InputError(where, {"the text is larger than 16 MiB", "16 MiB を超えています"});
  const char* furthest = text.data();
  Builder builder;
  const Reading begin(text.data(), &furthest), end(text.data() + text.size(), &furthest);
  if (nlohmann::json::sax_parse(begin, end, &builder)) return std::move(builder.root);

  const std::string_view read = text.substr(0, std::size_t(furthest - text.data()));
  const auto line = 1 + std::count(read.begin(), read.end(), '\n');
  const auto newline = read.rfind('\n');
  const std::size_t column = std::max<std::size_t>(newline == read.npos ? read.size() : read.size() - newline - 1, 1);
  shorten(builder.problem.en);
  shorten(builder.problem.ja);
  throw InputError(where,
                   {builder.problem.en + " (column " + std::to_string(column) + ")",
                    builder.problem.ja + "（" + std::to_string(column) + " 桁目）"},
                   {}, line);
}

std::string to_json(const Tree& tree, int indent) {
  std::string out;
  append(out, tree, indent, 0);
  return out;
}

}  // namespace cg
