#include "shading/light_notes.h"

#include <cmath>
#include <string>

namespace cg {

std::vector<Text> light_notes(const Scene& scene) {
  std::vector<Text> notes;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& l = scene.lights[i];
    if (!l.enabled || l.kind == LightKind::directional || l.w == 0) continue;
    const std::string index = std::to_string(i);
    if (std::abs(l.w) < 1e-6)
      notes.push_back({"light " + index + " has a w next to 0: taken as directional",
                       "光源 " + index + " の w は 0 に近いので平行光源とみなす"});
    else if (l.k_0 == 0 && l.k_1 == 0 && l.k_2 == 0)
      notes.push_back({"light " + index + " has the attenuation 0, 0, 0, a division by zero: taken as 1, 0, 0",
                       "光源 " + index + " の減衰 0, 0, 0 はゼロ除算になるので 1, 0, 0 とみなす"});
  }
  return notes;
}

}  // namespace cg
