// The geometry of the hemicube and what its pixels count.
#include "radiosity/hemicube.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "math/transform.h"

namespace cg {
namespace {

TEST(Hemicube, DeltaFormFactorsSumToTheKnownValues) {
  // Total - 1 of the midpoint rule.
  const std::array<std::pair<int, double>, 6> known{
      {{32, 5.30e-4}, {64, 1.32e-4}, {128, 3.31e-5}, {256, 8.27e-6}, {512, 2.07e-6}, {1024, 5.17e-7}}};
  for (const auto& [resolution, over] : known) {
    const PixelWeights midpoint(resolution, PixelWeight::delta_form_factor);
    EXPECT_NEAR((midpoint.sum() - 1) / over, 1, 5e-3) << resolution;
    const PixelWeights integrated(resolution, PixelWeight::integrated);
    EXPECT_NEAR(integrated.face_sum(HemicubeFace::top), 0.554126424, 5e-10);
    EXPECT_NEAR(integrated.face_sum(HemicubeFace::left), 0.111468394, 5e-10);
    EXPECT_NEAR(integrated.sum(), 1, 1e-12);
  }
}

TEST(Hemicube, WrongWeightsSumToOneAndAreWrong) {
  for (const PixelWeight w : {PixelWeight::unweighted, PixelWeight::solid_angle, PixelWeight::r_squared}) {
    const PixelWeights wrong(64, w);
    EXPECT_NEAR(wrong.sum(), 1, 1e-12);
    EXPECT_GT(std::abs(wrong.face_sum(HemicubeFace::top) - 0.554126424), 0.02) << int(w);
  }
}

// The weight of a pixel is that of the differential form factor cos / pi d omega to it.
TEST(Hemicube, WeightsAreCosineTimesSolidAngle) {
  const int resolution = 32;
  const PixelWeights weights(resolution, PixelWeight::delta_form_factor);
  const double area = 4.0 / (resolution * resolution);
  for (const HemicubeFace f : hemicube_faces)
    for (int y = 0; y < face_height(f, resolution); ++y)
      for (int x = 0; x < face_width(f, resolution); ++x) {
        const glm::dvec3 d = on_cube(f, pixel_centre(f, x, y, resolution));
        const double largest = std::max({std::abs(d.x), std::abs(d.y), d.z});
        EXPECT_DOUBLE_EQ(largest, 1);
        const double r = glm::length(d), cosine_there = largest / r;
        ASSERT_NEAR(weights(f, x, y), d.z / r * cosine_there / (r * r) / pi * area, 1e-9);
      }
}

// Each side continues the top.
TEST(Hemicube, FacesMeetInTheCross) {
  for (const double a : {-0.7, 0.3}) {
    EXPECT_EQ(on_cube(HemicubeFace::right, {0, a}), on_cube(HemicubeFace::top, {1, a}));
    EXPECT_EQ(on_cube(HemicubeFace::left, {1, a}), on_cube(HemicubeFace::top, {-1, a}));
    EXPECT_EQ(on_cube(HemicubeFace::upper, {a, 0}), on_cube(HemicubeFace::top, {a, 1}));
    EXPECT_EQ(on_cube(HemicubeFace::lower, {a, 1}), on_cube(HemicubeFace::top, {a, -1}));
  }
}

TEST(Hemicube, PointsComeBackFromTheirFace) {
  for (const HemicubeFace f : hemicube_faces) {
    const FacePoint<double> p{0.3, 0.6};
    const glm::dvec3 d = 2.5 * on_cube(f, p);
    double s = 0, t = 0, w = 0, a = 0, b = 0, c = 0;
    project_to_face(f, d.x, d.y, d.z, s, t, w);
    EXPECT_NEAR(s, p.s, 1e-12);
    EXPECT_NEAR(t, p.t, 1e-12);
    EXPECT_NEAR(w, 2.5, 1e-12);
    const glm::dvec3 n(0.2, -0.5, 0.7);
    on_face(f, n.x, n.y, n.z, a, b, c);
    EXPECT_NEAR(a * p.s + b * p.t + c, glm::dot(n, on_cube(f, p)), 1e-12);
  }
}

TEST(Hemicube, FramesAreRightHanded) {
  for (const glm::dvec3& n :
       {glm::dvec3(0, 0, 1), glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0), unit(glm::dvec3(1, 2, -3))})
    for (const int samples : {1, 3})
      for (int number = 0; number < samples * samples; ++number) {
        const HemicubeFrame f = hemicube_frame({1, 2, 3}, n, std::size_t(number), samples);
        EXPECT_EQ(f.z, n);
        EXPECT_NEAR(glm::length(f.x), 1, 1e-14);
        EXPECT_NEAR(glm::dot(f.x, f.z), 0, 1e-14);
        EXPECT_NEAR(glm::length(glm::cross(f.x, f.y) - f.z), 0, 1e-14);
      }
}

// What stands upright is seen at four places of its pixels, and on average at their middles.
TEST(Hemicube, RowsOfTheSidesStandAside) {
  const HemicubeFrame one = hemicube_frame(glm::dvec3(0), {0, 0, 1}),
                      many = hemicube_frame(glm::dvec3(0), {0, 0, 1}, 0, 4);
  EXPECT_FALSE(one.staggered);
  EXPECT_TRUE(many.staggered);
  for (const HemicubeFace f : hemicube_faces) {
    const bool across = crosses_in_s(f);
    std::vector<double> at;
    for (int row = 0; row < 4; ++row) {
      const int x = across ? row : 5, y = across ? 5 : row;
      const FacePoint<double> middle = pixel_centre(f, x, y, 32), sample = sample_point(many, f, x, y, 32);
      EXPECT_EQ(across ? sample.s : sample.t, across ? middle.s : middle.t);
      at.push_back(16 * (across ? sample.t - middle.t : sample.s - middle.s));  // in pixels
    }
    if (f == HemicubeFace::top) {
      for (const double aside : at) EXPECT_EQ(aside, 0);
      continue;
    }
    std::sort(at.begin(), at.end());
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(at[std::size_t(k)], (k - 1.5) / 4, 1e-12);
  }
}

// By equal steps of a quarter turn; one alone stands along the axes.
TEST(Hemicube, PositionsAreTurned) {
  const glm::dvec3 up(0, 0, 1), along = hemicube_frame(glm::dvec3(0), up).x;
  EXPECT_EQ(std::abs(along.x) + std::abs(along.y), 1);
  const auto angle = [&](std::size_t number) {
    const HemicubeFrame f = hemicube_frame(glm::dvec3(0), up, number, 4);
    return std::atan2(glm::dot(f.x, glm::cross(up, along)), glm::dot(f.x, along));
  };
  EXPECT_NEAR(std::tan(angle(0)), (std::sqrt(5) - 1) / 2, 1e-14);
  for (std::size_t number = 1; number < 16; ++number) EXPECT_NEAR(angle(number) - angle(number - 1), pi / 32, 1e-14);
}

}  // namespace
}  // namespace cg
