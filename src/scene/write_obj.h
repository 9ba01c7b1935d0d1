// Meshes as OBJ text (Alias|Wavefront, Advanced Visualizer Manual, appendix B1): numbers as the shortest text that
// reads back the same.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "scene/mesh.h"

namespace cg {

struct ObjPart {
  std::string_view name;      // of the `o`; none if empty
  std::string_view material;  // of the `usemtl`; none if empty
  const MeshData* mesh;       // not null
};

// `comment` stands in the first lines, each after "# "; `mtllib` is the material file's name, or empty.
std::string obj_text(std::span<const ObjPart> parts, std::string_view comment, std::string_view mtllib = {});

}  // namespace cg
