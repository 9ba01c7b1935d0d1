#include "shading/light_model.h"

namespace cg {

namespace {

constexpr double smallest_w = 1e-6;

template <class Real>
std::optional<EyeLight<Real>> in_eye_space(const Light& light, int index, const glm::dmat4& view) {
  const double w = light.kind == LightKind::directional ? 0 : light.w;
  EyeLight<Real> out{};
  out.index = index;
  out.directional = std::abs(w) < smallest_w;
  out.ambient = Vec3<Real>(light.ambient);
  out.diffuse = Vec3<Real>(light.diffuse);
  out.specular = Vec3<Real>(light.specular);
  if (out.directional) {
    out.position = Vec3<Real>(unit(glm::dvec3(view * glm::dvec4(light.position, 0))));
    if (out.position == Vec3<Real>(Real(0))) return std::nullopt;
  } else {
    out.position = Vec3<Real>(glm::dvec3(view * glm::dvec4(light.position / w, 1)));
    out.k_0 = Real(light.k_0), out.k_1 = Real(light.k_1), out.k_2 = Real(light.k_2);
  }
  out.spot_cosine = Real(-2);
  if (light.kind == LightKind::spot && light.cutoff != 180) {
    out.spot_direction = Vec3<Real>(unit(glm::dvec3(view * glm::dvec4(light.direction, 0))));
    // cos(90°) is 0, not 6e-17: the boundary of the half-space must not depend on the precision.
    out.spot_cosine = light.cutoff == 90 ? Real(0) : Real(std::cos(radians(light.cutoff)));
    out.spot_exponent = Real(light.exponent);
  }
  const bool finite =
      is_finite(out.position) && is_finite(out.ambient) && is_finite(out.diffuse) && is_finite(out.specular);
  return finite ? std::optional(out) : std::nullopt;
}

}  // namespace

template <class Real>
EyeLighting<Real> lighting_in_eye_space(const Scene& scene, const glm::dmat4& view) {
  EyeLighting<Real> out{Vec3<Real>(scene.shading.ambient), {},
                        scene.shading.reflection,          scene.shading.local_viewer,
                        scene.shading.two_sided,           scene.shading.clamp};
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (scene.lights[i].enabled)
      if (auto light = in_eye_space<Real>(scene.lights[i], int(i), view)) out.lights.push_back(*light);
  return out;
}

template <class Real>
EyeMaterial<Real> eye_material(const Material& m, ColorMaterial tracked) {
  EyeMaterial<Real> out{Vec3<Real>(m.k_a), Vec3<Real>(m.k_d), Vec3<Real>(m.k_s), Vec3<Real>(m.emission), Real(m.n)};
  const Vec3<Real> color(m.color);
  switch (tracked) {
    case ColorMaterial::off:
      break;
    case ColorMaterial::ambient_and_diffuse:
      out.k_a = out.k_d = color;
      break;
    case ColorMaterial::ambient:
      out.k_a = color;
      break;
    case ColorMaterial::diffuse:
      out.k_d = color;
      break;
    case ColorMaterial::specular:
      out.k_s = color;
      break;
    case ColorMaterial::emission:
      out.emission = color;
      break;
  }
  return out;
}

template EyeLighting<float> lighting_in_eye_space(const Scene&, const glm::dmat4&);
template EyeLighting<double> lighting_in_eye_space(const Scene&, const glm::dmat4&);
template EyeMaterial<float> eye_material(const Material&, ColorMaterial);
template EyeMaterial<double> eye_material(const Material&, ColorMaterial);

}  // namespace cg
