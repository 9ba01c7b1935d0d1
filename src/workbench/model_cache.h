// Meshes read or made once and shared by all scenes that hold them. What comes from here is what reading the file again
// would give; nothing is kept that no scene holds. All functions may be called from any thread and throw InputError.
#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "scene/model.h"
#include "scene/shape.h"

namespace cg {

// The model in a file, read again when the file has changed.
std::shared_ptr<const Model> model_in(const std::filesystem::path& file);

// One part of it by name; empty: the whole, as one mesh. `where` names the object in errors.
MeshHandle mesh_in(const std::filesystem::path& file, const std::string& part, const std::string& where);

MeshHandle mesh_of(const Shape& shape, int level);

}  // namespace cg
