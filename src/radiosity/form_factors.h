// F_ij, the share of the light leaving patch i that falls on patch j: rows of a matrix, by any method.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "params/input_error.h"
#include "radiosity/patches.h"
#include "scene/item_drawer.h"

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

// By options.form_factors; uses item_buffer, resolution, samples, placement, rays, weight and normalise. `gl` draws the
// item buffers where item_buffer says so. The patches must outlive it. A surface is seen from its front; its back takes
// light and gives none. Throws InputError where OpenGL is asked for and `gl` is null.
FormFactorMethod form_factor_method(const Patches& patches, const Radiosity& options, const MakeDrawItems& gl = {});

// The patches as what is drawn into item buffers.
std::vector<ItemPolygon> item_polygons(const Patches& patches);
// What is thrown where OpenGL is asked for and not there.
InputError no_opengl_for_hemicubes();

}  // namespace cg
