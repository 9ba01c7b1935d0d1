// F_ij, the share of the light leaving patch i that falls on patch j: rows of a matrix, by any method.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "radiosity/patches.h"

namespace cg {

// One entry of a sparse row.
struct FormFactor {
  std::uint32_t patch;
  float value;
};

// A row as a method gives it: entries of distinct patches in ascending order, values > 0; nothing for itself.
struct FormFactorRow {
  std::vector<FormFactor> factors;
  double sum = 0;            // of the factors before they were normalised
  std::uint32_t missed = 0;  // patches in front that no pixel or ray of any position met
};

// A method, made once for a scene. Both are called from several threads at once, depend on their first arguments alone,
// and throw Cancelled within 100 ms of Progress::cancelled (whose fraction is the caller's).
struct FormFactorMethod {
  std::function<FormFactorRow(std::uint32_t patch, const Progress& progress)> row;
  // What a part of patch `own` sees of all patches: an element, given as a polygon of its own.
  std::function<FormFactorRow(const Patch& part, std::uint32_t own, const Progress& progress)> part_row;
};

// By options.form_factors; uses item_buffer, resolution, samples, placement, rays, weight and normalise. The patches
// must outlive it.
FormFactorMethod form_factor_method(const Patches& patches, const Radiosity& options);

}  // namespace cg
