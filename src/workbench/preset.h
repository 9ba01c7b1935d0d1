// A scene as a file: JSON with only what differs from its model opened afresh, in the paths of slots().
//   {"schema": 1, "model": "teapot", "material": {"k_d": [1, 0, 0]}, "lights": {"1": {"kind": "spot"}}}
// Lists are objects with index keys, so that a merge patch (RFC 7396) can change one value. An index one beyond the
// list adds an item ({"1": {}} adds a light); null takes one away.
#pragma once
#include <filesystem>
#include <string>

#include "params/tree.h"
#include "scene/scene.h"

namespace cg {

// Model files in `folder` or below are named relative to it; empty: by their absolute path.
Tree preset_of(const Scene& scene, const std::filesystem::path& folder = {});

// Model files are looked for in `folder` first. Meshes are loaded. Throws InputError that begins with `where`, names
// the key and lists what is known.
Scene scene_of(const Tree& preset, const std::string& where, const std::filesystem::path& folder = {});

void save_preset(const Scene& scene, const std::filesystem::path& file);
Scene read_preset(const std::filesystem::path& file);

}  // namespace cg
