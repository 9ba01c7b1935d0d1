#include "workbench/technique_list.h"

#include "params/input_error.h"

namespace cg {

namespace {

std::optional<Text> obstacle(const Technique& technique, const Scene& scene) {
  if (technique.unavailable) return technique.unavailable;
  return technique.unsupported ? technique.unsupported(scene) : std::nullopt;
}

}  // namespace

const Technique& find_technique(std::span<const Technique> all, std::string_view id) {
  std::string ids;
  for (const Technique& technique : all) {
    if (technique.id == id) return technique;
    ids += (ids.empty() ? "" : ", ") + technique.id;
  }
  throw InputError(std::string(id), {"there is no such technique", "そのような手法はありません"},
                   {"known are: " + ids, "あるのは " + ids + " です"});
}

void require(const Technique& technique, const Scene& scene) {
  if (const auto reason = obstacle(technique, scene)) throw InputError(technique.id, *reason);
}

const Technique* first_able(std::span<const Technique> all, const Scene& scene,
                            std::initializer_list<std::string_view> ids) {
  for (const std::string_view id : ids)
    for (const Technique& technique : all)
      if (technique.id == id && !obstacle(technique, scene)) return &technique;
  return nullptr;
}

}  // namespace cg
