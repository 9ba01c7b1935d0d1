// Compiles the headers of this room that no other source of it includes.
#include "scene/technique.h"
