// From what a reader collected to the parts of a Model.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/model_file.h"

namespace cg {

// The faces of one object in one material. Its corners index the lists of the whole file.
struct FacesOfPart {
  std::string object, material;  // as in the file; empty where it has none
  MeshData faces;                // corners and first_corner only
};

// Makes a mesh of each part, with the positions, normals and uvs that it uses in the order of their first use. A
// single part keeps the lists as they are. A part's material is the one of its name, none where there is none.
std::vector<ModelPart> make_parts(MeshData lists, std::vector<FacesOfPart> parts, const Materials& materials);

// Makes the names readable, non-empty and different from each other, so that a part can be found by its name. The
// name of a single part may stay empty.
void make_names_unique(std::vector<ModelPart>& parts);

// A model of one unnamed part.
Model single_part(MeshData mesh);

}  // namespace cg
