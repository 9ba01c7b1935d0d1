// The edges of the meshes after the division by w, worked out on a thread of their own.
#pragma once
#include <functional>
#include <memory>
#include <mutex>

#include "workbench/overlay.h"
#include "workbench/worker.h"

namespace cg {

class ClipEdges {
 public:
  // `wake` is called on another thread when there is something new.
  explicit ClipEdges(std::function<void()> wake) : wake_(std::move(wake)) {}
  // For the meshes and the camera of a scene whose meshes are loaded; `aspect` of its pictures.
  void update(const Scene& scene, double aspect);
  // The newest; null before the first.
  std::shared_ptr<const Lines> newest() const;

 private:
  struct Asked {
    std::vector<Object> objects;
    Camera camera;
    double aspect = 0;
    friend bool operator==(const Asked&, const Asked&) = default;
  };
  void answer(const Asked& asked);

  std::function<void()> wake_;
  Asked asked_;
  std::vector<Object> outlined_;  // on the worker's thread: whose edges `world_` are
  MeshOverlay world_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Lines> newest_;
  Worker worker_;  // last: it uses what stands above
};

}  // namespace cg
