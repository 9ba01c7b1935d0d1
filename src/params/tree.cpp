#include "params/tree.h"

#include <algorithm>

namespace cg {

Tree::Tree(const Tree&) = default;
Tree::Tree(Tree&&) noexcept = default;
Tree& Tree::operator=(const Tree&) = default;
Tree& Tree::operator=(Tree&&) noexcept = default;
Tree::~Tree() = default;
bool Tree::operator==(const Tree& other) const { return value == other.value; }

const Tree* Tree::find(std::string_view key) const {
  if (const Members* all = members())
    for (const auto& [name, tree] : *all)
      if (name == key) return &tree;
  return nullptr;
}

Tree& Tree::at(std::string_view key) {
  if (!members()) value = Members{};
  Members& all = std::get<Members>(value);
  for (auto& [name, tree] : all)
    if (name == key) return tree;
  return all.emplace_back(std::string(key), Tree{}).second;
}

Tree merge_patch(Tree target, const Tree& patch) {
  const Tree::Members* changes = patch.members();
  if (!changes) return patch;
  if (!target.members()) target = Tree(Tree::Members{});
  for (const auto& [key, change] : *changes) {
    if (change.is_null()) {
      std::erase_if(std::get<Tree::Members>(target.value),
                    [&name = key](const auto& member) { return member.first == name; });
    } else {
      Tree& member = target.at(key);
      member = merge_patch(std::move(member), change);
    }
  }
  return target;
}

}  // namespace cg
