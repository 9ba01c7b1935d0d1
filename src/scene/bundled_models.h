// The files of models/: what the program ships, made by itself.
#pragma once
#include <string>
#include <vector>

namespace cg {

struct BundledFile {
  std::string name;  // "torus.obj"
  std::string text;
};

// Every shape at its own level; the Cornell box and the scenes for radiosity, each with its materials and a preset; and
// SOURCES.md with the origin of each.
std::vector<BundledFile> bundled_models();

}  // namespace cg
