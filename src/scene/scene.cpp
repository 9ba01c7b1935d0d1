#include "scene/scene.h"

namespace cg {

template Slots slots<Scene>(Scene&);

}  // namespace cg
