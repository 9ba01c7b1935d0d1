// A list of a parameter struct with the type of its items forgotten: for whoever adds and takes away items by a path,
// in presets, after --set, in comments.
#pragma once
#include "params/slots.h"

namespace cg {

struct ListSlot {
  std::string path;    // "lights", "objects.0.material.layers"
  const About* about;  // its `most` says how many items there may be
  void* list;
  std::size_t (*size_of)(const void*);
  void (*set_size)(void*, std::size_t);
  void (*take_away)(void*, std::size_t);
  bool nested;  // its items hold lists, whose places are others after a change

  std::size_t size() const { return size_of(list); }
  // Items that are added have the defaults.
  void resize(std::size_t size) const { set_size(list, size); }
  void erase(std::size_t index) const { take_away(list, index); }
};

template <Described T>
constexpr bool has_lists() {
  const auto one = []<class Owner, class V>(const Field<Owner, V>&) {
    if constexpr (Described<V>)
      return has_lists<V>();
    else
      return ListOf<V>::value;
  };
  return std::apply([&](const auto&... f) { return (one(f) || ...); }, fields_of<T>);
}

template <Described T>
void append_lists(std::vector<ListSlot>& out, T& params, const std::string& prefix) {
  if constexpr (!has_lists<T>()) return;
  const auto one = [&](auto member, const About& about) {
    auto& v = params.*member;
    using V = std::remove_cvref_t<decltype(v)>;
    const std::string path = prefix + std::string(about.name);
    if constexpr (Described<V>) {
      append_lists(out, v, path + ".");
    } else if constexpr (ListOf<V>::value) {
      out.push_back({path, &about, &v, [](const void* list) { return static_cast<const V*>(list)->size(); },
                     [](void* list, std::size_t size) { static_cast<V*>(list)->resize(size); },
                     [](void* list, std::size_t i) {
                       V& items = *static_cast<V*>(list);
                       items.erase(items.begin() + std::ptrdiff_t(i));
                     },
                     has_lists<typename V::value_type>()});
      if constexpr (has_lists<typename V::value_type>())
        for (std::size_t i = 0; i < v.size(); ++i) append_lists(out, v[i], path + "." + std::to_string(i) + ".");
    }
  };
  std::apply([&](const auto&... f) { (one(f.member, f.about), ...); }, fields_of<T>);
}

// All of them, an outer list before those of its items. They point into `params`, as slots() do.
template <Described T>
std::vector<ListSlot> lists(T& params) {
  std::vector<ListSlot> out;
  append_lists(out, params, "");
  return out;
}

// Calls change(list) for each list, an outer one before those of its items, which may resize it: what lies in it is
// walked anew.
template <Described T, class Change>
void for_each_list(T& params, const Change& change) {
  std::vector<ListSlot> all = lists(params);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t before = all[i].size();
    change(all[i]);
    if (all[i].nested && all[i].size() != before) all = lists(params);
  }
}

// Adds the item that a path begins with ("lights.1.position") where it is the next of its list and there may be one
// more.
template <Described T>
void add_next_items(T& params, std::string_view path) {
  for_each_list(params, [&](const ListSlot& list) {
    const std::string next = list.path + "." + std::to_string(list.size()) + ".";
    if (path.starts_with(next) && list.size() < list.about->most) list.resize(list.size() + 1);
  });
}

}  // namespace cg
