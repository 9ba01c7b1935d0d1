// Models by name: shapes, the bundled files, the user's files. Each mesh is read once and shared.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "params/words.h"
#include "scene/scene.h"

namespace cg {

// The names of the bundled model files ("cornell-box.obj"), sorted.
std::vector<std::string> bundled_models();

// The model that a person calls `name`, as Object::model keeps it: a shape's id ("teapot"); the name of a bundled file,
// also without its ".obj"; or the absolute path of a file that was named relative to `folder` (empty: the current one).
// In this order, but a file that exists in `folder` comes before a bundled one. Throws InputError that lists what there
// is.
std::string find_model(const std::string& name, const std::filesystem::path& folder = {});

// A scene with that model (as find_model returns it) alone, one object for each of its parts, meshes loaded, and the
// defaults for all else. A file's model is fitted into the unit ball about the origin. `notes`, if not null, gets what
// was odd about the file. Throws InputError.
Scene open_model(const std::string& model, std::vector<Text>* notes = nullptr);

// Gives every object the mesh that its model, part and tessellation stand for, and every layer of textures its picture
// (load_textures: a bad one is replaced by a placeholder), from a cache where the file has not changed. Throws
// InputError; the scene is unchanged then. May be called from any thread.
void load_meshes(Scene& scene);

// The transform that brings a ball of `radius` about `centre` into the unit ball about the origin, in short numbers:
// the scale in 3 significant digits, the translation in thousandths. Radius 0: only moved.
Transform fitting_transform(const glm::dvec3& centre, double radius);

}  // namespace cg
