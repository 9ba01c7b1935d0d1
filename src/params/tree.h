// A JSON document as a plain value, so that only one .cpp of the project sees the JSON library.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace cg {

struct Tree {
  using List = std::vector<Tree>;
  using Members = std::vector<std::pair<std::string, Tree>>;  // in the order they were added
  std::variant<std::nullptr_t, bool, double, std::string, List, Members> value = nullptr;

  Tree() = default;
  Tree(bool v) : value(v) {}
  Tree(double v) : value(v) {}
  Tree(int v) : value(double(v)) {}
  Tree(long long v) : value(double(v)) {}
  Tree(std::size_t v) : value(double(v)) {}
  Tree(const char* v) : value(std::string(v)) {}
  Tree(std::string v) : value(std::move(v)) {}
  Tree(std::string_view v) : value(std::string(v)) {}
  Tree(List v) : value(std::move(v)) {}
  Tree(Members v) : value(std::move(v)) {}
  // In one .cpp, as they are long and every file that holds a tree would compile them anew.
  Tree(const Tree&);
  Tree(Tree&&) noexcept;
  Tree& operator=(const Tree&);
  Tree& operator=(Tree&&) noexcept;
  ~Tree();

  bool is_null() const { return std::holds_alternative<std::nullptr_t>(value); }
  const bool* boolean() const { return std::get_if<bool>(&value); }
  const double* number() const { return std::get_if<double>(&value); }
  const std::string* string() const { return std::get_if<std::string>(&value); }
  const List* list() const { return std::get_if<List>(&value); }
  const Members* members() const { return std::get_if<Members>(&value); }

  // The member named `key`, or null.
  const Tree* find(std::string_view key) const;
  // The member named `key`, added (and this made an object) where there is none.
  Tree& at(std::string_view key);

  bool operator==(const Tree&) const;
};

// Parses JSON text. `where` names the file in errors, which carry the line. Refuses duplicate keys, more than
// 64 levels, more than 16 MiB, numbers outside double, and anything behind the end. Throws InputError.
Tree parse_json(std::string_view text, const std::string& where);

// JSON text: numbers as the shortest text that reads back as the same bits (null where they are not finite),
// members in order; `indent` 0 is one line.
std::string to_json(const Tree& tree, int indent = 2);

// RFC 7396: `patch` laid over `target`; null removes.
Tree merge_patch(Tree target, const Tree& patch);

}  // namespace cg
