// Which parts of the light model a scene's lights and materials use at all: what is not used is neither run nor
// compiled.
#pragma once
#include "shading/light_model.h"

namespace cg {

struct LightParts {
  bool emission = false, ambient = false;  // E, and I_a k_a of the global ambient light
  bool radiosity = false;                  // a solution that stands in for I_a k_a and the lights' I_ai k_a
  // Some light has I_ai k_a, I_di k_d, I_si k_s.
  bool light_ambient = false, diffuse = false, specular = false;
  // Among the lights that have one of these: their kinds, where the direction to the light counts.
  bool point = false, directional = false, attenuation = false, spot = false;

  bool lit() const { return light_ambient || diffuse || specular; }
  bool normal() const { return diffuse || specular; }
  // The place in eye space; V needs it where the viewer is local.
  bool position(bool local_viewer) const { return point || (specular && local_viewer); }
  LightParts& operator|=(const LightParts& other);
};

// What `light` adds on the material; nothing at all where a product of colours is 0 in all three components.
template <class Real>
LightParts light_parts(const EyeLight<Real>& light, const EyeMaterial<Real>& material);
template <class Real>
LightParts light_parts(const EyeLighting<Real>& lighting, const EyeMaterial<Real>& material);

}  // namespace cg
