// The camera from outside: the corners of what it sees project onto the corners of its picture.
#include "workbench/world_lines.h"

#include <gtest/gtest.h>

#include "workbench/camera_control.h"
#include "workbench/open.h"
#include "workbench/picking.h"

namespace cg {
namespace {

TEST(WorldLines, CornersOfTheViewVolume) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Camera camera;
    camera.position = {3, 2, 5}, camera.target = {0.5, -1, 0}, camera.projection = projection;
    camera.near_plane = 0.5, camera.far_plane = 20;
    const glm::dvec2 size(300, 200);
    const auto corners = view_volume(camera, 1.5);
    const PictureProjection projector(camera, size);
    const glm::dvec2 expected[4] = {{0, 200}, {300, 200}, {300, 0}, {0, 0}};
    for (std::size_t i = 0; i < 8; ++i) {
      const auto seen = projector.project(corners[i]);
      ASSERT_TRUE(seen);
      EXPECT_LT(glm::distance(seen->pixel, expected[i % 4]), 1e-6);
      EXPECT_NEAR(seen->depth, i < 4 ? 0.5 : 20, 1e-9);
    }
  }
}

TEST(WorldLines, TheOutsideCameraSeesSceneAndCamera) {
  for (const glm::dvec3 eye : {glm::dvec3(0, 1, 3.4), glm::dvec3(-6, 0.5, 2), glm::dvec3(0.1, 9, 0)}) {
    Scene scene = open_scene("teapot");
    scene.camera.position = eye;
    const Camera outside = outside_camera(scene, 1);
    const PictureProjection projector(outside, {100, 100});
    const Sphere sphere = bounding_sphere(scene, false);
    for (const glm::dvec3& point : {eye, sphere.centre, sphere.centre + glm::dvec3(sphere.radius, 0, 0)}) {
      const auto seen = projector.project(point);
      ASSERT_TRUE(seen);
      for (int i = 0; i < 2; ++i) EXPECT_TRUE(seen->pixel[i] > 0 && seen->pixel[i] < 100) << seen->pixel[i];
    }
  }
}

TEST(WorldLines, AreFiniteForExtremeCameras) {
  for (const double far_plane : {1.0, 1e6, 1e30})
    for (const glm::dvec3 eye : {glm::dvec3(0), glm::dvec3(1e30, 0, 0), glm::dvec3(0, 5, 0)}) {
      Camera camera;
      camera.position = eye, camera.far_plane = far_plane;
      for (const Lines& lines : camera_lines(camera, 1, 0.1))
        for (const glm::vec3& p : lines.points) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
    }
}

}  // namespace
}  // namespace cg
