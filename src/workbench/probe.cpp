#include "workbench/probe.h"

#include <algorithm>
#include <limits>

#include "params/input_error.h"
#include "raster/pixel_triangle.h"
#include "shading/eye_normal.h"
#include "shading/light_batch.h"

namespace cg {

namespace {

constexpr double gl_shininess_limit = 128;

// The scene as the technique has it within its limits.
Scene within_limits(Scene scene, const Technique& technique) {
  if (technique.id != "gl-fixed") return scene;
  scene.material.n = std::min(scene.material.n, gl_shininess_limit);
  for (Object& object : scene.objects) object.material.n = std::min(object.material.n, gl_shininess_limit);
  const auto lit = lighting_in_eye_space<double>(scene, view_matrix(scene.camera)).lights;
  for (std::size_t i = std::size_t(gl_light_limit); i < lit.size(); ++i)
    scene.lights[std::size_t(lit[i].index)].enabled = false;
  return scene;
}

// The light model by the arithmetic of the pictures, in `Real`.
template <class Real>
class Lit {
 public:
  Lit(const Scene& scene, const Material& material)
      : lighting_(lighting_in_eye_space<Real>(scene, view_matrix(scene.camera))),
        material_(eye_material<Real>(material, scene.shading.color_material)),
        to_world_(glm::inverse(view_matrix(scene.camera))) {}

  // P and N in eye space.
  LitPoint at(const Vec3<Real>& P, const Vec3<Real>& N) const {
    const Vec3<Real> V = towards_viewer(lighting_.local_viewer, P);
    LitPoint out;
    out.P = glm::dvec3(to_world_ * glm::dvec4(glm::dvec3(P), 1));
    const auto [length, direction] = length_and_unit(glm::dvec3(N));
    out.normal_length = length;
    out.N = world(direction), out.V = world(glm::dvec3(V));
    add_share(out, "emission", Quantity::emission, nullptr, P, N);
    add_share(out, "global-ambient", Quantity::ambient, nullptr, P, N);
    for (const EyeLight<Real>& light : lighting_.lights) {
      out.lights.push_back(factors(light, P, N, V));
      add_share(out, "ambient", Quantity::ambient, &light, P, N);
      add_share(out, "diffuse", Quantity::diffuse, &light, P, N);
      add_share(out, "specular", Quantity::specular, &light, P, N);
    }
    for (const ProbedTerm& term : out.terms) out.sum += term.rgb;
    out.clamped = lighting_.clamp ? saturate(out.sum) : out.sum;
    return out;
  }

 private:
  glm::dvec3 world(const glm::dvec3& eye) const { return unit(glm::dvec3(to_world_ * glm::dvec4(eye, 0))); }

  // The light model with all but one term and one light set to 0.
  void add_share(LitPoint& out, std::string_view name, Quantity term, const EyeLight<Real>* light, const Vec3<Real>& P,
                 const Vec3<Real>& N) const {
    EyeLighting<Real> lighting = lighting_;
    lighting.clamp = false;
    if (light) lighting.ambient = Vec3<Real>(Real(0));
    lighting.lights.clear();
    if (light) lighting.lights.push_back(*light);
    EyeMaterial<Real> m = material_;
    const Vec3<Real> none(Real(0));
    if (term != Quantity::emission) m.emission = none;
    if (term != Quantity::ambient) m.k_a = none;
    if (term != Quantity::diffuse) m.k_d = none;
    if (term != Quantity::specular) m.k_s = none;
    EightVectors<Real> Ps, Ns, I;
    for (int i = 0; i < batch_size; ++i) Ps.set(i, P), Ns.set(i, N);
    light_points(lighting, m, Ps, Ns, I);
    out.terms.push_back({name, term, light ? light->index : -1, glm::dvec3(I.get(0))});
  }

  ProbedLight factors(const EyeLight<Real>& light, const Vec3<Real>& P, const Vec3<Real>& N,
                      const Vec3<Real>& V) const {
    const LightFactors<Real> f = light_factors(light, lighting_.reflection, material_.n, P, N, V);
    ProbedLight out;
    out.light = light.index;
    out.L = world(glm::dvec3(f.L));
    const Vec3<Real> direction = unit(N);
    out.R = world(glm::dvec3(reflection_vector(direction, f.L, glm::dot(direction, f.L))));
    out.H = world(glm::dvec3(half_vector(f.L, V)));
    out.cosine = double(glm::dot(N, f.L));
    out.n_dot_l = double(f.n_dot_l);
    out.lobe_cosine = double(f.lobe_cosine), out.lobe = double(f.lobe);
    out.attenuation = double(f.attenuation), out.spot = double(f.spot);
    if (!light.directional) out.distance = double(length_and_unit(light.position - P).length);
    out.ambient = glm::dvec3(light.ambient), out.diffuse = glm::dvec3(light.diffuse);
    out.specular = glm::dvec3(light.specular);
    return out;
  }

  EyeLighting<Real> lighting_;
  EyeMaterial<Real> material_;
  glm::dmat4 to_world_;
};

// The terms of the vertices, interpolated, and what clamping at the vertices left of them.
void interpolate_vertices(Probe& p, const glm::dvec3& weights) {
  const std::vector<LitPoint>& v = p.vertices;
  for (std::size_t i = 0; i < 3; ++i) p.vertices[i].weight = weights[int(i)];
  p.terms = v[0].terms;
  for (std::size_t t = 0; t < p.terms.size(); ++t)
    p.terms[t].rgb = interpolate(weights, v[0].terms[t].rgb, v[1].terms[t].rgb, v[2].terms[t].rgb);
  p.clamped = interpolate(weights, v[0].clamped, v[1].clamped, v[2].clamped);
}

template <class Real>
void light(const Scene& scene, const PixelTriangle& seen, Probe& p) {
  const Object& object = scene.objects[std::size_t(p.object)];
  const Lit<Real> lit(scene, material_of(scene, object));
  const auto normals =
      normals_to_eye<Real>(view_matrix(scene.camera) * matrix(object.transform), scene.shading.normal_length);
  const Surface& surface = *seen.object.surface;
  const Real side = scene.shading.two_sided && !p.front ? Real(-1) : Real(1);
  const Mat4<Real> to_eye(seen.object.to_eye);
  Vec3<Real> P[3], N[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t i = surface.indices[3 * std::size_t(seen.source()) + k];
    P[k] = Vec3<Real>(to_eye * Vec4<Real>(Vec3<Real>(surface.positions[i]), Real(1)));
    N[k] = side * eye_normal(normals, Vec3<Real>(surface.normals[i]));
  }
  const Vec3<Real> w = seen.weights<Real>();
  Vec3<Real> normal = interpolate(w, N[0], N[1], N[2]);
  if (normals.normalize) normal = unit(normal);
  p.here = lit.at(interpolate(w, P[0], P[1], P[2]), normal);
  if (p.mode == ShadingMode::phong) {
    p.terms = p.here.terms, p.clamped = p.here.clamped;
  } else if (p.mode == ShadingMode::flat) {
    p.vertices = {lit.at(P[2], N[2])};
    p.terms = p.vertices[0].terms, p.clamped = p.vertices[0].clamped;
  } else {
    for (int k = 0; k < 3; ++k) p.vertices.push_back(lit.at(P[k], N[k]));
    interpolate_vertices(p, glm::dvec3(w));
  }
  const EyeMaterial<double> m = eye_material<double>(material_of(scene, object), scene.shading.color_material);
  p.material = material_of(scene, object);
  p.material.k_a = m.k_a, p.material.k_d = m.k_d, p.material.k_s = m.k_s, p.material.emission = m.emission;
}

void add_up(Probe& p) {
  for (const ProbedTerm& term : p.terms) p.sum += term.rgb;
}

std::optional<PixelTriangle> triangle_of(const Scene& scene, const View& view, const Frame& frame, glm::ivec2 pixel,
                                         Progress& progress) {
  if (frame.object.empty() || frame.triangle.empty()) return triangle_at(scene, view, pixel.x, pixel.y, progress);
  return triangle_at(scene, view, pixel.x, pixel.y, frame.object.at(pixel.x, pixel.y),
                     frame.triangle.at(pixel.x, pixel.y), progress);
}

}  // namespace

double Probe::error() const {
  const glm::dvec3 d = glm::abs(clamped - frame);
  return std::max({d.x, d.y, d.z});
}

Probe probe(const Scene& drawn, const Technique& technique, const View& view, const Frame& frame, glm::ivec2 pixel,
            Progress& progress) {
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= frame.colour.width() || pixel.y >= frame.colour.height()) {
    const std::string at = std::to_string(pixel.x) + "," + std::to_string(pixel.y),
                      size = std::to_string(frame.colour.width()) + "x" + std::to_string(frame.colour.height());
    throw InputError("pixel", {at + " is outside of a picture of " + size, at + " は " + size + " の画像の外です"},
                     Words{"0,0 is the top-left corner", "左上の画素が 0,0 です"});
  }
  const Scene scene = within_limits(drawn, technique);
  Probe p;
  p.technique = technique.id;
  p.pixel = pixel, p.size = {frame.colour.width(), frame.colour.height()};
  p.mode = scene.shading.mode, p.reflection = scene.shading.reflection, p.clamps = scene.shading.clamp;
  p.global_ambient = scene.shading.ambient;
  p.frame = glm::dvec3(frame.colour.at(pixel.x, pixel.y));
  p.depth = double(frame.depth.at(pixel.x, pixel.y));
  p.covered = frame.covered.at(pixel.x, pixel.y) != 0;
  if (!p.covered) {
    p.terms = {{"background", Quantity::none, -1, scene.display.background}};
    p.clamped = scene.display.background;
  } else if (const auto seen = triangle_of(scene, view, frame, pixel, progress)) {
    p.object = seen->object.index;
    p.triangle = int(seen->object.surface->triangle[seen->source()]);
    p.front = seen->is_front();
    const bool in_double = technique.id == "software" && scene.shading.precision == Precision::double_precision;
    in_double ? light<double>(scene, *seen, p) : light<float>(scene, *seen, p);
  }
  add_up(p);
  return p;
}

Probe probe_with_numbers(const Scene& scene, const Technique& technique, const View& view, const Frame& frame,
                         glm::ivec2 pixel, Progress& progress) {
  Probe p = probe(scene, technique, view, frame, pixel, progress);
  const bool agrees = p.error() <= 1.0 / 255 && (!p.covered || p.object >= 0);
  if (agrees || !frame.object.empty()) return p;
  View numbered = view;
  numbered.ids = true;
  const Frame again = technique.render(scene, technique.plan(scene, numbered), numbered, progress);
  return probe(scene, technique, numbered, again, pixel, progress);
}

}  // namespace cg
