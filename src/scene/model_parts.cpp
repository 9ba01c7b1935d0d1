#include "scene/model_parts.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "scene/text_scanner.h"

namespace cg {

namespace {

// Copies the values that `part` uses, once each, and numbers its corners anew. `number` holds no_index for each value
// of `from`, before and after.
template <class Value>
void take_used(MeshData& part, std::uint32_t Corner::*index, const std::vector<Value>& from, std::vector<Value>& to,
               std::vector<std::uint32_t>& number) {
  std::vector<std::uint32_t> used;
  for (Corner& corner : part.corners) {
    std::uint32_t& i = corner.*index;
    if (i == no_index) continue;
    if (number[i] == no_index) {
      number[i] = std::uint32_t(used.size());
      used.push_back(i);
    }
    i = number[i];
  }
  to.reserve(used.size());
  for (std::uint32_t i : used) {
    to.push_back(from[i]);
    number[i] = no_index;
  }
}

std::string name_of(const FacesOfPart& part, bool several_materials) {
  if (part.object.empty()) return part.material;
  return several_materials && !part.material.empty() ? part.object + ":" + part.material : part.object;
}

}  // namespace

std::vector<ModelPart> make_parts(MeshData lists, std::vector<FacesOfPart> parts, const Materials& materials) {
  std::map<std::string, int> materials_of_object;
  for (const FacesOfPart& part : parts) ++materials_of_object[part.object];
  std::vector<std::uint32_t> number;
  if (parts.size() > 1)
    number.assign(std::max({lists.positions.size(), lists.normals.size(), lists.uvs.size()}), no_index);

  std::vector<ModelPart> out;
  for (FacesOfPart& part : parts) {
    MeshData& mesh = part.faces;
    if (parts.size() == 1) {
      mesh.positions = std::move(lists.positions);
      mesh.normals = std::move(lists.normals);
      mesh.uvs = std::move(lists.uvs);
    } else {
      take_used(mesh, &Corner::position, lists.positions, mesh.positions, number);
      take_used(mesh, &Corner::normal, lists.normals, mesh.normals, number);
      take_used(mesh, &Corner::uv, lists.uvs, mesh.uvs, number);
    }
    ModelPart made;
    made.name = parts.size() == 1 ? part.object : name_of(part, materials_of_object[part.object] > 1);
    if (const auto found = materials.find(part.material); found != materials.end()) made.material = found->second;
    made.mesh = Mesh::make(std::move(mesh));
    out.push_back(std::move(made));
  }
  make_names_unique(out);
  return out;
}

void make_names_unique(std::vector<ModelPart>& parts) {
  std::set<std::string> taken;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::string& name = parts[i].name;
    name = readable(name);
    if (parts.size() == 1) return;
    if (name.empty()) name = "part " + std::to_string(i + 1);
    const std::string base = name;
    for (std::size_t k = 2; !taken.insert(name).second; ++k) name = base + " " + std::to_string(k);
  }
}

Model single_part(MeshData mesh) {
  Model model;
  model.parts.push_back({.name = "", .mesh = Mesh::make(std::move(mesh)), .material = std::nullopt});
  return model;
}

}  // namespace cg
