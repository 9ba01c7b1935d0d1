// Radiosity solutions that measurements share: the numbers of a lesson's step ask for the same scene again and again.
#pragma once
#include <list>

#include "workbench/scene_radiosity.h"

namespace cg {

// Of one thread.
class SolvedScenes {
 public:
  // Solved where no scene with the same inputs is kept, with what the last solution leaves valid. Meshes are loaded.
  // The youngest are kept: 16 at most, and 256 MiB of form factors where there are several. Throws as solve_scene().
  SceneRadiosity of(const Scene& scene, Progress& progress);

 private:
  struct Kept {
    Scene inputs;  // radiosity_inputs()
    SceneRadiosity solved;
  };
  void forget();
  std::list<Kept> kept_;  // the youngest first
};

}  // namespace cg
