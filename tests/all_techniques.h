// Every technique there is, for tests that walk them all.
#pragma once
#include <vector>

#include "gl/techniques.h"
#include "raster/software.h"

namespace cg {

// They live as long as the program: each has a context of its own.
inline const std::vector<Technique>& all_techniques() {
  static const std::vector<Technique> all = [] {
    std::vector<Technique> list = gl_techniques();
    for (Technique& t : list) find_availability(t);
    list.push_back(software_technique());
    return list;
  }();
  return all;
}

}  // namespace cg
