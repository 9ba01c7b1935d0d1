#include <cassert>

#include "params/input_error.h"
#include "params/numbers.h"
#include "params/slots.h"
#include "workbench/listing.h"

namespace cg {

void assign_number(Scene& scene, const ListingNumber& number, double value) {
  const Slots all = slots(scene);
  const Slot& slot = find_slot(all, number.path);
  value /= number.factor;
  if (number.component < 0) return assign(slot, value);
  Tree vector = slot_tree(slot);
  auto* components = std::get_if<Tree::List>(&vector.value);
  assert(components && std::size_t(number.component) < components->size());
  (*components)[std::size_t(number.component)] = value;
  assign(slot, vector);
}

void assign_number(Scene& scene, const ListingNumber& number, std::string_view text) {
  std::string_view digits = text.substr(0, text.find_last_not_of(" \t") + 1);
  digits.remove_prefix(std::min(digits.find_first_not_of(" \t"), digits.size()));
  if (digits.ends_with('f') || digits.ends_with('F')) digits.remove_suffix(1);
  const auto value = parse_number(digits);
  if (!value)
    throw InputError(number.path,
                     {"\"" + std::string(text) + "\" is not a number", "「" + std::string(text) + "」は数ではない"},
                     {"write a number as C has it: 0.5", "0.5 のように C の数で書くこと"});
  assign_number(scene, number, *value);
}

}  // namespace cg
