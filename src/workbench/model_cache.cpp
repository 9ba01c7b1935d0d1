#include "workbench/model_cache.h"

#include <map>
#include <mutex>
#include <system_error>
#include <utility>

#include "params/input_error.h"
#include "scene/model_file.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

// What tells a file from an older version of itself.
struct Stamp {
  fs::file_time_type changed;
  std::uintmax_t size = 0;
  friend bool operator==(const Stamp&, const Stamp&) = default;
};

Stamp stamp_of(const fs::path& file) {
  std::error_code error;
  const Stamp stamp{fs::last_write_time(file, error), fs::file_size(file, error)};
  return error ? Stamp{} : stamp;
}

// Values that are remembered as long as somebody holds them.
template <class Key, class T>
class Remembered {
 public:
  // `make` is called where nothing is remembered under the key, or something with another stamp. Others wait meanwhile:
  // they may want the same.
  template <class Make>
  std::shared_ptr<const T> get(const Key& key, const Stamp& stamp, Make make) {
    const std::lock_guard lock(mutex_);
    if (const auto known = entries_.find(key); known != entries_.end() && known->second.first == stamp)
      if (auto value = known->second.second.lock()) return value;
    std::erase_if(entries_, [](const auto& entry) { return entry.second.second.expired(); });
    std::shared_ptr<const T> value = make();
    entries_[key] = {stamp, value};
    return value;
  }

 private:
  std::mutex mutex_;
  std::map<Key, std::pair<Stamp, std::weak_ptr<const T>>> entries_;
};

void append(MeshData& to, const MeshData& from) {
  const auto moved = [](std::uint32_t index, std::size_t by) {
    return index == no_index ? no_index : index + std::uint32_t(by);
  };
  for (const Corner& c : from.corners)
    to.corners.push_back(
        {moved(c.position, to.positions.size()), moved(c.normal, to.normals.size()), moved(c.uv, to.uvs.size())});
  const std::uint32_t corners = to.first_corner.back();
  for (std::size_t f = 1; f < from.first_corner.size(); ++f) to.first_corner.push_back(corners + from.first_corner[f]);
  to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
  to.normals.insert(to.normals.end(), from.normals.begin(), from.normals.end());
  to.uvs.insert(to.uvs.end(), from.uvs.begin(), from.uvs.end());
}

// A handle to the mesh that keeps the whole model: its other parts are at hand as long as one is used.
MeshHandle part_of(const std::shared_ptr<const Model>& model, const ModelPart& part) {
  return {model, part.mesh.get()};
}

}  // namespace

std::shared_ptr<const Model> model_in(const fs::path& file) {
  static Remembered<std::string, Model> models;
  return models.get(file.string(), stamp_of(file), [&] { return std::make_shared<const Model>(read_model(file)); });
}

MeshHandle mesh_in(const fs::path& file, const std::string& part, const std::string& where) {
  const std::shared_ptr<const Model> model = model_in(file);
  if (part.empty() && model->parts.size() == 1) return part_of(model, model->parts[0]);
  if (part.empty()) {
    static Remembered<std::string, Mesh> wholes;
    return wholes.get(file.string(), stamp_of(file), [&] {
      MeshData all;
      for (const ModelPart& p : model->parts) append(all, p.mesh->data());
      return Mesh::make(std::move(all));
    });
  }
  std::string names;
  for (const ModelPart& p : model->parts) {
    if (p.name == part) return part_of(model, p);
    names += (names.empty() ? "" : ", ") + p.name;
  }
  throw InputError(where + ".part",
                   {file.string() + " has no part " + part, file.string() + " に " + part + " はありません"},
                   {"known are: " + names, "あるのは " + names + " です"});
}

MeshHandle mesh_of(const Shape& shape, int level) {
  static Remembered<std::pair<std::string, int>, Mesh> meshes;
  return meshes.get({std::string(shape.id), level}, {}, [&] { return make_shape(shape, level); });
}

}  // namespace cg
