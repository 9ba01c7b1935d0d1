#include "raster/pixel_shading.h"

#include "raster/layered_pixels.h"
#include "raster/pixel_kinds.h"

namespace cg {

namespace {

template <class Real, bool with_B, class Shade>
void shade_phong(const DeferredShading<Real>& shading, const Shade& shade) {
  if (shading.uses_position)
    return shading.uses_normal ? shade(shade_rows<Real, PhongPixels<Real, true, true, with_B>>)
                               : shade(shade_rows<Real, PhongPixels<Real, true, false, with_B>>);
  return shading.uses_normal ? shade(shade_rows<Real, PhongPixels<Real, false, true, with_B>>)
                             : shade(shade_rows<Real, PhongPixels<Real, false, false, with_B>>);
}

}  // namespace

template <class Real>
void shade_pixels(const Drawing& drawing, const VisibilityBuffer& visibility, const DeferredShading<Real>& shading,
                  const glm::vec3& background, Workers& workers, Frame& frame) {
  const auto shade = [&](const auto& rows) { rows(drawing, visibility, shading, background, workers, frame); };
  if constexpr (only_plain) {
    if (shading.mode == ShadingMode::phong) return shade(shade_rows<Real, PhongPixels<Real, false, true, false>>);
    return shade(shade_rows<Real, ColourPixels<Real, GouraudTriangle<Real>>>);
  }
  if (shading.uses_layers) return shade(shade_layered_pixels<Real>);
  switch (shading.mode) {
    case ShadingMode::flat:
      return shade(shade_rows<Real, ColourPixels<Real, FlatTriangle<Real>>>);
    case ShadingMode::gouraud:
      return shade(shade_rows<Real, ColourPixels<Real, GouraudTriangle<Real>>>);
    case ShadingMode::phong:
      return shading.uses_radiosity ? shade_phong<Real, true>(shading, shade)
                                    : shade_phong<Real, false>(shading, shade);
  }
}

template void shade_pixels(const Drawing&, const VisibilityBuffer&, const DeferredShading<float>&, const glm::vec3&,
                           Workers&, Frame&);
template void shade_pixels(const Drawing&, const VisibilityBuffer&, const DeferredShading<double>&, const glm::vec3&,
                           Workers&, Frame&);

}  // namespace cg
