// The scenes that the tables of cases begin with, and the changes that several of them make.
#pragma once
#include <cstdint>

#include "measure/extreme_check.h"

namespace cg {

// A sphere of 24 slices under the default point light, n = 5.
Scene sphere_scene();
// A square of side 2 in the plane z = 0, seen from (0, 0, 4), n = 32.
Scene square_scene();
// The square under a directional light that comes from `theta` radians beside the normal, towards +x: one colour
// everywhere, as V is the same for all points.
Scene even_square(double theta);

// The closed form of even_square(theta): I_a k_a + I_d k_d cos(theta) + I_s k_s cos(theta / 2)^n of its first light,
// with the scene's own numbers.
glm::dvec3 even_colour(const Scene& scene, double theta);

MeshHandle mesh_of_faces(std::vector<glm::dvec3> positions, const std::vector<std::vector<std::uint32_t>>& polygons);
// `mesh` with p * scale + offset, and its own normals times `normal_length`.
MeshHandle changed_mesh(const Mesh& mesh, double scale, const glm::dvec3& offset, double normal_length = 1);

void unlit(Scene& scene);
Change nothing_changed();
Change both(Change a, Change b);
Change mesh_change(MeshHandle mesh);
Change light_kind(LightKind kind);
// Of the first light.
Change light_at(const glm::dvec3& position, double w = 1, LightKind kind = LightKind::point);

// What a case of a picture is made of; the rest of it has defaults.
struct PictureRow {
  std::string id, group;
  Text name;
  std::string parameter, value;
  Text right;
  std::function<Scene()> start = sphere_scene;
  Change change = {};
  Change same = {};  // the ordinary change of `start` with the same picture; neither this nor `check`: the reference
  PictureCheck check = {};
  Change fixed_same = {};  // gl-fixed's, where it is another
  std::string note = {};
  std::string fixed_note = {};  // empty: `note`
  double tolerance = 0;         // 0: 1/255 beside another picture, 2/255 beside the reference
  std::vector<ExtremeVariant> variants = {};
};
ExtremeCase picture_case(PictureRow row);

// Right sentences that many cases share.
Text as_without_light();
Text as_directional();
Text as_ordinary();
Text as_the_reference();

}  // namespace cg
