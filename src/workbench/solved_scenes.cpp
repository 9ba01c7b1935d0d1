#include "workbench/solved_scenes.h"

#include <algorithm>
#include <set>

namespace cg {

namespace {
constexpr std::size_t most_scenes = 16, most_bytes = std::size_t(256) << 20;
}

SceneRadiosity SolvedScenes::of(const Scene& scene, Progress& progress) {
  Scene inputs = radiosity_inputs(scene);
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) { return k.inputs == inputs; });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
    return kept_.front().solved;
  }
  const SceneRadiosity earlier = kept_.empty() ? SceneRadiosity{} : kept_.front().solved;
  const SceneRadiosity solved = solve_scene(scene, earlier, progress, 1);
  kept_.push_front({std::move(inputs), solved});
  forget();
  return solved;
}

// A matrix that several solutions share counts once.
void SolvedScenes::forget() {
  std::set<const FormFactorMatrix*> matrices;
  std::size_t bytes = 0, scenes = 0;
  const auto first = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) {
    const FormFactorMatrix* matrix = k.solved.solution->matrix.get();
    if (matrices.insert(matrix).second) bytes += matrix->bytes();
    return ++scenes > most_scenes || (scenes > 1 && bytes > most_bytes);
  });
  kept_.erase(first, kept_.end());
}

}  // namespace cg
