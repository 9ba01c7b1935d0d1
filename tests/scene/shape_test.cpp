#include "scene/shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>

#include "math/transform.h"
#include "scene/polygon.h"

using namespace cg;

namespace {

MeshHandle shape(std::string_view id, int level = 0) { return make_shape(*find_shape(id), level); }

struct AreaAndVolume {
  double area = 0, volume = 0;
};

// Of the triangles; the volume is that inside a closed mesh whose faces point outwards (Gauss's theorem).
AreaAndVolume measure(const Mesh& mesh) {
  AreaAndVolume out;
  for (const Triangle& t : mesh.triangles()) {
    std::array<glm::dvec3, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = mesh.data().positions[mesh.data().corners[t.corner[k]].position];
    out.area += glm::length(vector_area(p));
    out.volume += glm::dot(p[0], glm::cross(p[1], p[2])) / 6;
  }
  return out;
}

// The largest distance of a corner's normal from what the shape's equation says.
template <class Exact>
double worst_normal(const Mesh& mesh, const Exact& exact) {
  double worst = 0;
  for (const Corner& c : mesh.data().corners)
    worst = std::max(worst, glm::distance(mesh.data().normals[c.normal], exact(mesh.data().positions[c.position])));
  return worst;
}

}  // namespace

class EveryShape : public testing::TestWithParam<Shape> {};

INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape, testing::ValuesIn(shapes().begin(), shapes().end()), [](const auto& info) {
  std::string name(info.param.id);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(EveryShape, is_sound) {
  const Shape& s = GetParam();
  EXPECT_EQ(find_shape(s.id)->id, s.id);
  EXPECT_LE(s.min_level, s.level);
  EXPECT_LE(s.level, s.max_level);
  for (const int level : {0, s.min_level, s.min_level + 1, s.level + 1}) {
    const MeshHandle mesh = make_shape(s, level);
    EXPECT_EQ(mesh->report(), MeshReport{}) << level;
    EXPECT_GT(mesh->data().face_count(), 0u);
    for (const glm::dvec3& n : mesh->data().normals) EXPECT_NEAR(glm::length(n), 1, 1e-14);
    for (const glm::dvec2& uv : mesh->data().uvs) {
      EXPECT_GE(std::min(uv.x, uv.y), 0);
      EXPECT_LE(uv.y, 1);
    }
    for (const Corner& c : mesh->data().corners) EXPECT_TRUE(c.normal != no_index && c.uv != no_index);
  }
}

TEST_P(EveryShape, fits_the_unit_ball) {
  const MeshHandle mesh = make_shape(GetParam());
  double radius = 0;
  for (const Corner& c : mesh->data().corners)
    radius = std::max(radius, glm::length(mesh->data().positions[c.position]));
  EXPECT_NEAR(radius, 1, 1e-12);
  EXPECT_LT(glm::length(mesh->centre()), 1e-12);
}

TEST_P(EveryShape, repeats_no_position_normal_or_uv) {
  const MeshHandle mesh = make_shape(GetParam());
  const auto repeated = [](const auto& list) {
    std::set<std::array<double, 3>> seen;
    for (const auto& v : list) seen.insert({v[0], v[1], v[v.length() - 1]});
    return list.size() - seen.size();
  };
  // The teapot's handle touches its body in a point that both have.
  EXPECT_EQ(repeated(mesh->data().positions), GetParam().id == "teapot" ? 1u : 0u);
  EXPECT_EQ(repeated(mesh->data().normals), 0u);
  EXPECT_EQ(repeated(mesh->data().uvs), 0u);
}

namespace {

// The smallest cosine between a triangle's normal and those of its corners.
double worst_cosine(const Mesh& mesh) {
  const MeshData& data = mesh.data();
  double worst = 1;
  for (const Triangle& t : mesh.triangles()) {
    std::array<glm::dvec3, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = data.positions[data.corners[t.corner[k]].position];
    const glm::dvec3 n = glm::normalize(vector_area(p));
    for (const std::uint32_t c : t.corner) worst = std::min(worst, glm::dot(n, data.normals[data.corners[c].normal]));
  }
  return worst;
}

}  // namespace

TEST_P(EveryShape, faces_and_normals_point_to_the_same_side) { EXPECT_GT(worst_cosine(*make_shape(GetParam())), 0.35); }

TEST(Shape, the_teapots_faces_come_to_have_the_normals_of_its_patches) {
  EXPECT_GT(worst_cosine(*shape("teapot", 32)), std::cos(radians(36)));
  EXPECT_GT(worst_cosine(*shape("teapot", 64)), std::cos(radians(18)));
}

// The control points that the loops came from, seen through a tessellation that someone else made of all 32 patches
// with 10 segments: every vertex there is one of ours.
TEST(Shape, the_teapot_is_the_known_one) {
  std::ifstream file(SHADEBENCH_SOURCE_DIR "/../shared/data/models/teapot.obj");
  if (!file) GTEST_SKIP() << "the model is not here";
  std::vector<glm::dvec3> theirs;
  for (std::string word; file >> word;)
    if (glm::dvec3 p; word == "v" && file >> p.x >> p.y >> p.z) theirs.push_back(p);
  ASSERT_GT(theirs.size(), 3000u);
  glm::dvec3 low = theirs[0], high = low;
  for (const glm::dvec3& p : theirs) low = glm::min(low, p), high = glm::max(high, p);
  const MeshHandle ours = shape("teapot", 10);
  const double scale = (high.x - low.x) / (ours->high().x - ours->low().x);
  double farthest = 0;
  for (const glm::dvec3& p : theirs) {
    double nearest = 1;
    for (const glm::dvec3& q : ours->data().positions)
      nearest = std::min(nearest, glm::distance(p, scale * q + 0.5 * (low + high)));
    farthest = std::max(farthest, nearest);
  }
  EXPECT_LT(farthest, 2e-6);  // their six decimals
  EXPECT_EQ(ours->triangles().size(), 6320u);
}

// Where the loops shrink to a point: the top of the knob and the middle of the bottom.
TEST(Shape, the_teapot_is_smooth_at_its_poles) {
  const MeshHandle mesh = shape("teapot");
  int poles = 0;
  for (const Corner& c : mesh->data().corners) {
    const glm::dvec3& p = mesh->data().positions[c.position];
    if (p.y != mesh->high().y && !(p.y == mesh->low().y && p.z == 0 && std::abs(p.x) < 0.1)) continue;
    EXPECT_LT(glm::distance(mesh->data().normals[c.normal], {0, p.y > 0 ? 1 : -1, 0}), 1e-15);
    ++poles;
  }
  EXPECT_EQ(poles, 2 * 4 * 10);
}

TEST(Shape, levels_are_limited_to_the_range) {
  EXPECT_EQ(shape("icosphere", -7)->triangles().size(), 80u);
  EXPECT_EQ(shape("plane", 1 << 30)->data().face_count(), 512u * 512);
  EXPECT_EQ(find_shape("dodecahedron"), nullptr);
}

// A closed surface that points outwards has a positive volume; these converge to the solid's from below.
TEST(Shape, areas_and_volumes_converge_to_the_solids) {
  const auto expect_second_order = [](std::string_view id, int coarse, double area, double volume) {
    const AreaAndVolume a = measure(*shape(id, coarse)), b = measure(*shape(id, 2 * coarse));
    EXPECT_NEAR((area - a.area) / (area - b.area), 4, 0.2) << id;
    EXPECT_NEAR((volume - a.volume) / (volume - b.volume), 4, 0.2) << id;
    EXPECT_NEAR(b.area, area, 0.01 * area) << id;
    EXPECT_NEAR(b.volume, volume, 0.01 * volume) << id;
  };
  expect_second_order("uv-sphere", 32, 4 * pi, 4 * pi / 3);
  expect_second_order("torus", 64, 4 * pi * pi * 0.7 * 0.3, 2 * pi * pi * 0.7 * 0.09);
  const double r = 0.6, h = 1.6;
  expect_second_order("cylinder", 32, 2 * pi * r * h + 2 * pi * r * r, pi * r * r * h);
  expect_second_order("cone", 32, pi * r * (r + std::hypot(r, h)), pi * r * r * h / 3);
}

// Closed forms: E. Kreyszig's volume of an icosahedron; level 3 as computed in two independent ways.
TEST(Shape, the_icosphere_has_the_area_and_volume_of_its_polyhedron) {
  const AreaAndVolume third = measure(*shape("icosphere", 3));
  EXPECT_NEAR(third.area / (4 * pi), 0.995235, 5e-7);
  EXPECT_NEAR(third.volume / (4 * pi / 3), 0.991394, 5e-7);
  EXPECT_EQ(shape("icosphere", 3)->triangles().size(), 1280u);
  EXPECT_EQ(shape("icosphere", 3)->data().positions.size(), 642u);
}

TEST(Shape, flat_ones_are_exact) {
  const double a = 2 / std::sqrt(3.0);
  for (const int level : {1, 5}) {
    EXPECT_NEAR(measure(*shape("cube", level)).area, 6 * a * a, 1e-13);
    EXPECT_NEAR(measure(*shape("cube", level)).volume, a * a * a, 1e-13);
    EXPECT_NEAR(measure(*shape("plane", level)).area, 2, 1e-13);
  }
  EXPECT_EQ(shape("cube")->data().face_count(), 6u);
  EXPECT_EQ(shape("cube")->data().positions.size(), 8u);
}

TEST(Shape, normals_are_those_of_the_equation) {
  const auto sphere = [](const glm::dvec3& p) { return glm::normalize(p); };
  EXPECT_LT(worst_normal(*shape("uv-sphere"), sphere), 1e-15);
  EXPECT_LT(worst_normal(*shape("icosphere"), sphere), 1e-15);
  const auto torus = [](const glm::dvec3& p) { return (p - 0.7 * glm::normalize(glm::dvec3(p.x, p.y, 0))) / 0.3; };
  EXPECT_LT(worst_normal(*shape("torus"), torus), 1e-14);
}

// The knot's mesh against its normals: the angle between them falls with the square of nothing but the step, so
// normals averaged over a fine mesh must agree with the formula's.
TEST(Shape, the_knots_normals_agree_with_its_faces) {
  const auto worst = [](int level) {
    const MeshHandle mesh = shape("torus-knot", level);
    const MeshData& data = mesh->data();
    std::vector<glm::dvec3> sum(data.positions.size(), glm::dvec3(0)), exact(sum);
    for (std::size_t f = 0; f < data.face_count(); ++f) {
      std::vector<glm::dvec3> polygon;
      for (std::uint32_t c = data.first_corner[f]; c < data.first_corner[f + 1]; ++c)
        polygon.push_back(data.positions[data.corners[c].position]);
      for (std::uint32_t c = data.first_corner[f]; c < data.first_corner[f + 1]; ++c) {
        sum[data.corners[c].position] += vector_area(polygon);
        exact[data.corners[c].position] = data.normals[data.corners[c].normal];
      }
    }
    double out = 0;
    for (std::size_t i = 0; i < sum.size(); ++i) out = std::max(out, glm::distance(glm::normalize(sum[i]), exact[i]));
    return out;
  };
  const double coarse = worst(32), fine = worst(64);
  EXPECT_LT(fine, 2e-3);
  EXPECT_NEAR(coarse / fine, 4, 0.5);
}

TEST(Shape, a_torus_can_have_a_million_triangles) {
  EXPECT_EQ(shape("torus", 264)->triangles().size(), 69696u);
  EXPECT_EQ(shape("torus", 500)->triangles().size(), 250000u);
  EXPECT_EQ(shape("torus", 1000)->triangles().size(), 1000000u);
}
