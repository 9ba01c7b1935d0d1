#include "workbench/probe.h"

#include <algorithm>
#include <limits>

#include "params/input_error.h"
#include "raster/pixel_triangle.h"
#include "shading/ambient_term.h"
#include "shading/eye_normal.h"
#include "shading/fixed_function_scene.h"
#include "shading/gl_calls.h"
#include "shading/light_batch.h"

namespace cg {

namespace {

// The light model by the arithmetic of the pictures, in `Real`.
template <class Real>
class Lit {
 public:
  // `lights`: the scene and camera whose lights they are in eye space; `by_hand`: null, or the mistakes of a light
  // model of the program's own. `radiosity`: each point brings light of a solution.
  Lit(const Scene& scene, const Scene& lights, const EyeMaterial<Real>& material, bool radiosity,
      const Mistakes* by_hand)
      : lighting_(lighting_in_eye_space<Real>(lights, view_matrix(lights.camera))),
        material_(material),
        radiosity_(radiosity),
        to_world_(glm::inverse(view_matrix(scene.camera))),
        lights_(lights.lights),
        by_hand_(by_hand) {}

  // P and N in eye space; B is the light that the point brings.
  LitPoint at(const Vec3<Real>& P, const Vec3<Real>& N, const Vec3<Real>& B) const {
    const Vec3<Real> V = towards_viewer(lighting_.local_viewer, P);
    LitPoint out;
    out.P = glm::dvec3(to_world_ * glm::dvec4(glm::dvec3(P), 1));
    const auto [length, direction] = length_and_unit(glm::dvec3(N));
    out.normal_length = length;
    out.N = world(direction), out.V = world(glm::dvec3(V));
    add_share(out, "emission", Quantity::emission, nullptr, P, N);
    if (radiosity_)
      out.terms.push_back({"radiosity", Quantity::ambient, -1, glm::dvec3(B)});
    else
      add_share(out, "global-ambient", Quantity::ambient, nullptr, P, N);
    for (const EyeLight<Real>& light : lighting_.lights) {
      out.lights.push_back(factors(light, P, N, V));
      if (!radiosity_) add_share(out, "ambient", Quantity::ambient, &light, P, N);
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
    const Vec3<Real> V = towards_viewer(lighting_.local_viewer, P);
    if (light && by_hand_) return out.terms.push_back({name, term, light->index, share_by_hand(*light, m, P, N, V)});
    EightVectors<Real> Ps, Ns, I;
    for (int i = 0; i < batch_size; ++i) Ps.set(i, P), Ns.set(i, N);
    light_points(lighting, m, Ps, Ns, I);
    out.terms.push_back({name, term, light ? light->index : -1, glm::dvec3(I.get(0))});
  }

  ProbedLight factors(const EyeLight<Real>& light, const Vec3<Real>& P, const Vec3<Real>& N,
                      const Vec3<Real>& V) const {
    LightFactors<Real> f = light_factors(light, lighting_.reflection, material_.n, P, N, V);
    if (by_hand_) f = factors_by_hand(light, P, N, V);
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

  // As shading/c/own_light_model.c has it, with its mistakes; L is what the program takes for it.
  LightFactors<Real> factors_by_hand(const EyeLight<Real>& light, const Vec3<Real>& P, const Vec3<Real>& N,
                                     const Vec3<Real>& V) const {
    LightFactors<Real> f = light_factors(light, lighting_.reflection, material_.n, P, N, V);
    if (by_hand_->long_light_vector) {
      const Light& given = lights_[std::size_t(light.index)];
      f.L *=
          light.directional ? Real(length_and_unit(given.position).length) : length_and_unit(light.position - P).length;
      if (light.spot_cosine > Real(-2)) {
        const Real c = -glm::dot(f.L, light.spot_direction);
        f.spot = c >= light.spot_cosine ? std::pow(c, light.spot_exponent) : Real(0);
      }
    }
    f.n_dot_l = positive(glm::dot(N, f.L));
    const bool gate = by_hand_->no_gate || f.n_dot_l > Real(0);
    f.lobe_cosine = gate ? positive(glm::dot(N, half_vector(f.L, V))) : Real(0);
    f.lobe = gate ? std::pow(f.lobe_cosine, material_.n) : Real(0);
    return f;
  }

  glm::dvec3 share_by_hand(const EyeLight<Real>& light, const EyeMaterial<Real>& m, const Vec3<Real>& P,
                           const Vec3<Real>& N, const Vec3<Real>& V) const {
    const LightFactors<Real> f = factors_by_hand(light, P, N, V);
    return glm::dvec3(f.attenuation * f.spot *
                      (light.ambient * m.k_a + light.diffuse * m.k_d * f.n_dot_l + light.specular * m.k_s * f.lobe));
  }

  EyeLighting<Real> lighting_;
  EyeMaterial<Real> material_;
  bool radiosity_;
  glm::dmat4 to_world_;
  std::vector<Light> lights_;
  const Mistakes* by_hand_;
};

// The normals that the technique is given at the vertices, and on which side they are.
template <class Real>
Vec3<Real> given_normal(const Mistakes& mistakes, const NormalTransform<Real>& transform, const glm::vec3& normal) {
  const Vec3<Real> n = mistakes.no_normals        ? Vec3<Real>(Real(0), Real(0), Real(1))
                       : mistakes.flipped_normals ? -Vec3<Real>(normal)
                                                  : Vec3<Real>(normal);
  return eye_normal(transform, n);
}

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
  const Mistakes& mistakes = scene.mistakes;  // of the technique: none but for the fixed function
  const bool by_hand = lights_by_hand(mistakes);
  const Surface& surface = *seen.object.surface;
  p.radiosity = !surface.radiosity.empty();
  const auto material = drawn_material<Real>(scene, object, surface);
  const Lit<Real> lit(scene, with_mistaken_lights(scene), material, p.radiosity, by_hand ? &mistakes : nullptr);
  const auto normals =
      normals_to_eye<Real>(view_matrix(scene.camera) * matrix(object.transform), scene.shading.normal_length);
  const bool back = p.front == mistakes.swapped_front_face;
  const Real side = scene.shading.two_sided && back && !by_hand ? Real(-1) : Real(1);
  const Mat4<Real> to_eye(seen.object.to_eye);
  Vec3<Real> P[3], N[3], B[3]{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t i = surface.indices[3 * std::size_t(seen.source()) + k];
    P[k] = Vec3<Real>(to_eye * Vec4<Real>(Vec3<Real>(surface.positions[i]), Real(1)));
    N[k] = side * given_normal(mistakes, normals, surface.normals[i]);
    if (p.radiosity) B[k] = Vec3<Real>(surface.radiosity[i]);
  }
  const Vec3<Real> w = seen.weights<Real>();
  Vec3<Real> normal = interpolate(w, N[0], N[1], N[2]);
  if (normals.normalize) normal = unit(normal);
  p.here = lit.at(interpolate(w, P[0], P[1], P[2]), normal, interpolate(w, B[0], B[1], B[2]));
  if (p.mode == ShadingMode::phong) {
    p.terms = p.here.terms, p.clamped = p.here.clamped;
  } else if (p.mode == ShadingMode::flat) {
    p.vertices = {lit.at(P[2], N[2], B[2])};
    p.terms = p.vertices[0].terms, p.clamped = p.vertices[0].clamped;
  } else {
    for (int k = 0; k < 3; ++k) p.vertices.push_back(lit.at(P[k], N[k], B[k]));
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
  Scene scene = technique.id == "gl-fixed" ? as_fixed_function(drawn) : drawn;
  if (technique.id != "gl-fixed") scene.mistakes = {};
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
  constexpr double usual_error = 2e-4;  // OpenGL's own rounding stays far below it
  const bool agrees = p.error() <= usual_error && (!p.covered || p.object >= 0);
  if (agrees || !frame.object.empty()) return p;
  View numbered = view;
  numbered.ids = true;
  const Frame again = technique.render(scene, technique.plan(scene, numbered), numbered, progress);
  return probe(scene, technique, numbered, again, pixel, progress);
}

}  // namespace cg
