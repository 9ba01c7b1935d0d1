// A model of several objects in materials of their own, as the program makes it.
#pragma once
#include <string>
#include <vector>

#include "scene/mesh.h"

namespace cg {

struct BundledMaterial {
  std::string name;
  glm::dvec3 reflectance;  // diffuse, linear sRGB
  glm::dvec3 emission;     // radiance, linear sRGB
};

struct BundledPart {
  std::string name;
  std::string material;  // the name of one of the scene's
  MeshData mesh;         // metres, y up
};

struct BundledScene {
  std::string name;  // of its files
  std::string comment;
  std::vector<BundledPart> parts;
  std::vector<BundledMaterial> materials;
  // Its preset: from where it is looked at once it is fitted into the unit ball, and how it is lit.
  glm::dvec3 eye{0, 0, 3}, target{0};
  double fov = 45;  // degrees, vertical
  double patch_size = 0.1;
  double exposure = 0;  // stops
};

}  // namespace cg
