// What a technique will do for one scene: the passes it runs, and those it leaves out and why.
// A renderer runs the plan's passes and no others, and records what it did (Frame::passes).
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "params/words.h"

namespace cg {

enum class PassKind {
  pass,     // work, one after the other
  part,     // code within a pass: a term of the light model, a kind of light
  resource  // memory that several passes use, or that is kept for the next picture
};

struct Pass {
  std::string id;  // "vertex-lighting"
  Words name;      // "Vertex lighting"
  bool needed = false;
  Text reason;              // why it runs, or why it is left out
  std::size_t bytes = 0;    // of what it holds; 0 where it is left out. Lists of objects and lights are not counted
  bool bytes_open = false;  // how many, only the drawing tells: `bytes` is 0
  PassKind kind = PassKind::pass;
};

struct Plan {
  std::string technique;               // the id
  std::vector<Pass> passes;            // in the order in which they run
  std::vector<Text> notes;             // what a user should know: "OpenGL draws the first 8 of 9 lights"
  std::vector<std::string> code = {};  // the programs that are compiled, each as the parts that are in it

  const Pass* find(std::string_view id) const {
    for (const Pass& p : passes)
      if (p.id == id) return &p;
    return nullptr;
  }
  bool runs(std::string_view id) const {
    const Pass* pass = find(id);
    return pass && pass->needed;
  }
};

}  // namespace cg
