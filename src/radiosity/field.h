// A solution as the techniques draw it.
#pragma once
#include <memory>
#include <span>

#include "radiosity/elements.h"
#include "scene/radiosity_field.h"

namespace cg {

// The elements of each object as a mesh, made once: many states of one solution are drawn on the same meshes.
class FieldMeshes {
 public:
  // The patches were made of `scene`.
  FieldMeshes(const Scene& scene, std::shared_ptr<const Patches> patches);

  // `light`: what each element is to look like beside its emission (over pi); less than 0 is drawn as 0. `summary` is
  // left empty.
  RadiosityField field(std::span<const glm::dvec3> light, std::uint64_t geometry) const;

 private:
  struct Part {
    MeshHandle mesh, of;
    std::vector<std::uint32_t> vertex;  // of each corner
  };
  std::shared_ptr<const Patches> patches_;
  Outlines outlines_;
  std::vector<HangingVertex> seams_;
  std::vector<Part> objects_;
};

// The same of `element_radiosity`, B/pi by element: what is reflected of it.
RadiosityField field_of(const Scene& scene, const Patches& patches, std::span<const glm::dvec3> element_radiosity,
                        std::uint64_t geometry);

}  // namespace cg
