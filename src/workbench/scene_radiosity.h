// The radiosity solution that a scene's ambient term asks for: solved before a command's picture, or behind the window,
// with what an earlier solution leaves valid.
#pragma once
#include "radiosity/solution.h"
#include "scene/scene.h"

namespace cg {

struct SceneRadiosity {
  SolutionHandle solution;  // null: there is none
  RadiosityHandle field;    // the same as it is drawn
};

inline bool wants_radiosity(const Scene& scene) { return scene.shading.ambient_source == AmbientSource::radiosity; }

// The scene with no more than the solution depends on: two scenes have the same solution where these are equal. The
// camera is not in it, nor are the lights. Cheap: meshes are handles.
Scene radiosity_inputs(const Scene& scene);

// Whether a solution of `a` may be drawn in `b`: their objects stand where they stood.
bool same_places(const Scene& a, const Scene& b);

// Solves; meshes are loaded. `gl` draws the hemicubes where the scene's item buffer is OpenGL's. Throws Cancelled, and
// InputError as solve_radiosity(), or where OpenGL is asked for and not there.
SceneRadiosity solve_scene(const Scene& scene, const SceneRadiosity& earlier, Progress& progress, int threads,
                           const MakeDrawItems& gl = {});

// What took how long and what was kept, a line each.
std::vector<Text> report_of(const RadiositySolution& solution);

}  // namespace cg
