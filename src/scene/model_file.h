// The strict readers of model files. Each gives a mesh that agrees with its file or throws one InputError with the
// line (text) or byte (binary); nothing is dropped or shifted. What is left out because Shadebench does not draw it
// (lines, points, vertex colours) is said in Model::notes. Positions and normals are read as double.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "scene/model.h"

namespace cg {

using Materials = std::map<std::string, Material, std::less<>>;

// Finds the material file that an OBJ's `mtllib` names and reads it. What is missing or wrong is said in `notes`:
// a mesh opens without its materials.
using MtlLoader = std::function<Materials(std::string_view name, std::vector<Text>& notes)>;

// Reads OBJ (and its MTL files, from the same folder or below it), PLY, OFF or STL. The extension decides; where it
// is another, the first bytes do. Throws InputError.
Model read_model(const std::filesystem::path& file);

// The same from bytes in memory; `where` is the file's name in messages. `load_mtl` may be empty.
Model read_obj(std::string_view bytes, const std::string& where, const MtlLoader& load_mtl);
Model read_ply(std::string_view bytes, const std::string& where);
Model read_off(std::string_view bytes, const std::string& where);
Model read_stl(std::string_view bytes, const std::string& where);

// The materials of an MTL file. Values outside what a Material takes are limited, and statements that have no
// counterpart (texture maps) left out, with a note. Throws InputError.
Materials read_mtl(std::string_view bytes, const std::string& where, std::vector<Text>& notes);

}  // namespace cg
