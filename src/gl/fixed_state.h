// Which parts of the light model OpenGL's own state switches on at a draw: what the fixed function then computes.
#pragma once
#include "scene/pass_recorder.h"

namespace cg {

// Asks OpenGL for its lights and its material. Records the parts under the ids of the plan, and "color-material".
void record_fixed_state(PassRecorder& record);

}  // namespace cg
