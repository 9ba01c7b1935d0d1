#include "workbench/patch_lines.h"

namespace cg {

Lines patch_lines(const Patch& patch, Mark mark) {
  Lines out{mark, patch.centre, {}};
  for (int i = 0; i < patch.corners; ++i)
    for (const int k : {i, (i + 1) % patch.corners})
      out.points.emplace_back(patch.corner[std::size_t(k)] - patch.centre);
  return out;
}

}  // namespace cg
