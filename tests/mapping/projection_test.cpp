// Automatic mapping against closed forms: sphere, cylinder, cube, plane; seams, poles, and meshes at the extremes.
#include "mapping/projection.h"

#include <gtest/gtest.h>

#include <set>

#include "params/slots.h"
#include "scene/shape.h"

namespace cg {
namespace {

MeshHandle shape(const char* id) { return make_shape(*find_shape(id)); }

// Calls `check(position, uv)` for each corner.
template <class Check>
void at_each_corner(const Mesh& mesh, const CornerUv& uv, const Check& check) {
  ASSERT_EQ(uv.size(), mesh.data().corners.size());
  for (std::size_t c = 0; c < uv.size(); ++c) check(mesh.data().positions[mesh.data().corners[c].position], uv[c]);
}

double widest_face(const MeshData& data, const CornerUv& uv) {
  double widest = 0;
  for (std::size_t f = 0; f < data.face_count(); ++f)
    for (std::uint32_t c = data.first_corner[f]; c < data.first_corner[f + 1]; ++c)
      widest = std::max(widest, std::abs(uv[c].x - uv[data.first_corner[f]].x));
  return widest;
}

class Spheres : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Mapping, Spheres, testing::Values("uv-sphere", "icosphere"),
                         [](const auto& info) { return std::string(info.param) == "icosphere" ? "ico" : "uv"; });

TEST_P(Spheres, PolarIsLongitudeAndLatitude) {
  const MeshHandle mesh = shape(GetParam());
  const Projector p = fitting_projector(ProjectionShape::spherical, *mesh);
  EXPECT_EQ(p.place.translate, glm::dvec3(0));
  const CornerUv uv = projected_uv(mesh->data(), p);
  std::size_t beyond = 0;
  at_each_corner(*mesh, uv, [&](const glm::dvec3& x, const glm::dvec2& t) {
    // x = (sin theta cos phi, -cos theta, -sin theta sin phi) with phi = 2 pi u, theta = pi v
    const double theta = pi * t.y, phi = 2 * pi * t.x;
    const glm::dvec3 expected{std::sin(theta) * std::cos(phi), -std::cos(theta), -std::sin(theta) * std::sin(phi)};
    EXPECT_LT(glm::length(glm::normalize(x) - expected), 1e-9);
    EXPECT_GE(t.x, 0);
    EXPECT_LT(t.x, 1.5);
    beyond += t.x > 1;
  });
  // No face smears over the seam: none is wider than its neighbours are.
  EXPECT_LT(widest_face(mesh->data(), uv), 0.26);
  if (std::string(GetParam()) == "uv-sphere") {
    EXPECT_EQ(beyond, 0u);  // its columns end at the seam
  } else {
    EXPECT_GT(beyond, 0u);
  }
}

TEST(Mapping, EachTriangleAtAPoleHasItsOwnU) {
  const MeshHandle mesh = shape("uv-sphere");
  const CornerUv uv = projected_uv(mesh->data(), fitting_projector(ProjectionShape::spherical, *mesh));
  const MeshData& data = mesh->data();
  std::set<double> at_pole;
  std::size_t triangles = 0;
  for (std::size_t f = 0; f < data.face_count(); ++f) {
    const std::uint32_t begin = data.first_corner[f], n = data.first_corner[f + 1] - begin;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (data.positions[data.corners[begin + i].position].y < 0.999999) continue;
      ++triangles;
      const double next = uv[begin + (i + 1) % n].x, last = uv[begin + (i + n - 1) % n].x;
      EXPECT_NEAR(uv[begin + i].x, 0.5 * (next + last), 1e-12);
      EXPECT_NEAR(std::abs(next - last), 1.0 / 64, 1e-9);
      at_pole.insert(uv[begin + i].x);
    }
  }
  EXPECT_EQ(triangles, 64u);
  EXPECT_EQ(at_pole.size(), 64u);
}

TEST(Mapping, CylinderUnrolls) {
  const MeshHandle mesh = shape("cylinder");
  const CornerUv uv = projected_uv(mesh->data(), fitting_projector(ProjectionShape::cylindrical, *mesh));
  at_each_corner(*mesh, uv, [&](const glm::dvec3& x, const glm::dvec2& t) {
    EXPECT_NEAR(t.y, (x.y / mesh->high().y + 1) / 2, 1e-12);
    const double r = std::hypot(x.x, x.z);
    if (r < 1e-9) return;
    EXPECT_NEAR(std::cos(2 * pi * t.x), x.x / r, 1e-9);
    EXPECT_NEAR(std::sin(2 * pi * t.x), -x.z / r, 1e-9);
  });
  EXPECT_LT(widest_face(mesh->data(), uv), 0.03);
}

TEST(Mapping, BoxIsTheCubesOwnUv) {
  const MeshHandle mesh = shape("cube");
  const CornerUv uv = projected_uv(mesh->data(), fitting_projector(ProjectionShape::box, *mesh)),
                 own = corner_uv(mesh->data());
  ASSERT_EQ(uv.size(), own.size());
  for (std::size_t c = 0; c < uv.size(); ++c) EXPECT_LT(glm::length(uv[c] - own[c]), 1e-12);
}

TEST(Mapping, PlanarIsThePlanesOwnUv) {
  const MeshHandle mesh = shape("plane");
  const Projector p = fitting_projector(ProjectionShape::planar, *mesh);
  const CornerUv own = corner_uv(mesh->data());
  CornerUv uv = projected_uv(mesh->data(), p);
  for (std::size_t c = 0; c < uv.size(); ++c) EXPECT_LT(glm::length(uv[c] - own[c]), 1e-12);
  Projector moved = p;
  moved.place.translate.x += 1, moved.repeat_u = 3;
  uv = projected_uv(mesh->data(), moved);
  for (std::size_t c = 0; c < uv.size(); ++c) EXPECT_NEAR(uv[c].x, 3 * (own[c].x - 0.5 / p.place.scale.x), 1e-12);
}

// A turned projector sees what an object turned the other way shows to the unturned one.
TEST(Mapping, ProjectorTurnsAsObjectsDo) {
  const MeshHandle mesh = shape("teapot");
  Projector p;
  p.place = {{0.1, -0.2, 0.3}, {20, 30, 40}, {0.5, 2, 0.7}};
  MeshData back = mesh->data();
  const glm::dmat4 inverse = glm::inverse(matrix(p.place));
  for (glm::dvec3& x : back.positions) x = glm::dvec3(inverse * glm::dvec4(x, 1));
  for (const auto kind : {ProjectionShape::planar, ProjectionShape::cylindrical, ProjectionShape::spherical}) {
    p.shape = kind;
    Projector still;
    still.shape = kind;
    const CornerUv a = projected_uv(mesh->data(), p), b = projected_uv(back, still);
    for (std::size_t c = 0; c < a.size(); ++c) {
      EXPECT_NEAR(a[c].y, b[c].y, 1e-9);
      const double u = a[c].x - b[c].x;
      EXPECT_NEAR(u, std::round(u), 1e-7);
    }
  }
}

TEST(Mapping, FromViewIsThePicture) {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 10}};
  const Corner face[] = {{0}, {1}, {2}}, behind[] = {{0}, {1}, {3}};
  data.add_face(face, face + 3), data.add_face(behind, behind + 3);
  Projector p;
  p.shape = ProjectionShape::view, p.aspect = 2;
  p.view.position = {0, 0, 2}, p.view.fov = 90;
  const CornerUv uv = projected_uv(data, p);
  EXPECT_LT(glm::length(uv[0] - glm::dvec2(0.5, 0.5)), 1e-12);
  EXPECT_LT(glm::length(uv[1] - glm::dvec2(0.5 + 0.5 / 4, 0.5)), 1e-12);  // tan 45 = 1: x/(2 * 2), y/2
  EXPECT_LT(glm::length(uv[2] - glm::dvec2(0.5, 0.5 + 0.5 / 2)), 1e-12);
  EXPECT_TRUE(std::isfinite(uv[5].x) && std::isfinite(uv[5].y));
}

TEST(Mapping, EveryUvIsFinite) {
  MeshData data;
  const double big = 1.7e308, small = 5e-324;
  data.positions = {{0, 0, 0}, {big, big, big}, {-big, big, -big}, {small, 0, 0}, {0, small, -small}, {1, 0, 0}};
  for (std::uint32_t a = 0; a < 6; ++a)
    for (std::uint32_t b = 0; b < 6; ++b) {
      const Corner face[] = {{a}, {b}, {5 - a}, {(a + b) % 6}};
      data.add_face(face, face + 4);
    }
  const MeshHandle mesh = Mesh::make(data);
  for (int kind = 0; kind < 5; ++kind) {
    std::vector<Projector> projectors{fitting_projector(ProjectionShape(kind), *mesh), {}, {}, {}};
    projectors[1].place.scale = {0, 0, 0};
    projectors[2].place.scale = {1e-30, -1e30, 1e-300}, projectors[2].repeat_u = 1e4;
    projectors[3].place.translate = {1e30, -1e30, 1e30};
    for (Projector& p : projectors) {
      p.shape = ProjectionShape(kind);
      for (const glm::dvec2& t : projected_uv(mesh->data(), p)) EXPECT_TRUE(std::isfinite(t.x) && std::isfinite(t.y));
    }
  }
}

TEST(Mapping, ASizeOrAPlaceFarAwayChangesNothing) {
  const MeshHandle mesh = shape("torus");
  for (int kind = 0; kind < 4; ++kind) {
    const CornerUv plain = projected_uv(mesh->data(), fitting_projector(ProjectionShape(kind), *mesh));
    for (const double size : {1e-20, 1e20}) {
      MeshData scaled = mesh->data();
      for (glm::dvec3& x : scaled.positions) x *= size;
      const MeshHandle other = Mesh::make(scaled);
      const CornerUv uv = projected_uv(other->data(), fitting_projector(ProjectionShape(kind), *other));
      for (std::size_t c = 0; c < uv.size(); ++c) EXPECT_LT(glm::length(uv[c] - plain[c]), 1e-9);
    }
  }
}

TEST(Mapping, UvsAreIndexedOnceEach) {
  const MeshHandle mesh = shape("cube");
  const MeshData again = with_corner_uv(mesh->data(), corner_uv(mesh->data()));
  EXPECT_EQ(again.uvs.size(), 4u);
  EXPECT_EQ(corner_uv(again), corner_uv(mesh->data()));
  EXPECT_EQ(again.positions, mesh->data().positions);
}

TEST(Mapping, ProjectorAndSeamsAreDescribed) {
  Projector p;
  EXPECT_EQ(find_slot(slots(p), "place.rotate").path, "place.rotate");
  Unwrapping u;
  u.seams = {{1, 2}, {3, 4}};
  EXPECT_EQ(to_json(values_of(slots(u))).find("null"), std::string::npos);
  assign_text(find_slot(slots(u), "seams.1.b"), "7");
  EXPECT_EQ(u.seams[1], (SeamEdge{3, 7}));
}

}  // namespace
}  // namespace cg
