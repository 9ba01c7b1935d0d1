#include "workbench/model_cache.h"

#include "params/input_error.h"
#include "scene/model_file.h"
#include "workbench/remembered.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

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
