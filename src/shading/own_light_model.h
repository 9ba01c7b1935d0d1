// The light model of a student's own, in C, as the listing and the exported program show it where a mistake cannot be
// made with glLight (lights_by_hand). It is the file shading/c/own_light_model.c: gl-fixed compiles it, so that what is
// shown is what is drawn. It needs <math.h> and the OpenGL header.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/mistakes.h"

namespace cg {

struct SourceLine {
  std::string text;
  std::string_view mistake = {};  // this is the guilty line: the name of the member of Mistakes
  bool missing = false;           // the mistake is that this line is not there: not in the program
  friend bool operator==(const SourceLine&, const SourceLine&) = default;
};

// The functions read_lights() (before each mesh) and shade( vertex, normal ) with the mistakes in them, and the
// functions and variables that these need. C89.
std::vector<SourceLine> own_light_model(const Mistakes& mistakes);

}  // namespace cg
