#include "workbench/c_preprocessor.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <span>

#include "scene/text_scanner.h"

namespace cg {

namespace {

using Tokens = std::vector<CToken>;
using TokenSpan = std::span<const CToken>;

struct Macro {
  bool has_parameters = false;
  std::vector<std::string_view> parameters;
  Tokens body;
};

constexpr std::size_t most_tokens = 2'000'000;
constexpr int deepest_macro = 100;

// #if's arithmetic: sums, comparisons, ! && || and parentheses; a name that is left is 0 (6.8.1).
class Condition {
 public:
  explicit Condition(TokenSpan tokens) : t_(tokens) {}
  bool holds() { return binary(0, 0) != 0; }

 private:
  static constexpr std::string_view levels[] = {"||", "&&", "==", "!=", "<", ">", "<=", ">=", "+", "-"};
  static int level_of(std::string_view op) {
    const auto* at = std::find(std::begin(levels), std::end(levels), op);
    const long k = at - std::begin(levels);
    return k < 2 ? int(k) : k < 4 ? 2 : k < 8 ? 3 : k < 10 ? 4 : -1;
  }

  bool ended() const { return i_ >= t_.size(); }

  static long apply(std::string_view op, long a, long b) {
    constexpr long bound = 1L << 31;
    if (op == "||") return a || b;
    if (op == "&&") return a && b;
    if (op == "==") return a == b;
    if (op == "!=") return a != b;
    if (op == "<") return a < b;
    if (op == ">") return a > b;
    if (op == "<=") return a <= b;
    if (op == ">=") return a >= b;
    a = std::clamp(a, -bound, bound), b = std::clamp(b, -bound, bound);
    return op == "+" ? a + b : a - b;
  }

  long binary(int least, int depth) {
    long a = unary(depth + 1);
    while (!ended()) {
      const std::string_view op = t_[i_].spelling;
      const int level = level_of(op);
      if (level < least) break;
      ++i_;
      a = apply(op, a, binary(level + 1, depth + 1));
    }
    return a;
  }

  long unary(int depth) {
    if (ended() || depth > deepest_macro) return i_ = t_.size(), 0;
    const CToken& t = t_[i_++];
    if (t.is("!")) return !unary(depth + 1);
    if (t.is("-")) return -unary(depth + 1);
    if (t.is("(")) {
      const long inside = binary(0, depth + 1);
      if (!ended() && t_[i_].is(")")) ++i_;
      return inside;
    }
    long v = 0;
    if (t.kind == CToken::number) {
      std::string_view digits = t.spelling;
      const bool hex = digits.starts_with("0x") || digits.starts_with("0X");
      if (hex) digits.remove_prefix(2);
      std::from_chars(digits.data(), digits.data() + digits.size(), v, hex ? 16 : 10);
      constexpr long bound = 1L << 31;
      v = std::clamp(v, -bound, bound);
    }
    return v;
  }

  TokenSpan t_;
  std::size_t i_ = 0;
};

class Preprocessor {
 public:
  explicit Preprocessor(Complaints& complaints) : complaints_(complaints) {}

  Tokens run(const CLines& lines) {
    Tokens pending;  // lines without a directive go together: a macro's arguments may span them
    long last = 1;
    for (std::size_t k = 0; k + 1 < lines.starts.size(); ++k) {
      const TokenSpan line(lines.tokens.data() + lines.starts[k], lines.starts[k + 1] - lines.starts[k]);
      last = line.back().line;
      if (line.front().is("#")) {
        flush(pending);
        directive(line.subspan(1));
      } else if (live()) {
        pending.insert(pending.end(), line.begin(), line.end());
      }
    }
    flush(pending);
    if (!branches_.empty()) complaints_.add(last, {"an #if has no #endif", "#if に対応する #endif がない"});
    out_.push_back({CToken::end, {}, last});
    return std::move(out_);
  }

 private:
  struct Branch {
    bool live, was_live;  // this part; one of its parts so far
  };
  bool live() const {
    return std::all_of(branches_.begin(), branches_.end(), [](const Branch& b) { return b.live; });
  }

  void directive(TokenSpan line) {
    if (line.empty()) return;
    const std::string_view name = line[0].spelling;
    const TokenSpan rest = line.subspan(1);
    const bool outer = live();
    if (name == "if" || name == "ifdef" || name == "ifndef") {
      const bool holds = outer && (name == "if" ? condition(rest) : defined(rest) == (name == "ifdef"));
      branches_.push_back({holds, holds || !outer});
    } else if (name == "elif" || name == "else") {
      if (branches_.empty()) return stray(line[0]);
      Branch& b = branches_.back();
      b.live = false;
      if (!b.was_live && live_outside()) b.live = b.was_live = name == "else" || condition(rest);
    } else if (name == "endif") {
      if (branches_.empty()) return stray(line[0]);
      branches_.pop_back();
    } else if (!outer) {
      return;
    } else if (name == "define") {
      define(rest);
    } else if (name == "undef") {
      if (!rest.empty()) macros_.erase(rest[0].spelling);
    } else if (name == "include" && !rest.empty() && rest[0].kind == CToken::text) {
      complaints_.add(line[0].line, phrase({"the file {0} is not read", "ファイル{0}は読まない"},
                                           {in_quotes(rest[0].spelling.substr(1, rest[0].spelling.size() - 2))}));
    }
  }

  bool live_outside() const {
    return std::all_of(branches_.begin(), branches_.end() - 1, [](const Branch& b) { return b.live; });
  }
  void stray(const CToken& t) {
    complaints_.add(t.line, phrase({"{0} has no #if", "{0}に対応する #if がない"}, {in_quotes(t.spelling)}));
  }
  bool defined(TokenSpan rest) const { return !rest.empty() && macros_.contains(rest[0].spelling); }

  bool condition(TokenSpan rest) {
    Tokens resolved;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      if (!rest[i].is("defined")) {
        resolved.push_back(rest[i]);
        continue;
      }
      const bool parenthesis = i + 1 < rest.size() && rest[i + 1].is("(");
      const std::size_t name = i + 1 + parenthesis;
      const bool is = name < rest.size() && macros_.contains(rest[name].spelling);
      resolved.push_back({CToken::number, is ? "1" : "0", rest[i].line});
      i = name + parenthesis;
    }
    Tokens expanded;
    expand(resolved, expanded, 0);
    return Condition(expanded).holds();
  }

  void define(TokenSpan rest) {
    if (rest.empty() || rest[0].kind != CToken::name) return;
    Macro macro;
    std::size_t i = 1;
    // Parameters only where the parenthesis follows without a space.
    const auto touches = [&] { return rest[0].spelling.data() + rest[0].spelling.size() == rest[1].spelling.data(); };
    if (rest.size() > 1 && rest[1].is("(") && touches()) {
      macro.has_parameters = true;
      for (i = 2; i < rest.size() && !rest[i].is(")"); ++i)
        if (rest[i].kind == CToken::name) macro.parameters.push_back(rest[i].spelling);
      ++i;
    }
    if (i < rest.size()) macro.body.assign(rest.begin() + std::ptrdiff_t(i), rest.end());
    macros_[rest[0].spelling] = std::move(macro);
  }

  void flush(Tokens& pending) {
    if (!pending.empty()) expand(pending, out_, 0);
    pending.clear();
  }

  void expand(TokenSpan in, Tokens& out, int depth) {
    for (std::size_t i = 0; i < in.size(); ++i) {
      if (out.size() > most_tokens) return too_long(in[i]);
      const auto found = in[i].kind == CToken::name ? macros_.find(in[i].spelling) : macros_.end();
      const bool active =
          found != macros_.end() && std::find(active_.begin(), active_.end(), in[i].spelling) == active_.end();
      if (!active || depth > deepest_macro) {
        out.push_back(in[i]);
      } else if (!found->second.has_parameters) {
        rescan(in[i], found->second.body, out, depth);
      } else if (i + 1 < in.size() && in[i + 1].is("(")) {
        i = call(in, i, found->second, out, depth);
      } else {
        out.push_back(in[i]);
      }
    }
  }

  // `use` replaced by `body`, itself expanded without the macro's own name.
  void rescan(const CToken& use, Tokens body, Tokens& out, int depth) {
    for (CToken& t : body) t.line = use.line;
    active_.push_back(use.spelling);
    expand(body, out, depth + 1);
    active_.pop_back();
  }

  // NAME( arguments ) at in[i]; returns the place of its closing parenthesis.
  std::size_t call(TokenSpan in, std::size_t i, const Macro& macro, Tokens& out, int depth) {
    std::vector<Tokens> arguments(1);
    int level = 0;
    std::size_t k = i + 1;
    for (; k < in.size(); ++k) {
      level += in[k].is("(") - in[k].is(")");
      if (level == 0) break;
      if (level == 1 && in[k].is(","))
        arguments.emplace_back();
      else if (k > i + 1)
        arguments.back().push_back(in[k]);
    }
    Tokens body;
    for (const CToken& t : macro.body) {
      const auto parameter = std::find(macro.parameters.begin(), macro.parameters.end(), t.spelling);
      const auto n = std::size_t(parameter - macro.parameters.begin());
      if (t.kind != CToken::name || n >= macro.parameters.size() || n >= arguments.size())
        body.push_back(t);
      else
        expand(arguments[n], body, depth + 1);
      if (body.size() > most_tokens) break;
    }
    rescan(in[i], std::move(body), out, depth);
    return k;
  }

  void too_long(const CToken& t) {
    complaints_.add(t.line, {"macros make the program too long: it is read up to here",
                             "マクロの展開が長すぎるので、ここまで読む"});
  }

  Complaints& complaints_;
  std::map<std::string_view, Macro> macros_;
  std::vector<std::string_view> active_;
  std::vector<Branch> branches_;
  Tokens out_;
};

}  // namespace

std::vector<CToken> preprocess(const CLines& lines, Complaints& complaints) {
  return Preprocessor(complaints).run(lines);
}

}  // namespace cg
