// Which passes the software pipeline runs for a scene, and why.
#pragma once
#include "scene/technique.h"

namespace cg {

Plan software_plan(const Scene& scene, const View& view);

}  // namespace cg
