#include "radiosity/field.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "radiosity/elements.h"
#include "radiosity/faces.h"
#include "radiosity/seams.h"

namespace cg {

namespace {

using Index = std::uint32_t;

// The elements of one object as a mesh, vertices numbered anew in the order of their first use.
class ObjectElements {
 public:
  ObjectElements(const std::vector<ElementVertex>& vertices, const SeamedOutlines& outlines)
      : vertices_(vertices), outlines_(outlines), number_(vertices.size(), no_index) {}

  void add(Index element, bool mirrored) {
    face_.clear();
    for (Index i = outlines_.first[element]; i < outlines_.first[element + 1]; ++i) {
      const Index v = outlines_.vertex[i];
      Index& n = number_[v];
      if (n == no_index) {
        n = Index(data_.positions.size());
        data_.positions.push_back(vertices_[v].local);
        data_.normals.push_back(vertices_[v].normal);
        used_.push_back(v);
        has_normals_ = has_normals_ || data_.normals.back() != glm::dvec3(0);
      }
      face_.push_back({.position = n, .normal = data_.normals[n] == glm::dvec3(0) ? no_index : n});
    }
    if (mirrored) std::reverse(face_.begin(), face_.end());
    data_.add_face(face_.data(), face_.data() + face_.size());
  }

  // Leaves it ready for the next object. `corners` gets the vertex of each corner.
  MeshHandle take(std::vector<Index>& corners) {
    if (!has_normals_) data_.normals.clear();
    has_normals_ = false;
    MeshHandle mesh = Mesh::make(std::exchange(data_, {}));
    for (const Corner& c : mesh->data().corners) corners.push_back(used_[c.position]);
    for (const Index v : used_) number_[v] = no_index;
    used_.clear();
    return mesh;
  }

 private:
  const std::vector<ElementVertex>& vertices_;
  const SeamedOutlines& outlines_;
  std::vector<Index> number_, used_;
  MeshData data_;
  std::vector<Corner> face_;
  bool has_normals_ = false;
};

}  // namespace

FieldMeshes::FieldMeshes(const Scene& scene, std::shared_ptr<const Patches> patches)
    : patches_(std::move(patches)), outlines_(outlines_of(*patches_)) {
  SeamedOutlines seamed = with_seams(*patches_, outlines_);
  std::vector<ElementVertex> vertices = patches_->vertices;
  for (const HangingVertex& seam : seamed.seams) {
    const ElementVertex &a = vertices[seam.a], &b = vertices[seam.b];
    const auto mix = [&](const glm::dvec3& p, const glm::dvec3& q) { return p + seam.t * (q - p); };
    vertices.push_back({mix(a.position, b.position), mix(a.local, b.local), mix(a.normal, b.normal), a.surface});
  }
  objects_.resize(scene.objects.size());
  ObjectElements elements(vertices, seamed);
  for (Index e = 0; e < patches_->elements.size(); ++e) {
    const Index object = patches_->patches[patches_->elements[e].patch].object;
    elements.add(e, mirrors(scene.objects[object].transform));
    const bool last =
        e + 1 == patches_->elements.size() || patches_->patches[patches_->elements[e + 1].patch].object != object;
    if (!last) continue;
    objects_[object].mesh = elements.take(objects_[object].vertex);
    objects_[object].of = scene.objects[object].mesh;
  }
  seams_ = std::move(seamed.seams);
}

RadiosityField FieldMeshes::field(std::span<const glm::dvec3> light, std::uint64_t geometry) const {
  std::vector<glm::dvec3> values = vertex_values(*patches_, outlines_, light);
  for (const HangingVertex& seam : seams_)
    values.push_back(values[seam.a] + seam.t * (values[seam.b] - values[seam.a]));
  RadiosityField out;
  out.geometry = geometry;
  for (const Part& part : objects_) {
    ObjectRadiosity& object = out.objects.emplace_back();
    object.mesh = part.mesh, object.of = part.of;
    object.corners.reserve(part.vertex.size());
    for (const Index v : part.vertex) object.corners.emplace_back(glm::max(values[v], glm::dvec3(0)));
  }
  return out;
}

RadiosityField field_of(const Scene& scene, const Patches& patches, std::span<const glm::dvec3> element_radiosity,
                        std::uint64_t geometry) {
  std::vector<glm::dvec3> reflected(element_radiosity.begin(), element_radiosity.end());
  for (Index e = 0; e < reflected.size(); ++e) reflected[e] -= patches.patches[patches.elements[e].patch].emission;
  // The patches are there as long as this call: nobody has to own them.
  return FieldMeshes(scene, {std::shared_ptr<void>(), &patches}).field(reflected, geometry);
}

}  // namespace cg
