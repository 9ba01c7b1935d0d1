// Each knob's maker, one a file; knobs.cpp lists them.
#pragma once
#include "measure/knob.h"

namespace cg {

Knob shading_knob();
Knob terminator_knob();
Knob silhouette_knob();
Knob normals_knob();
Knob precision_knob();
Knob reflection_knob();
Knob supersampling_knob();
Knob multisampling_knob();
Knob resolution_knob();
Knob near_plane_knob();
Knob z_fighting_knob();
Knob radiosity_positions_knob();
Knob radiosity_resolution_knob();
Knob radiosity_rays_knob();
Knob radiosity_patches_knob();
Knob radiosity_residual_knob();
Knob radiosity_method_knob();
Knob radiosity_solver_knob();
Knob radiosity_float_knob();

}  // namespace cg
