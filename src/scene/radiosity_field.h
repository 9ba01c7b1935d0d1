// A radiosity solution as the techniques draw it: light that is the same from every direction, and so a property of the
// surface like its colour. Data only; src/radiosity/ computes it.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "math/vec.h"
#include "params/words.h"
#include "scene/mesh.h"

namespace cg {

// Of one object: its mesh cut into elements, and the light that each corner of an element sends back.
struct ObjectRadiosity {
  MeshHandle mesh;  // the elements, in the object's own coordinates: drawn in place of Object::mesh
  // Reflected radiosity over pi, B/pi - E, linear RGB, at least 0: one a corner of mesh->data().corners. It is what
  // stands in for I_a k_a; the material's emission is added by the light model as always. Corners of one position agree
  // where the light is continuous, and differ across an edge between planes.
  std::vector<glm::vec3> corners;
  // The Object::mesh that was cut: where the object has another one now, the field is not drawn. Null: not known.
  MeshHandle of = nullptr;
};

struct RadiosityField {
  std::vector<ObjectRadiosity> objects;  // one for each of Scene::objects; mesh null where the object takes no part
  std::uint64_t geometry = 0;            // geometry_key() of the scene that it was computed for
  Text summary;                          // "1250 patches, hemicube 128, Gauss-Seidel, residual 3e-7"
};

// Shared and never changed once it is made.
using RadiosityHandle = std::shared_ptr<const RadiosityField>;

}  // namespace cg
