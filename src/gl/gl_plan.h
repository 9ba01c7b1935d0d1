// What the OpenGL techniques run for one scene, what they leave out, and why.
#pragma once
#include <optional>

#include "scene/frame.h"
#include "scene/plan.h"
#include "scene/scene.h"

namespace cg {

Plan gl_plan(const Scene& scene, const View& view);
Plan gl_fixed_plan(const Scene& scene, const View& view);

// Why the fixed function cannot draw the scene: it has neither Phong shading nor R.V.
std::optional<Text> unsupported_by_fixed_function(const Scene& scene);

}  // namespace cg
