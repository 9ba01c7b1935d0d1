// A described parameter with its static type forgotten, so that every consumer (slider, JSON, --set,
// reset, ...) is an ordinary function compiled once.
#pragma once
#include <span>
#include <variant>

#include "params/field.h"
#include "params/tree.h"

namespace cg {

// An enumeration: its value as an index into its names.
struct Choice {
  void* object;
  int (*get)(const void*);
  void (*set)(void*, int);
  std::span<const Name> names;
};

using SlotValue = std::variant<bool*, int*, double*, glm::dvec3*, std::string*, Choice>;

struct Slot {
  std::string path;    // "lights.0.position"
  const About* about;  // never null
  SlotValue value;     // points into the struct that was walked
  SlotValue initial;   // points to the default; never written
};
using Slots = std::vector<Slot>;

template <class V>
SlotValue slot_value(V& v) {
  if constexpr (std::is_enum_v<V>)
    return Choice{&v, [](const void* p) { return int(*static_cast<const V*>(p)); },
                  [](void* p, int i) { *static_cast<V*>(p) = V(i); }, names_of<V>};
  else
    return &v;
}

template <Described T>
T& defaults_of() {
  static T value{};
  return value;
}

// Appends the fields of `params` in lecture order: nested structs as "name.", lists as "name.0.", "name.1.".
template <Described T>
void append_slots(Slots& out, T& params, const std::string& prefix) {
  auto one = [&](auto member, const About& about) {
    auto& v = params.*member;
    using V = std::remove_cvref_t<decltype(v)>;
    const std::string path = prefix + std::string(about.name);
    if constexpr (Described<V>) {
      append_slots(out, v, path + ".");
    } else if constexpr (ListOf<V>::value) {
      for (std::size_t i = 0; i < v.size(); ++i) append_slots(out, v[i], path + "." + std::to_string(i) + ".");
    } else {
      out.push_back({path, &about, slot_value(v), slot_value(defaults_of<T>().*member)});
    }
  };
  std::apply([&](const auto&... f) { (one(f.member, f.about), ...); }, fields_of<T>);
}

// The slots point into `params`: they are valid as long as it stays where it is and its lists keep their length.
template <Described T>
Slots slots(T& params) {
  Slots out;
  append_slots(out, params, "");
  return out;
}

// The value as JSON has it: bool, number, string (also for a choice), or an array of three numbers.
Tree slot_tree(const Slot& slot);
Tree initial_tree(const Slot& slot);

// Checks `value` against the description and stores it; a colour also takes one number for all three.
// Throws InputError that names the path, what was found and what is accepted; nothing is stored then.
void assign(const Slot& slot, const Tree& value);

// The same from text as it is typed after --set: "0.5", "0.5,0.2,0.1", "gouraud", "true".
void assign_text(const Slot& slot, std::string_view text);

bool is_initial(const Slot& slot);
void reset(const Slot& slot);

// All values, nested as the paths are: {"material": {"k_d": [0.8, 0.8, 0.8]}}.
Tree values_of(const Slots& all);

// Takes from `values` what is known and valid, and leaves the rest as it is: for settings, which a newer program or a
// damaged file must not make unusable. Returns how many values of `values` it did not take.
std::size_t take_values(const Slots& all, const Tree& values);

// The place of `path` in nested objects, which are made where they are missing.
Tree& at_path(Tree& root, std::string_view path);

// The slot at `path`, or InputError that lists what is there, the nearest names first.
const Slot& find_slot(const Slots& all, std::string_view path);

}  // namespace cg
