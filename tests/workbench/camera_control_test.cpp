// Camera gestures against closed forms.
#include "workbench/camera_control.h"

#include <gtest/gtest.h>

#include <random>

namespace cg {
namespace {

Camera on_z(double distance) {
  Camera c;
  c.position = {0, 0, distance};
  return c;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

// Normalised device coordinates of a point.
glm::dvec3 seen(const Camera& c, double aspect, const glm::dvec3& p) {
  const glm::dvec4 clip = projection_matrix(c, aspect) * view_matrix(c) * glm::dvec4(p, 1);
  return glm::dvec3(clip) / clip.w;
}

bool finite(const Camera& c) {
  const glm::dmat4 m = projection_matrix(c, 1) * view_matrix(c);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (!std::isfinite(m[i][j])) return false;
  return is_finite(c.position) && is_finite(c.target) && is_finite(c.up);
}

TEST(Orbit, QuarterTurns) {
  expect_near(orbit(on_z(2), pi / 2, 0).position, {2, 0, 0}, 1e-14);
  expect_near(orbit(on_z(2), -pi / 2, 0).position, {-2, 0, 0}, 1e-14);
  expect_near(orbit(on_z(2), pi, 0).position, {0, 0, -2}, 1e-14);
  expect_near(orbit(on_z(2), 0, pi / 4).position, {0, std::sqrt(2.0), std::sqrt(2.0)}, 1e-14);
}

TEST(Orbit, KeepsDistanceAndStopsBeforeThePoles) {
  Camera c = on_z(3);
  c.target = {1, 2, -1};
  const double r = glm::length(c.position - c.target);
  for (int i = 0; i < 1000; ++i) c = orbit(c, 0.1, 0.03);
  EXPECT_NEAR(glm::length(c.position - c.target), r, 1e-12);
  EXPECT_NEAR(glm::dot(unit(c.position - c.target), glm::dvec3(0, 1, 0)), std::cos(radians(1)), 1e-12);
  const Camera back = orbit(c, 0, -10);
  EXPECT_NEAR(glm::dot(unit(back.position - back.target), glm::dvec3(0, 1, 0)), -std::cos(radians(1)), 1e-12);
}

TEST(Orbit, AndBackIsTheSame) {
  Camera c = on_z(2);
  c = orbit(orbit(c, 0.7, 0.3), -0.7, -0.3);
  expect_near(c.position, {0, 0, 2}, 1e-14);
}

TEST(Pan, MovesThePictureByHeights) {
  for (const Projection p : {Projection::perspective, Projection::orthographic}) {
    Camera c = orbit(on_z(2), 0.5, 0.4);
    c.projection = p;
    const Camera moved = pan(c, 0.25, 0.1);
    const glm::dvec3 ndc = seen(moved, 1, c.target);
    EXPECT_NEAR(ndc.x, 0.5, 1e-12);   // a quarter of the height to the right is half of -1..1
    EXPECT_NEAR(ndc.y, -0.2, 1e-12);  // down
  }
}

TEST(Zoom, KeepsWhatIsUnderTheCursor) {
  const double aspect = 1.6;
  const glm::dvec2 at(0.6, -0.4);
  for (const Projection p : {Projection::perspective, Projection::orthographic}) {
    Camera c = orbit(on_z(2), 0.5, 0.4);
    c.projection = p;
    const CameraAxes a = axes_of(c);
    const glm::dvec3 under = c.target + a.height / 2 * (at.x * aspect * a.right + at.y * a.up);
    for (const double factor : {0.5, 0.9, 1.7}) {
      const Camera near = zoom(c, factor, at, aspect);
      const glm::dvec3 ndc = seen(near, aspect, under);
      EXPECT_NEAR(ndc.x, at.x, 1e-12);
      EXPECT_NEAR(ndc.y, at.y, 1e-12);
      EXPECT_NEAR(axes_of(near).height, a.height * factor, 1e-12);
    }
  }
}

TEST(Fit, TheSphereTouchesTheMargin) {
  const Sphere sphere{{3, -2, 1}, 0.5};
  for (const double aspect : {0.5, 1.0, 2.0})
    for (const Projection p : {Projection::perspective, Projection::orthographic}) {
      Camera c = orbit(on_z(2), 0.3, 0.2);
      c.projection = p;
      c = fit(c, sphere, aspect);
      const CameraAxes a = axes_of(c);
      expect_near(c.target, sphere.centre, 1e-14);
      const double half_height = a.height / 2, half = half_height * std::min(1.0, aspect);
      const double expected = 1.05 * sphere.radius;
      if (p == Projection::orthographic)
        EXPECT_NEAR(half, expected, 1e-12);
      else  // sin of half the narrower angle is radius/distance
        EXPECT_NEAR(a.distance * half / std::hypot(a.distance, half), expected, 1e-12);
      EXPECT_TRUE(planes_hold(c, sphere));
      EXPECT_LE(c.far_plane / c.near_plane, 1e6 * (1 + 1e-12));
      EXPECT_GE(c.near_plane, 1e-4 * sphere.radius);
    }
}

TEST(Planes, LimitsHoldFromInsideAndFromFar) {
  for (const double radius : {1e-18, 1e-3, 1.0, 1e6, 1e18})
    for (const double distance : {0.0, 0.5, 1.0, 10.0, 1e5}) {
      const Sphere sphere{{0, 0, 0}, radius};
      Camera c = on_z(std::max(distance, 1e-3) * radius);
      c = with_planes(c, sphere);
      EXPECT_GE(c.near_plane, 1e-4 * radius * (1 - 1e-12));
      EXPECT_LE(c.far_plane / c.near_plane, 1e6 * (1 + 1e-9));
      EXPECT_GT(c.far_plane, c.near_plane);
      EXPECT_TRUE(finite(c));
    }
}

TEST(Projection, SwitchingKeepsTheApparentSize) {
  Camera c = orbit(on_z(2.5), 0.4, 0.3);
  c.target = {0.1, 0.2, 0.3};
  const CameraAxes a = axes_of(c);
  const glm::dvec3 mark = c.target + 0.3 * a.up + 0.2 * a.right;  // at the target's depth
  const Camera o = with_projection(c, Projection::orthographic);
  expect_near({glm::dvec2(seen(o, 1.3, mark)), 0}, {glm::dvec2(seen(c, 1.3, mark)), 0}, 1e-12);
  Camera wide = o;
  wide.fov = 90;
  const Camera p = with_projection(wide, Projection::perspective);
  expect_near({glm::dvec2(seen(p, 1.3, mark)), 0}, {glm::dvec2(seen(c, 1.3, mark)), 0}, 1e-12);
}

TEST(Turntable, DegreesPerSecondWithPausesCutShort) {
  expect_near(turntable(on_z(1), 90, 0.1).position, orbit(on_z(1), radians(9), 0).position, 1e-15);
  expect_near(turntable(on_z(1), 90, 1e6).position, orbit(on_z(1), radians(22.5), 0).position, 1e-15);
  expect_near(turntable(on_z(1), 90, -1).position, {0, 0, 1}, 1e-15);
  expect_near(turntable(on_z(1), 90, std::nan("")).position, {0, 0, 1}, 1e-15);
}

TEST(DegenerateCameras, EveryGestureStaysFinite) {
  Camera at_target = on_z(0), no_up = on_z(1), along_up = on_z(1), huge = on_z(1e30), tiny = on_z(1e-300);
  no_up.up = {0, 0, 0};
  along_up.up = {0, 0, 1};
  for (const Camera& c : {at_target, no_up, along_up, huge, tiny})
    for (const Projection p : {Projection::perspective, Projection::orthographic}) {
      Camera d = c;
      d.projection = p;
      EXPECT_TRUE(finite(orbit(d, 0.3, 0.2)));
      EXPECT_TRUE(finite(pan(d, 0.3, 0.2)));
      EXPECT_TRUE(finite(zoom(d, 0.5, {0.3, 0.2}, 1)));
      EXPECT_TRUE(finite(fit(d, {}, 1)));
      EXPECT_TRUE(finite(with_planes(d, {})));
      EXPECT_TRUE(finite(turntable(d, 30, 0.1)));
      EXPECT_TRUE(finite(
          with_projection(d, p == Projection::perspective ? Projection::orthographic : Projection::perspective)));
    }
  EXPECT_NE(orbit(at_target, 0.1, 0).position, at_target.target);
}

// So far from the origin that a step of one metre is lost in rounding, the eye still stands off the target.
TEST(DegenerateCameras, FarFromTheOrigin) {
  for (const double place : {1e17, 1e24}) {
    Camera at_target = on_z(0);
    at_target.position = at_target.target = {place, -place, place};
    for (const Camera& c : {orbit(at_target, 0.1, 0), zoom(at_target, 0.5, {0, 0}, 1),
                            zoom(at_target, 1e-30, {0, 0}, 1), with_planes(at_target, {}), pan(at_target, 0.3, 0.2)}) {
      EXPECT_TRUE(finite(c)) << place;
      EXPECT_GT(axes_of(c).distance, 0) << place;
    }
    EXPECT_NE(zoom(at_target, 0.5, {0, 0}, 1).position, at_target.target);
  }
}

TEST(DegenerateCameras, AStormOfGestures) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> d(-1, 1);
  Camera c;
  for (int i = 0; i < 300000; ++i) {
    const double x = d(random), y = d(random), z = d(random);
    switch (random() % 5) {
      case 0:
        c = orbit(c, 4 * x, 4 * y);
        break;
      case 1:
        c = pan(c, x, y);
        break;
      case 2:
        c = zoom(c, std::exp(3 * z), {x, y}, 1.5);
        break;
      case 3:
        c = with_projection(c, random() % 2 ? Projection::perspective : Projection::orthographic);
        break;
      default:
        c = random() % 50 ? with_planes(c, {}) : fit(c, {{0, 0, 0}, std::exp(20 * x)}, 1 + y);
    }
    ASSERT_TRUE(finite(c)) << i;
  }
}

TEST(BoundingSphere, OfACube) {
  Scene scene;
  EXPECT_EQ(bounding_sphere(scene, true).radius, 1);
  MeshData data;
  data.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  const Corner face[4] = {{.position = 0}, {.position = 1}, {.position = 2}, {.position = 3}};
  data.add_face(face, face + 4);
  Object object;
  object.mesh = Mesh::make(data);
  object.transform.scale = {1, 3, 1};
  object.transform.translate = {0, 0, 5};
  scene.objects.push_back(object);
  for (const bool exact : {false, true}) {
    const Sphere s = bounding_sphere(scene, exact);
    expect_near(s.centre, {1, 3, 5}, 1e-15);
    EXPECT_NEAR(s.radius, std::sqrt(10.0), 1e-15);
  }
}

}  // namespace
}  // namespace cg
