#include "workbench/picking.h"

#include <gtest/gtest.h>

#include <random>

#include "workbench/camera_control.h"

namespace cg {
namespace {

const glm::dvec2 size(640, 480);

Camera some_camera(Projection p) {
  Camera c = orbit(Camera{}, 0.6, 0.3);
  c.target += glm::dvec3(0.1, -0.2, 0.3);
  c.projection = p;
  return c;
}

TEST(PictureProjection, AgreesWithTheMatricesOfTheCamera) {
  for (const Projection p : {Projection::perspective, Projection::orthographic}) {
    const Camera c = some_camera(p);
    const glm::dvec3 point(0.3, 0.4, -0.2);
    const glm::dvec4 clip = projection_matrix(c, size.x / size.y) * view_matrix(c) * glm::dvec4(point, 1);
    const auto seen = PictureProjection(c, size).project(point);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->pixel.x, (clip.x / clip.w + 1) / 2 * size.x, 1e-9);
    EXPECT_NEAR(seen->pixel.y, (1 - clip.y / clip.w) / 2 * size.y, 1e-9);
  }
}

TEST(PictureProjection, ThereAndBack) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> d(-1, 1);
  for (const Projection p : {Projection::perspective, Projection::orthographic}) {
    const PictureProjection projector(some_camera(p), size);
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 point(d(random), d(random), d(random));
      const auto seen = projector.project(point);
      ASSERT_TRUE(seen);
      EXPECT_LT(glm::length(projector.unproject(seen->pixel, seen->depth) - point), 1e-12);
      const auto [origin, direction] = projector.ray(seen->pixel);
      EXPECT_LT(glm::length(glm::cross(point - origin, direction)), 1e-12);
      EXPECT_NEAR(glm::length(direction), 1, 1e-14);
    }
  }
}

TEST(PictureProjection, NothingBehindTheEye) {
  const PictureProjection p(Camera{}, size);
  EXPECT_FALSE(p.project({0, 0, 10}));
  EXPECT_FALSE(p.project({std::nan(""), 0, 0}));
  EXPECT_TRUE(p.project({0, 0, -10}));
}

Scene lit(Light light) {
  Scene scene;
  scene.lights = {light};
  return scene;
}

TEST(LightHandles, APointLightInThePictureIsHeldWhereItStands) {
  Light light;
  light.position = {0.4, 0.3, 0.2};
  light.w = 2;
  const auto handles = light_handles(lit(light), size);
  ASSERT_EQ(handles.size(), 1u);
  EXPECT_EQ(handles[0].grip, Grip::place);
  EXPECT_EQ(handles[0].world, glm::dvec3(0.2, 0.15, 0.1));
}

TEST(LightHandles, FarAndDirectionalLightsAreHeldOnASphere) {
  Light far, directional;
  far.position = {10, 10, 10};
  directional.kind = LightKind::directional;
  directional.position = {0, 0, -3};
  Scene scene = lit(far);
  scene.lights.push_back(directional);
  const auto handles = light_handles(scene, size);
  ASSERT_EQ(handles.size(), 2u);
  for (const Handle& h : handles) {
    EXPECT_EQ(h.grip, Grip::sphere);
    EXPECT_NEAR(glm::length(h.world - scene.camera.target), handle_sphere_radius(scene.camera, size), 1e-12);
    EXPECT_TRUE(h.pixel.x > 0 && h.pixel.x < size.x && h.pixel.y > 0 && h.pixel.y < size.y);
  }
  EXPECT_FALSE(handles[0].behind);
  EXPECT_TRUE(handles[1].behind);
}

TEST(LightHandles, LightsWithoutAPlaceOrOffHaveNone) {
  Light off, zero, nan;
  off.enabled = false;
  zero.kind = LightKind::directional;
  zero.position = {0, 0, 0};
  nan.position = {std::nan(""), 0, 0};
  for (const Light& light : {off, zero, nan}) EXPECT_TRUE(light_handles(lit(light), size).empty());
  EXPECT_TRUE(light_handles(lit(Light{}), {0, 0}).empty());
}

// After any drag the handle is seen under the mouse again.
TEST(Dragging, TheHandleFollowsTheMouse) {
  Light point, directional, far, spot;
  point.position = {0.4, 0.3, 0.2};
  point.w = 0.5;
  directional.kind = LightKind::directional;
  directional.position = {1, 2, 2};
  spot.kind = LightKind::spot;
  spot.position = {0.2, 0.6, 0.3};
  spot.direction = {0, -2, -1};
  for (const Projection p : {Projection::perspective, Projection::orthographic})
    for (const Light& light : {point, directional, far, spot}) {
      Scene scene = lit(light);
      scene.camera.projection = p;
      for (const Handle& before : light_handles(scene, size)) {
        Scene after = scene;
        const glm::dvec2 moved(-13, 21);
        after.lights[0] = dragged(light, before, scene.camera, size, moved, false);
        bool found = false;
        for (const Handle& h : light_handles(after, size)) {
          if (h.grip != before.grip) continue;
          found = true;
          if (h.grip == Grip::aim) {  // its length on screen is its own; the direction is what follows
            const glm::dvec3 to_mouse =
                PictureProjection(scene.camera, size).unproject(before.pixel + moved, before.depth) - spot.position;
            EXPECT_LT(glm::length(glm::cross(unit(to_mouse), unit(after.lights[0].direction))), 1e-12);
          } else {
            EXPECT_LT(glm::length(h.pixel - before.pixel - moved), 1e-6);
          }
        }
        EXPECT_TRUE(found);
      }
    }
}

TEST(Dragging, KeepsLengthsAndDistances) {
  Light directional;
  directional.kind = LightKind::directional;
  directional.position = {1, 2, 2};
  Scene scene = lit(directional);
  Light after = dragged(directional, light_handles(scene, size)[0], scene.camera, size, {40, 10}, false);
  EXPECT_NEAR(glm::length(after.position), 3, 1e-12);
  scene = lit(Light{});
  after = dragged(Light{}, light_handles(scene, size)[0], scene.camera, size, {40, 10}, false);
  EXPECT_NEAR(glm::length(after.position - scene.camera.target), std::sqrt(300.0), 1e-9);
  // Far off the sphere the handle runs along its outline.
  after = dragged(Light{}, light_handles(scene, size)[0], scene.camera, size, {1e4, 0}, false);
  EXPECT_NEAR(glm::length(after.position), std::sqrt(300.0), 1e-9);
  EXPECT_GT(after.position.x, 16);
}

TEST(Dragging, AlongTheViewKeepsThePixel) {
  Light light;
  light.position = {0.4, 0.3, 0.2};
  const Scene scene = lit(light);
  const Handle before = light_handles(scene, size)[0];
  Scene after = scene;
  after.lights[0] = dragged(light, before, scene.camera, size, {5, -30}, true);
  const Handle h = light_handles(after, size)[0];
  EXPECT_LT(glm::length(h.pixel - before.pixel), 1e-9);
  EXPECT_NEAR(h.depth, before.depth * std::exp(30.0 / 480 * 3), 1e-12);
}

TEST(HandleAt, NearestWithinTheRadius) {
  std::vector<Handle> handles(2);
  handles[0].pixel = {10, 10};
  handles[1].pixel = {20, 10};
  handles[1].light = 1;
  EXPECT_EQ(handle_at(handles, {18, 10}, 9)->light, 1);
  EXPECT_EQ(handle_at(handles, {13, 10}, 9)->light, 0);
  EXPECT_FALSE(handle_at(handles, {15, 25}, 9));
}

}  // namespace
}  // namespace cg
