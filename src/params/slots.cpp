#include "params/slots.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "params/input_error.h"
#include "params/numbers.h"

namespace cg {

namespace {

template <class... F>
struct Visitor : F... {
  using F::operator()...;
};
template <class... F>
Visitor(F...) -> Visitor<F...>;

Tree tree_of(const SlotValue& value) {
  return std::visit(Visitor{[](const bool* v) { return Tree(*v); }, [](const int* v) { return Tree(*v); },
                            [](const double* v) { return Tree(*v); },
                            [](const glm::dvec3* v) {
                              return Tree(Tree::List{v->x, v->y, v->z});
                            },
                            [](const std::string* v) { return Tree(*v); },
                            [](const Choice& c) { return Tree(c.names[std::size_t(c.get(c.object))].id); }},
                    value);
}

Text limits(const About& about) {
  const std::string low = number_text(about.range.min), high = number_text(about.range.max);
  Text out{"from " + low + " to " + high, low + " から " + high};
  if (about.also) {
    out.en += ", or " + number_text(*about.also);
    out.ja += "、または " + number_text(*about.also);
  }
  return out;
}

Text what_is_accepted(const Slot& slot) {
  const Text range = limits(*slot.about);
  const bool colour = slot.about->meaning == Meaning::colour;
  return std::visit(Visitor{[](const bool*) {
                              return Text{"give true or false", "true か false を指定してください"};
                            },
                            [&](const int*) {
                              return Text{"give a whole number " + range.en, range.ja + " の整数を指定してください"};
                            },
                            [&](const double*) {
                              return Text{"give a number " + range.en, range.ja + " の数を指定してください"};
                            },
                            [&](const glm::dvec3*) {
                              return colour ? Text{"give three numbers (or one for all three) " + range.en,
                                                   range.ja + " の数を三つ（または共通の一つ）指定してください"}
                                            : Text{"give three numbers " + range.en,
                                                   range.ja + " の数を三つ指定してください"};
                            },
                            [](const std::string*) {
                              return Text{"give a text", "文字列を指定してください"};
                            },
                            [](const Choice& c) {
                              std::string names;
                              for (const Name& name : c.names)
                                names += (names.empty() ? "" : ", ") + std::string(name.id);
                              return Text{"known are: " + names, "使えるのは " + names + " です"};
                            }},
                    slot.value);
}

// Long values are cut: the message is one line.
std::string shown(const Tree& value) {
  std::string text = to_json(value, 0);
  constexpr std::size_t longest = 60;
  if (text.size() <= longest) return text;
  std::size_t cut = longest;
  while ((static_cast<unsigned char>(text[cut]) & 0xc0) == 0x80) --cut;  // not inside a character of UTF-8
  return text.substr(0, cut) + "…";
}

[[noreturn]] void refuse(const Slot& slot, const std::string& found) {
  throw InputError(slot.path, {found + " is not possible here", found + " はここでは使えません"},
                   what_is_accepted(slot));
}

// Checks a number against the description. Written so that NaN is refused.
double checked(const Slot& slot, const Tree& whole, const Tree& number) {
  const double* v = number.number();
  if (!v) refuse(slot, shown(whole));
  if (!slot.about->accepts(*v)) refuse(slot, std::isfinite(*v) ? shown(whole) : number_text(*v));
  return *v;
}

glm::dvec3 checked_vector(const Slot& slot, const Tree& value) {
  if (value.number() && slot.about->meaning == Meaning::colour) return glm::dvec3(checked(slot, value, value));
  const Tree::List* list = value.list();
  if (!list || list->size() != 3) refuse(slot, shown(value));
  return {checked(slot, value, (*list)[0]), checked(slot, value, (*list)[1]), checked(slot, value, (*list)[2])};
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == text.npos ? std::string_view() : text.substr(first, last - first + 1);
}

Tree number_tree(const Slot& slot, std::string_view text, std::string_view whole) {
  const auto v = parse_number(trimmed(text));
  if (!v) refuse(slot, shown(Tree(whole)));
  return *v;
}

// Levenshtein's distance: insertions, deletions and replacements from one to the other.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

// The names that may stand after `prefix`, each once, those most like `wrong` first.
std::vector<std::string> names_after(const Slots& all, std::string_view prefix, std::string_view wrong) {
  std::vector<std::string> names;
  for (const Slot& slot : all) {
    if (!std::string_view(slot.path).starts_with(prefix)) continue;
    const std::string rest = slot.path.substr(prefix.size());
    const std::string name = rest.substr(0, rest.find('.'));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  const auto closer = [&](const std::string& a, const std::string& b) { return edits(a, wrong) < edits(b, wrong); };
  std::stable_sort(names.begin(), names.end(), closer);
  return names;
}

}  // namespace

Tree slot_tree(const Slot& slot) { return tree_of(slot.value); }
Tree initial_tree(const Slot& slot) { return tree_of(slot.initial); }

void assign(const Slot& slot, const Tree& value) {
  std::visit(Visitor{[&](bool* v) {
                       if (!value.boolean()) refuse(slot, shown(value));
                       *v = *value.boolean();
                     },
                     [&](int* v) {
                       const double number = checked(slot, value, value);
                       if (number != std::floor(number) || std::abs(number) > 2e9) refuse(slot, shown(value));
                       *v = int(number);
                     },
                     [&](double* v) { *v = checked(slot, value, value); },
                     [&](glm::dvec3* v) { *v = checked_vector(slot, value); },
                     [&](std::string* v) {
                       if (!value.string()) refuse(slot, shown(value));
                       *v = *value.string();
                     },
                     [&](const Choice& c) {
                       const std::string_view id = value.string()    ? std::string_view(*value.string())
                                                   : value.boolean() ? (*value.boolean() ? "true" : "false")
                                                                     : "";
                       for (std::size_t i = 0; !id.empty() && i < c.names.size(); ++i)
                         if (id == c.names[i].id || id == c.names[i].formerly) return c.set(c.object, int(i));
                       refuse(slot, shown(value));
                     }},
             slot.value);
}

void assign_text(const Slot& slot, std::string_view text) {
  const auto vector = [&](const glm::dvec3*) {
    Tree::List list;
    for (std::size_t begin = 0;;) {
      const std::size_t comma = text.find(',', begin);
      list.push_back(number_tree(slot, text.substr(begin, comma - begin), text));
      if (comma == text.npos) break;
      begin = comma + 1;
    }
    return list.size() == 1 ? list[0] : Tree(std::move(list));
  };
  const auto boolean = [&](const bool*) {
    return text == "true" ? Tree(true) : text == "false" ? Tree(false) : Tree(text);
  };
  const auto number = [&](const auto*) { return number_tree(slot, text, text); };
  assign(slot,
         std::visit(Visitor{boolean, vector, [&](const int* v) { return number(v); },
                            [&](const double* v) { return number(v); }, [&](const std::string*) { return Tree(text); },
                            [&](const Choice&) { return Tree(text); }},
                    slot.value));
}

bool is_initial(const Slot& slot) { return slot_tree(slot) == initial_tree(slot); }
void reset(const Slot& slot) { assign(slot, initial_tree(slot)); }

Tree& at_path(Tree& root, std::string_view path) {
  Tree* tree = &root;
  for (std::size_t dot = path.find('.'); dot != path.npos; dot = path.find('.')) {
    tree = &tree->at(path.substr(0, dot));
    path.remove_prefix(dot + 1);
  }
  return tree->at(path);
}

Tree values_of(const Slots& all) {
  Tree out{Tree::Members{}};
  for (const Slot& slot : all) at_path(out, slot.path) = slot_tree(slot);
  return out;
}

std::size_t take_values(const Slots& all, const Tree& values) {
  std::size_t left = 0;
  const auto take = [&](const auto& self, const Tree& tree, const std::string& prefix) -> void {
    for (const auto& [key, value] : *tree.members()) {
      if (value.members()) {
        self(self, value, prefix + key + ".");
        continue;
      }
      const auto slot =
          std::find_if(all.begin(), all.end(), [path = prefix + key](const Slot& s) { return s.path == path; });
      try {
        if (slot == all.end())
          ++left;
        else
          assign(*slot, value);
      } catch (const InputError&) {
        ++left;
      }
    }
  };
  if (!values.members()) return 1;
  take(take, values, "");
  return left;
}

const Slot& find_slot(const Slots& all, std::string_view path) {
  for (const Slot& slot : all)
    if (slot.path == path) return slot;
  // As far as the path is right ("material." of "material.kd"); what follows is what has to be listed.
  std::string prefix;
  for (std::size_t dot = path.find('.'); dot != path.npos; dot = path.find('.', dot + 1)) {
    const std::string longer(path.substr(0, dot + 1));
    const auto begins = [&](const Slot& slot) { return slot.path.starts_with(longer); };
    if (std::none_of(all.begin(), all.end(), begins)) break;
    prefix = longer;
  }
  std::string names;
  for (const std::string& name : names_after(all, prefix, path.substr(std::min(prefix.size(), path.size()))))
    names += (names.empty() ? "" : ", ") + prefix + name;
  throw InputError(std::string(path), {"there is no such parameter", "そのような項目はありません"},
                   {"known are: " + names, "あるのは " + names + " です"});
}

}  // namespace cg
