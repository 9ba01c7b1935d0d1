#include "workbench/overlay.h"

#include <gtest/gtest.h>

namespace cg {
namespace {

// A cube [-1,1]^3 of quads; 8 vertices, 12 edges, 6 faces.
MeshHandle cube() {
  MeshData data;
  for (int i = 0; i < 8; ++i) data.positions.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
  const std::uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) {
    Corner corners[4];
    for (int i = 0; i < 4; ++i) corners[i].position = f[i];
    data.add_face(corners, corners + 4);
  }
  return Mesh::make(data);
}

Scene scene_of_a_cube() {
  Scene scene;
  Object object;
  object.mesh = cube();
  scene.objects.push_back(object);
  return scene;
}

glm::dvec3 end(const Lines& lines, std::size_t i) { return lines.origin + glm::dvec3(lines.points[i]); }

TEST(MeshOverlay, ACubeHasTwelveEdgesAndSixFaceNormals) {
  const MeshOverlay o = mesh_overlay(
      scene_of_a_cube(), {.edges = true, .face_normals = true, .vertex_normals = true, .normal_length = 0.5});
  ASSERT_EQ(o.lines.size(), 3u);
  EXPECT_EQ(o.lines[0].count(), 12u);
  for (std::size_t i = 0; i < 24; i += 2)
    EXPECT_NEAR(glm::length(end(o.lines[0], i) - end(o.lines[0], i + 1)), 2, 1e-6);
  EXPECT_EQ(o.lines[1].count(), 6u);
  for (std::size_t i = 0; i < 12; i += 2) {  // from the middle of a face straight outwards
    const glm::dvec3 foot = end(o.lines[1], i), tip = end(o.lines[1], i + 1);
    EXPECT_NEAR(glm::length(foot), 1, 1e-6);
    EXPECT_LT(glm::length(tip - 1.5 * foot), 1e-6);
  }
  EXPECT_EQ(o.lines[2].count(), 8u);
  for (std::size_t i = 0; i < 16; i += 2) {
    const glm::dvec3 foot = end(o.lines[2], i), tip = end(o.lines[2], i + 1);
    EXPECT_NEAR(glm::length(tip - foot), 0.5, 1e-6);
    EXPECT_NEAR(glm::dot(tip - foot, foot), 0.5 * std::sqrt(3.0), 1e-6);
  }
  EXPECT_FALSE(o.thinned);
}

TEST(MeshOverlay, NormalsAreTransformedAsNormals) {
  Scene scene = scene_of_a_cube();
  scene.objects[0].transform.scale = {2, 1, 1};
  scene.objects[0].transform.rotate = {0, 0, 30};
  const MeshOverlay o = mesh_overlay(scene, {.face_normals = true, .normal_length = 1});
  const glm::dmat4 m = matrix(scene.objects[0].transform);
  for (std::size_t i = 0; i < o.lines[0].points.size(); i += 2) {
    const glm::dvec3 n = end(o.lines[0], i + 1) - end(o.lines[0], i);
    EXPECT_NEAR(glm::length(n), 1, 1e-6);
    // Perpendicular to two of the three transformed edges, along the third.
    int across = 0;
    for (int a = 0; a < 3; ++a) across += std::abs(glm::dot(n, unit(glm::dvec3(m[a])))) < 1e-6;
    EXPECT_EQ(across, 2);
  }
}

TEST(MeshOverlay, HiddenObjectsAndMissingMeshesDrawNothing) {
  Scene scene = scene_of_a_cube();
  scene.objects[0].visible = false;
  scene.objects.push_back(Object{});
  EXPECT_TRUE(mesh_overlay(scene, {.edges = true}).lines.empty());
}

TEST(MeshOverlay, FarScenesKeepTheirShape) {
  Scene scene = scene_of_a_cube();
  scene.objects[0].transform.translate = {1e7, 0, 0};
  const MeshOverlay o = mesh_overlay(scene, {.edges = true});
  for (std::size_t i = 0; i < 24; i += 2)
    EXPECT_NEAR(glm::length(end(o.lines[0], i) - end(o.lines[0], i + 1)), 2, 1e-6);
}

TEST(HalfDistance, SolvesTheAttenuation) {
  Light light;
  EXPECT_FALSE(half_distance(light));
  for (const auto& k :
       {glm::dvec3(1, 0.5, 0), glm::dvec3(1, 0, 0.25), glm::dvec3(2, 0.3, 0.1), glm::dvec3(1, 1e-9, 1e-12)}) {
    light.k_0 = k[0], light.k_1 = k[1], light.k_2 = k[2];
    const auto r = half_distance(light);
    ASSERT_TRUE(r);
    EXPECT_NEAR((k[0] + *r * (k[1] + *r * k[2])) / (2 * k[0]), 1, 1e-12);
  }
  light.kind = LightKind::directional;
  EXPECT_FALSE(half_distance(light));
}

TEST(LightLines, ASpotsConeHasItsAngle) {
  Light light;
  light.kind = LightKind::spot;
  light.position = {1, 2, 3};
  light.direction = {0, -2, 0};
  light.cutoff = 25;
  const Lines lines = light_lines(light, true, Camera{}, 1);
  EXPECT_EQ(lines.mark, Mark::selected_light);
  int on_the_cone = 0;
  for (std::size_t i = 0; i < lines.points.size(); ++i) {
    const glm::dvec3 d = end(lines, i) - light.position;
    if (glm::length(d) < 1e-6) continue;
    const double angle = degrees(std::acos(glm::dot(unit(d), glm::dvec3(0, -1, 0))));
    if (std::abs(angle) < 1e-3) continue;  // the axis
    EXPECT_NEAR(angle, 25, 1e-3);
    ++on_the_cone;
  }
  EXPECT_GT(on_the_cone, 40);
}

TEST(LightLines, OddLightsDrawOnlyFiniteLines) {
  Light zero, nan;
  zero.kind = LightKind::directional;
  zero.position = {0, 0, 0};
  nan.kind = LightKind::spot;
  nan.position = {std::nan(""), 1e300, 0};
  for (const Light& light : {zero, nan}) EXPECT_EQ(light_lines(light, false, Camera{}, 1).count(), 0u);
}

}  // namespace
}  // namespace cg
