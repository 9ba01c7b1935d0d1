// Whatever a person names as a scene, opened.
#pragma once
#include <string>
#include <vector>

#include "workbench/model_library.h"

namespace cg {

// `what`: a lesson's step ("03-shading:2"), a shape's name, a model file, the name of a bundled model, or a preset
// (.json). Meshes are loaded. `notes`, if not null, gets what was odd about a model file. Throws InputError that says
// what would work.
Scene open_scene(const std::string& what, std::vector<Text>* notes = nullptr);

// Sets one parameter from text as it is typed after --set: "material.k_d=0.5". "lights.1.kind=spot" adds a light where
// there is one so far, and objects are added the same way. Meshes are not loaded again: load_meshes() does when all
// is set. Throws InputError.
void set_parameter(Scene& scene, const std::string& path_and_value);

}  // namespace cg
