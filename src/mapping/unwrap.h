// Manual mapping: a mesh cut along seams and laid flat.
#pragma once
#include "mapping/uv_layout.h"

namespace cg {

// Cuts the mesh along the marked seams and, if it may, along others of its own; opens what is no disk; lays each chart
// flat with the area it has on the surface; packs them into the unit square. With seams of its own, no chart has
// flipped triangles or overlaps itself. Throws InputError, with `where` as the place, for a mesh with an edge of three
// faces or more, or without any face.
UvLayout unwrap(const MeshHandle& mesh, const Unwrapping& options, const std::string& where = "");

// Lays the charts of a layout into the unit square again, each with the area that it has on the surface.
UvLayout pack_again(const UvLayout& layout, const Unwrapping& options);

}  // namespace cg
