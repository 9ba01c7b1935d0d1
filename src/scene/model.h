// What a model file or a shape comes to: its objects, each with a mesh and, where it has one, a material.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "params/input_error.h"
#include "scene/material.h"
#include "scene/mesh.h"

namespace cg {

struct ModelPart {
  std::string name;  // of the OBJ's `o` (or `g`); empty where the file has none
  MeshHandle mesh;   // never null
  std::optional<Material> material;
};

struct Model {
  std::vector<ModelPart> parts;  // at least one
  std::vector<Text> notes;       // what was odd but not wrong: "the material file wood.mtl is missing"
};

}  // namespace cg
