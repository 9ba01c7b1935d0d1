// What of a probed pixel is drawn into a picture, or into the world seen from outside.
#pragma once
#include <imgui.h>

#include <functional>

#include "ui/probe_jobs.h"
#include "workbench/picking.h"
#include "workbench/probe_lines.h"

namespace cg {

struct App;

// The light whose factors and vectors are shown: the selected one, where it shines; -1: none does.
int probed_light(const App& app, const LitPoint& point);

// The vectors of the point whose factors are shown, `length` of the height of what the camera sees at its target.
std::vector<ProbedVector> vectors_of(const App& app, const Probe& probe, const Camera& camera, double length = 0.2);

// Appends those vectors, and the triangle with Gouraud shading.
void add_probe_lines(const App& app, const Probed& probed, const Camera& camera, double length,
                     std::vector<Lines>& out);

// Tips and letters of the vectors, over their lines.
void paint_letters(App& app, const std::vector<ProbedVector>& vectors, const PictureProjection& projection,
                   const std::function<ImVec2(const glm::dvec2&)>& to_screen);

}  // namespace cg
