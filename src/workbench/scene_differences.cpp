#include "workbench/scene_differences.h"

#include <algorithm>

#include "params/slots.h"

namespace cg {

namespace {

// The values of an item that are not the defaults, nested as their paths are.
template <class Item>
Tree not_default(Item item) {
  Tree out{Tree::Members{}};
  for (const Slot& slot : slots(item))
    if (!is_initial(slot)) at_path(out, slot.path) = slot_tree(slot);
  return out;
}

// The items behind those that both lists have.
template <class Item>
std::vector<ParameterDifference> unpaired(const std::string& key, const std::vector<Item>& a,
                                          const std::vector<Item>& b) {
  std::vector<ParameterDifference> out;
  for (std::size_t i = std::min(a.size(), b.size()); i < std::max(a.size(), b.size()); ++i)
    out.push_back({key + "." + std::to_string(i), i < a.size() ? not_default(a[i]) : Tree(),
                   i < b.size() ? not_default(b[i]) : Tree(), nullptr});
  return out;
}

void append(std::vector<ParameterDifference>& out, std::vector<ParameterDifference> more) {
  std::move(more.begin(), more.end(), std::back_inserter(out));
}

Text shown(const Tree& value) {
  if (value.is_null()) return Words{"none", "なし"};
  if (value.members()) return Words{"added", "あり"};
  const std::string text = value.string() ? *value.string() : to_json(value, 0);
  return {text, text};
}

}  // namespace

std::vector<ParameterDifference> scene_differences(const Scene& a, const Scene& b) {
  Scene common_a = a, common_b = b;  // slots point into them
  const std::size_t objects = std::min(a.objects.size(), b.objects.size());
  const std::size_t lights = std::min(a.lights.size(), b.lights.size());
  for (Scene* s : {&common_a, &common_b}) s->objects.resize(objects), s->lights.resize(lights);
  std::vector<ParameterDifference> out;
  const Slots in_a = slots(common_a), in_b = slots(common_b);
  bool objects_told = false, lights_told = false;
  for (std::size_t i = 0; i < in_a.size(); ++i) {
    const std::string& path = in_a[i].path;
    const bool object = path.starts_with("objects."), material = path.starts_with("material."),
               light = path.starts_with("lights.");
    if (!object && !objects_told) append(out, unpaired("objects", a.objects, b.objects)), objects_told = true;
    if (!object && !material && !light && !lights_told)
      append(out, unpaired("lights", a.lights, b.lights)), lights_told = true;
    const Tree value_a = slot_tree(in_a[i]), value_b = slot_tree(in_b[i]);
    if (!(value_a == value_b)) out.push_back({path, value_a, value_b, in_a[i].about});
  }
  return out;
}

Text text_of(const ParameterDifference& d) {
  const auto text = [&](std::string Text::*side) {
    // What is there on one side only needs one word.
    const Text removed = Words{"removed", "削除"};
    const bool gone = d.a.members() && d.b.is_null();
    const Text present = Words{"present", "あり"};
    return d.path + " " + (gone ? present : shown(d.a)).*side + " → " + (gone ? removed : shown(d.b)).*side;
  };
  return {text(&Text::en), text(&Text::ja)};
}

}  // namespace cg
