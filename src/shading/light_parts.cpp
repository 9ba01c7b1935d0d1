#include "shading/light_parts.h"

namespace cg {

namespace {

template <class Real>
bool some(const Vec3<Real>& c) {
  return c != Vec3<Real>(Real(0));  // NaN is something
}

}  // namespace

LightParts& LightParts::operator|=(const LightParts& o) {
  emission |= o.emission, ambient |= o.ambient, radiosity |= o.radiosity;
  light_ambient |= o.light_ambient, diffuse |= o.diffuse, specular |= o.specular;
  point |= o.point, directional |= o.directional, attenuation |= o.attenuation, spot |= o.spot;
  return *this;
}

template <class Real>
LightParts light_parts(const EyeLight<Real>& light, const EyeMaterial<Real>& m) {
  LightParts p;
  p.light_ambient = some<Real>(light.ambient * m.k_a);
  p.diffuse = some<Real>(light.diffuse * m.k_d);
  p.specular = some<Real>(light.specular * m.k_s);
  if (!p.lit()) return p;
  // 0, 0, 0 is taken as 1, 0, 0.
  const bool plain = (light.k_0 == Real(1) || light.k_0 == Real(0)) && light.k_1 == Real(0) && light.k_2 == Real(0);
  p.attenuation = !light.directional && !plain;
  p.spot = light.spot_cosine > Real(-2);
  const bool direction = p.normal() || p.attenuation || p.spot;
  p.directional = direction && light.directional;
  p.point = direction && !light.directional;
  return p;
}

template <class Real>
LightParts light_parts(const EyeLighting<Real>& lighting, const EyeMaterial<Real>& m) {
  LightParts all;
  for (const EyeLight<Real>& light : lighting.lights) all |= light_parts(light, m);
  all.emission = some<Real>(m.emission);
  all.ambient = some<Real>(lighting.ambient * m.k_a);
  return all;
}

template LightParts light_parts(const EyeLight<float>&, const EyeMaterial<float>&);
template LightParts light_parts(const EyeLight<double>&, const EyeMaterial<double>&);
template LightParts light_parts(const EyeLighting<float>&, const EyeMaterial<float>&);
template LightParts light_parts(const EyeLighting<double>&, const EyeMaterial<double>&);

}  // namespace cg
