#include "radiosity/form_factors.h"

#include "radiosity/hemicube_rows.h"
#include "radiosity/ray_rows.h"
#include "radiosity/unoccluded_rows.h"

namespace cg {

std::vector<ItemPolygon> item_polygons(const Patches& patches) {
  std::vector<ItemPolygon> polygons;
  polygons.reserve(patches.patches.size());
  for (const Patch& p : patches.patches)
    polygons.push_back({p.corner[0], p.corner[1], p.corner[2], p.corner[p.corners == 3 ? 2 : 3]});
  return polygons;
}

InputError no_opengl_for_hemicubes() {
  return InputError("radiosity.item_buffer",
                    {"there is no OpenGL here to draw hemicubes", "ここではヘミキューブを描く OpenGL が使えない"},
                    {"software", "software"});
}

namespace {

template <class Rows>
FormFactorMethod method_of(const Patches& patches, std::shared_ptr<const Rows> rows) {
  return {[&patches, rows](std::uint32_t patch, const Progress& progress) {
            return rows->row(patches.patches[patch], patch, progress);
          },
          [rows](const Patch& part, std::uint32_t own, const Progress& progress) {
            return rows->row(part, own, progress);
          }};
}

// The rows, and the polygons that they are made of.
template <class Rows>
struct WithPolygons {
  std::vector<ItemPolygon> polygons;
  Rows rows;
  template <class... Options>
  WithPolygons(std::vector<ItemPolygon> p, const Options&... options)
      : polygons(std::move(p)), rows(polygons, options...) {}
  FormFactorRow row(const Patch& part, std::uint32_t own, const Progress& progress) const {
    return rows.row(part, own, progress);
  }
};

}  // namespace

FormFactorMethod form_factor_method(const Patches& patches, const Radiosity& options, const MakeDrawItems& gl) {
  const bool normalise = patches.closed && options.normalise != Normalise::none;
  switch (options.form_factors) {
    case FormFactors::closed_form:
    case FormFactors::nusselt:
      return method_of(patches, std::make_shared<const UnoccludedRows>(patches, options, normalise));
    case FormFactors::hemicube:
      break;
    case FormFactors::monte_carlo:
      return method_of(patches,
                       std::make_shared<const WithPolygons<RayRows>>(item_polygons(patches), options, normalise));
  }
  const bool by_gl = options.item_buffer == ItemBuffer::gl;
  if (by_gl && !gl) throw no_opengl_for_hemicubes();
  return method_of(patches, std::make_shared<const WithPolygons<HemicubeRows>>(
                                item_polygons(patches), options, normalise, by_gl ? gl : MakeDrawItems{}));
}

}  // namespace cg
