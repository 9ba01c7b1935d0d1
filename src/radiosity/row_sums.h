// What the pixels or rays of one patch's positions add up to, made into a row of form factors.
#pragma once
#include "radiosity/form_factors.h"
#include "radiosity/item_scene.h"

namespace cg {

struct RowSums {
  std::vector<double> of_patch;       // 0 where the patch was not met
  TiledWeights::Rest rest;            // of what met no patch's front
  Horizon horizon;                    // of the plane that the positions are in
  std::vector<std::uint16_t> fronts;  // patches that a position sees from in front, if nothing is between

  // For positions in the plane of `part`, of patch `own`: that one is not seen.
  void begin(const ItemScene& scene, const Patch& part, std::uint32_t own);
  // The patch that lies on the position and takes all of its light, or no_item.
  std::uint32_t lying_on(const ItemScene& scene, const glm::dvec3& position);
  // `normalise`: divides by all light that met something, so that rows of a closed scene sum to 1 (to less where the
  // backs of patches take some).
  FormFactorRow finish(bool normalise) const;
};

}  // namespace cg
