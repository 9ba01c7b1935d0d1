#include "measure/knob.h"
#include "measure/knob_list.h"
#include "params/input_error.h"

namespace cg {

std::span<const Knob> knobs() {
  static const std::vector<Knob> all{
      shading_knob(),
      terminator_knob(),
      normals_knob(),
      silhouette_knob(),
      precision_knob(),
      reflection_knob(),
      supersampling_knob(),
      multisampling_knob(),
      resolution_knob(),
      near_plane_knob(),
      z_fighting_knob(),
      radiosity_positions_knob(),
      radiosity_resolution_knob(),
      radiosity_rays_knob(),
      radiosity_patches_knob(),
      radiosity_method_knob(),
      radiosity_solver_knob(),
      radiosity_residual_knob(),
      radiosity_float_knob(),
  };
  return all;
}

const Knob& find_knob(std::string_view id) {
  std::string known;
  for (const Knob& knob : knobs()) {
    if (knob.id == id) return knob;
    known += (known.empty() ? "" : ", ") + std::string(knob.id);
  }
  throw InputError(id.empty() ? "KNOB" : std::string(id), {"there is no such knob", "そのような調整項目はない"},
                   {"known are: " + known, "あるのは " + known});
}

}  // namespace cg
