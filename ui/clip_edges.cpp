#include "ui/clip_edges.h"

#include "workbench/world_lines.h"

namespace cg {

void ClipEdges::update(const Scene& scene, double aspect) {
  Asked asked{scene.objects, scene.camera, aspect};
  for (Object& object : asked.objects) object.material = {}, object.own_material = false;
  if (asked == asked_) return;
  asked_ = asked;
  worker_.submit([this, asked = std::move(asked)](Progress&) { answer(asked); });
}

void ClipEdges::answer(const Asked& asked) {
  if (asked.objects != outlined_) {
    Scene scene;
    scene.objects = asked.objects;
    world_ = mesh_overlay(scene, {.edges = true});
    outlined_ = asked.objects;
  }
  auto lines = std::make_shared<const Lines>(after_division(asked.camera, asked.aspect, world_.lines));
  {
    const std::lock_guard lock(mutex_);
    newest_.swap(lines);
  }
  if (wake_) wake_();
}

std::shared_ptr<const Lines> ClipEdges::newest() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

}  // namespace cg
