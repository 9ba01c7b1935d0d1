// Surfaces made once and shared: several techniques draw the same mesh by the same rule at the same time.
#pragma once
#include <algorithm>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "shading/surface.h"

namespace cg {

// Safe to use from several threads. Keeps, of each mesh, the few surfaces used last, and none of a mesh that is gone.
class SurfaceCache {
 public:
  explicit SurfaceCache(std::size_t surfaces_a_mesh = 3) : surfaces_a_mesh_(surfaces_a_mesh) {}

  // As make_surface. Who asks while another thread makes the same surface waits for it; others do not.
  SurfaceHandle get(const MeshHandle& mesh, NormalRule rule, double crease_angle) {
    const Key key{rule, rule == NormalRule::face ? 180 : crease_angle};  // flat faces have no crease
    std::promise<SurfaceHandle> promise;
    if (auto made = find_or_add(mesh, key, promise)) return made->get();
    try {
      SurfaceHandle surface = make_surface(*mesh, key.rule, key.crease_angle);
      promise.set_value(surface);
      return surface;
    } catch (...) {
      promise.set_exception(std::current_exception());
      const std::lock_guard lock(mutex_);
      std::erase_if(meshes_[place_of(mesh)], [&](const Entry& e) { return e.key == key; });
      throw;
    }
  }

 private:
  struct Key {
    NormalRule rule;
    double crease_angle;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Entry {
    Key key;
    std::shared_future<SurfaceHandle> surface;
  };
  // A mesh that may be gone. The parts of a model may have one owner, the model, so the address counts as well.
  struct Place {
    std::weak_ptr<const Mesh> owner;
    const Mesh* mesh;
    bool operator<(const Place& other) const {
      if (owner.owner_before(other.owner)) return true;
      return !other.owner.owner_before(owner) && std::less<>()(mesh, other.mesh);
    }
  };
  static Place place_of(const MeshHandle& mesh) { return {mesh, mesh.get()}; }

  // The surface where there is one; else an entry is added that `promise` is to fulfil.
  std::optional<std::shared_future<SurfaceHandle>> find_or_add(const MeshHandle& mesh, const Key& key,
                                                               std::promise<SurfaceHandle>& promise) {
    const std::lock_guard lock(mutex_);
    std::vector<Entry>& entries = meshes_[place_of(mesh)];  // the one used last stands last
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
    if (found != entries.end()) {
      std::rotate(found, found + 1, entries.end());
      return entries.back().surface;
    }
    if (entries.size() >= surfaces_a_mesh_) entries.erase(entries.begin());
    entries.push_back({key, promise.get_future().share()});
    std::erase_if(meshes_, [](const auto& m) { return m.first.owner.expired(); });
    return std::nullopt;
  }

  std::mutex mutex_;
  std::size_t surfaces_a_mesh_;
  std::map<Place, std::vector<Entry>> meshes_;
};

// The program's own: what it holds never changes a result, only when it is computed.
inline SurfaceCache& surface_cache() {
  static SurfaceCache cache;
  return cache;
}

}  // namespace cg
