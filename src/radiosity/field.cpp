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
  ObjectElements(const std::vector<ElementVertex>& vertices, const SeamedOutlines& outlines,
                 const std::vector<glm::dvec3>& values)
      : vertices_(vertices), outlines_(outlines), values_(values), number_(vertices.size(), no_index) {}

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

  // Leaves it ready for the next object.
  ObjectRadiosity take(MeshHandle of) {
    ObjectRadiosity out;
    if (!has_normals_) data_.normals.clear();
    has_normals_ = false;
    out.mesh = Mesh::make(std::exchange(data_, {}));
    out.of = std::move(of);
    for (const Corner& c : out.mesh->data().corners)
      out.corners.emplace_back(glm::max(values_[used_[c.position]], glm::dvec3(0)));
    for (const Index v : used_) number_[v] = no_index;
    used_.clear();
    return out;
  }

 private:
  const std::vector<ElementVertex>& vertices_;
  const SeamedOutlines& outlines_;
  const std::vector<glm::dvec3>& values_;
  std::vector<Index> number_, used_;
  MeshData data_;
  std::vector<Corner> face_;
  bool has_normals_ = false;
};

}  // namespace

RadiosityField field_of(const Scene& scene, const Patches& patches, std::span<const glm::dvec3> element_radiosity,
                        std::uint64_t geometry) {
  std::vector<glm::dvec3> reflected(element_radiosity.begin(), element_radiosity.end());
  for (Index e = 0; e < reflected.size(); ++e) reflected[e] -= patches.patches[patches.elements[e].patch].emission;
  const Outlines outlines = outlines_of(patches);
  std::vector<glm::dvec3> values = vertex_values(patches, outlines, reflected);
  const SeamedOutlines seamed = with_seams(patches, outlines);
  std::vector<ElementVertex> vertices = patches.vertices;
  for (const HangingVertex& seam : seamed.seams) {
    const ElementVertex &a = vertices[seam.a], &b = vertices[seam.b];
    const auto mix = [&](const glm::dvec3& p, const glm::dvec3& q) { return p + seam.t * (q - p); };
    vertices.push_back({mix(a.position, b.position), mix(a.local, b.local), mix(a.normal, b.normal), a.surface});
    values.push_back(mix(values[seam.a], values[seam.b]));
  }
  RadiosityField field;
  field.geometry = geometry;
  field.objects.resize(scene.objects.size());
  ObjectElements elements(vertices, seamed, values);
  for (Index e = 0; e < patches.elements.size(); ++e) {
    const Index object = patches.patches[patches.elements[e].patch].object;
    elements.add(e, mirrors(scene.objects[object].transform));
    const bool last =
        e + 1 == patches.elements.size() || patches.patches[patches.elements[e + 1].patch].object != object;
    if (last) field.objects[object] = elements.take(scene.objects[object].mesh);
  }
  return field;
}

}  // namespace cg
