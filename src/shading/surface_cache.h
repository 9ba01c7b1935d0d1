// Surfaces made once and shared: several techniques draw the same mesh by the same rule at the same time.
#pragma once
#include <algorithm>
#include <future>
#include <mutex>
#include <optional>
#include <vector>

#include "shading/surface.h"

namespace cg {

// Safe to use from several threads. Keeps the few surfaces used last, and none of a mesh that is gone.
class SurfaceCache {
 public:
  explicit SurfaceCache(std::size_t capacity = 16) : capacity_(capacity) {}

  // As make_surface. Who asks while another thread makes the same surface waits for it; others do not.
  SurfaceHandle get(const MeshHandle& mesh, NormalRule rule, double crease_angle) {
    if (rule == NormalRule::face) crease_angle = 180;  // means nothing there
    std::promise<SurfaceHandle> promise;
    if (auto made = find_or_add(mesh, rule, crease_angle, promise)) return made->get();
    try {
      SurfaceHandle surface = make_surface(*mesh, rule, crease_angle);
      promise.set_value(surface);
      return surface;
    } catch (...) {
      promise.set_exception(std::current_exception());
      const std::lock_guard lock(mutex_);
      std::erase_if(entries_, [&](const Entry& e) { return e.is(mesh, rule, crease_angle); });
      throw;
    }
  }

 private:
  struct Entry {
    std::weak_ptr<const Mesh> mesh;
    NormalRule rule;
    double crease_angle;
    std::shared_future<SurfaceHandle> surface;

    bool is(const MeshHandle& m, NormalRule r, double a) const {
      return !mesh.owner_before(m) && !m.owner_before(mesh) && rule == r && crease_angle == a;
    }
  };

  // The surface where there is one; else an entry is added that `promise` is to fulfil.
  std::optional<std::shared_future<SurfaceHandle>> find_or_add(const MeshHandle& mesh, NormalRule rule,
                                                               double crease_angle,
                                                               std::promise<SurfaceHandle>& promise) {
    const std::lock_guard lock(mutex_);
    std::erase_if(entries_, [](const Entry& e) { return e.mesh.expired(); });
    const auto found =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.is(mesh, rule, crease_angle); });
    if (found != entries_.end()) {
      std::rotate(found, found + 1, entries_.end());
      return entries_.back().surface;
    }
    if (entries_.size() >= capacity_) entries_.erase(entries_.begin());
    entries_.push_back({mesh, rule, crease_angle, promise.get_future().share()});
    return std::nullopt;
  }

  std::mutex mutex_;
  std::size_t capacity_;
  std::vector<Entry> entries_;  // the one used last stands last
};

// The program's own: what it holds never changes a result, only when it is computed.
inline SurfaceCache& surface_cache() {
  static SurfaceCache cache;
  return cache;
}

}  // namespace cg
