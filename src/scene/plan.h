// What a technique will do for one scene: the passes it runs, and those it leaves out and why.
// A renderer runs the plan's passes and no others.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "params/words.h"

namespace cg {

struct Pass {
  std::string id;  // "vertex-lighting"
  Words name;      // "Vertex lighting"
  bool needed = false;
  Text reason;            // why it runs, or why it is left out
  std::size_t bytes = 0;  // of what it keeps while it runs; 0 where it is left out
};

struct Plan {
  std::string technique;     // the id
  std::vector<Pass> passes;  // in the order in which they run
  std::vector<Text> notes;   // what a user should know: "OpenGL draws the first 8 of 9 lights"

  bool runs(std::string_view id) const {
    for (const Pass& p : passes)
      if (p.id == id) return p.needed;
    return false;
  }
};

}  // namespace cg
