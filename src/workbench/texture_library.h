// The pictures of textures by name: those that come with the program, and the user's files. Each is read once and
// shared, and again when its file has changed.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "params/input_error.h"
#include "scene/scene.h"

namespace cg {

// The names of the bundled pictures ("brick-colour.png"), sorted.
std::vector<std::string> bundled_textures();

// The picture that a person calls `name`, as TextureLayer::image keeps it: the name of a bundled one, also without its
// ".png", or the absolute path of a file that was named relative to `folder` (empty: the current one). A file that
// exists in `folder` comes before a bundled one. What does not exist keeps its place, so that nothing is lost where a
// disk is missing.
std::string find_texture(const std::string& name, const std::filesystem::path& folder = {});

// Gives every layer the picture that its name and encoding stand for. In the place of one that cannot be read stands
// TextureImage::placeholder(); why is added to `bad`, if not null. Layers without a name are left as they are. May be
// called from any thread.
void load_textures(Scene& scene, std::vector<InputError>* bad = nullptr);

}  // namespace cg
