// What the colour of one pixel is made of: every term of the light model, every factor of it, and the vectors.
// The numbers are those of the picture: the triangle, the interpolation (GL 2.1, section 3.5.1) and the light model
// are the ones that drew it, in its precision.
#pragma once
#include <string_view>
#include <vector>

#include "params/tree.h"
#include "scene/technique.h"

namespace cg {

// One addend of the pixel's colour. Named "emission", "global-ambient", "ambient", "diffuse", "specular", or
// "background" where nothing was drawn; where a radiosity solution is drawn, "radiosity" stands in for the ambient
// ones.
struct ProbedTerm {
  std::string_view name;
  Quantity quantity = Quantity::none;
  int light = -1;  // index into Scene::lights; -1: it belongs to none
  glm::dvec3 rgb{0};
};

// The factors of one light at a point. Vectors are unit, in world coordinates, and lead away from the surface; 0 where
// there is no direction.
struct ProbedLight {
  int light = 0;  // index into Scene::lights
  glm::dvec3 L{0}, R{0}, H{0};
  double cosine = 0;       // N.L, negative where the light is behind the surface
  double n_dot_l = 0;      // max(N.L, 0), the factor of the diffuse term
  double lobe_cosine = 0;  // max(R.V, 0) or max(N.H, 0), whichever the scene's highlight has; 0 where N.L is not > 0
  double lobe = 0;         // that to the power n
  double attenuation = 1, spot = 1;
  double distance = 0;                             // metres; 0 for a directional light
  glm::dvec3 ambient{0}, diffuse{0}, specular{0};  // I of the light
};

// The light model at one point.
struct LitPoint {
  double weight = 1;                // of its colour in the pixel's
  glm::dvec3 P{0}, N{0}, V{0};      // world; N and V unit
  double normal_length = 1;         // of N as the light model has it; the factors contain it
  std::vector<ProbedLight> lights;  // those that are on
  std::vector<ProbedTerm> terms;    // their sum is `sum`
  glm::dvec3 sum{0}, clamped{0};    // clamped: to 0..1 where the scene says so
};

struct Probe {
  std::string technique;  // the id
  glm::ivec2 pixel{0}, size{0};
  bool covered = false;  // something is there; if not, what follows down to `terms` means nothing
  int object = -1;       // index into Scene::objects; -1 also where the pixel is covered and no triangle was found
  int triangle = -1;     // index into Mesh::triangles()
  bool front = true;     // its front face is seen
  double depth = 1;      // window depth 0..1
  ShadingMode mode = ShadingMode::phong;
  Reflection reflection = Reflection::half_vector;
  bool clamps = true;
  Material material;  // as it was drawn: colour material applied, n limited where the technique limits it
  glm::dvec3 global_ambient{0};
  bool radiosity = false;  // a solution stands in for the ambient term: k_a and I_a do nothing here
  // The light model at the pixel, point and normal interpolated. With Phong shading this is what was drawn; with the
  // others it is what Phong shading would draw.
  LitPoint here;
  // Where light was computed instead: the three vertices of the triangle (Gouraud), its last (flat); else empty.
  std::vector<LitPoint> vertices;

  std::vector<ProbedTerm> terms;  // of the pixel, interpolated from the vertices' where there are some
  glm::dvec3 sum{0};              // of the terms
  glm::dvec3 clamped{0};          // after clamping: at the pixel, or at each vertex before interpolation
  glm::dvec3 frame{0};            // what the technique drew

  // The largest difference of a channel between `clamped` and `frame`.
  double error() const;
};

// Probes a pixel of a picture that `technique` drew of `scene` (as it was drawn: with the app's isolation, meshes
// loaded) for `view`. Which triangle the pixel shows comes from the frame's object and triangle numbers; where it has
// none, from the software's visibility, which may differ from OpenGL's at an edge. `pixel` counts from the top-left
// corner; throws InputError where it is outside of the picture, and Cancelled.
Probe probe(const Scene& scene, const Technique& technique, const View& view, const Frame& frame, glm::ivec2 pixel,
            Progress& progress);

// The same; where the terms do not come to what was drawn and the frame has no numbers, the picture is drawn once more
// with them.
Probe probe_with_numbers(const Scene& scene, const Technique& technique, const View& view, const Frame& frame,
                         glm::ivec2 pixel, Progress& progress);

// One JSON object: pixel, technique, covered, terms, sum, clamped, frame, N, V, lights, vertices, ...
Tree json_of(const Probe& probe, const Scene& scene);

// The same for a person: lines, each ended.
std::string text_of(const Probe& probe, const Scene& scene, Language language);

}  // namespace cg
