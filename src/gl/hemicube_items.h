// Hemicubes' item buffers by OpenGL: which patch each pixel sees, drawn off screen into 32-bit integers, so that
// nothing blends, dithers or smooths a number into another.
#pragma once
#include "scene/item_drawer.h"

namespace cg {

// With a thread and a context of its own for each scene, made when the first hemicube is drawn; positions drawn at the
// same time wait for each other. What it returns throws InputError where there is no OpenGL.
MakeDrawItems gl_draw_items();

}  // namespace cg
