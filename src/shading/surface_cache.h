// Surfaces made once and shared: several techniques draw the same mesh by the same rule at the same time.
#pragma once
#include <algorithm>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "scene/radiosity_field.h"
#include "shading/surface.h"

namespace cg {

// Safe to use from several threads. Keeps, of each mesh, the few surfaces used last, and none of a mesh that is gone.
class SurfaceCache {
 public:
  explicit SurfaceCache(std::size_t surfaces_a_mesh = 3) : surfaces_a_mesh_(surfaces_a_mesh) {}

  // As make_surface. Who asks while another thread makes the same surface waits for it; others do not.
  SurfaceHandle get(const MeshHandle& mesh, NormalRule rule, double crease_angle) {
    return get({mesh, mesh.get()}, rule, crease_angle,
               [&](const Key& key) { return make_surface(*mesh, key.rule, key.crease_angle); });
  }
  // The same of the elements of an object, which takes part in the solution.
  SurfaceHandle get(const RadiosityHandle& field, std::size_t object, NormalRule rule, double crease_angle) {
    const ObjectRadiosity& elements = field->objects[object];
    return get({field, &elements}, rule, crease_angle, [&](const Key& key) {
      return make_surface(*elements.mesh, key.rule, key.crease_angle, &elements.corners);
    });
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
  // A mesh, or an object's radiosity, that may be gone. The parts of a model may have one owner, the model, so the
  // address counts as well.
  struct Place {
    std::weak_ptr<const void> owner;
    const void* address;
    bool operator<(const Place& other) const {
      if (owner.owner_before(other.owner)) return true;
      return !other.owner.owner_before(owner) && std::less<>()(address, other.address);
    }
  };

  template <class Make>
  SurfaceHandle get(const Place& place, NormalRule rule, double crease_angle, const Make& make) {
    const Key key{rule, rule == NormalRule::face ? 180 : crease_angle};  // flat faces have no crease
    std::promise<SurfaceHandle> promise;
    if (auto made = find_or_add(place, key, promise)) return made->get();
    try {
      SurfaceHandle surface = make(key);
      promise.set_value(surface);
      return surface;
    } catch (...) {
      promise.set_exception(std::current_exception());
      const std::lock_guard lock(mutex_);
      std::erase_if(places_[place], [&](const Entry& e) { return e.key == key; });
      throw;
    }
  }

  // The surface where there is one; else an entry is added that `promise` is to fulfil.
  std::optional<std::shared_future<SurfaceHandle>> find_or_add(const Place& place, const Key& key,
                                                               std::promise<SurfaceHandle>& promise) {
    const std::lock_guard lock(mutex_);
    std::vector<Entry>& entries = places_[place];  // the one used last stands last
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
    if (found != entries.end()) {
      std::rotate(found, found + 1, entries.end());
      return entries.back().surface;
    }
    if (entries.size() >= surfaces_a_mesh_) entries.erase(entries.begin());
    entries.push_back({key, promise.get_future().share()});
    std::erase_if(places_, [](const auto& m) { return m.first.owner.expired(); });
    return std::nullopt;
  }

  std::mutex mutex_;
  std::size_t surfaces_a_mesh_;
  std::map<Place, std::vector<Entry>> places_;
};

// The program's own: what it holds never changes a result, only when it is computed.
inline SurfaceCache& surface_cache() {
  static SurfaceCache cache;
  return cache;
}

}  // namespace cg
