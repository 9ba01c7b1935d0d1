#include "shading/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <thread>

#include "math/transform.h"
#include "scene/shape.h"
#include "shading/surface_cache.h"

using namespace cg;

namespace {

constexpr NormalRule all_rules[] = {NormalRule::file, NormalRule::face, NormalRule::mean, NormalRule::area,
                                    NormalRule::angle};

MeshHandle shape(std::string_view id, int level = 0) { return make_shape(*find_shape(id), level); }

MeshHandle mesh_of(std::vector<glm::dvec3> positions, const std::vector<std::vector<std::uint32_t>>& faces) {
  MeshData data;
  data.positions = std::move(positions);
  for (const auto& face : faces) {
    std::vector<Corner> corners;
    for (const std::uint32_t i : face) corners.push_back({i, no_index, no_index});
    data.add_face(corners.data(), corners.data() + corners.size());
  }
  return Mesh::make(std::move(data));
}

std::vector<glm::dvec3> cube_corners() {
  std::vector<glm::dvec3> p;
  for (int i = 0; i < 8; ++i) p.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  return p;
}

const std::vector<std::vector<std::uint32_t>> cube_quads{{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                                                         {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};

// The mesh with its positions moved by a similarity, without the file's normals.
MeshHandle moved(const Mesh& mesh, double scale, const glm::dvec3& offset) {
  MeshData data = mesh.data();
  data.normals.clear();
  for (Corner& c : data.corners) c.normal = no_index;
  for (glm::dvec3& p : data.positions) p = p * scale + offset;
  return Mesh::make(std::move(data));
}

double largest_angle(const Surface& a, const Surface& b) {
  EXPECT_EQ(a.indices, b.indices);
  double worst = 0;
  for (std::size_t i = 0; i < std::min(a.normals.size(), b.normals.size()); ++i)
    worst = std::max(worst, double(glm::distance(a.normals[i], b.normals[i])));
  return worst;
}

void expect_sound(const Surface& s) {
  EXPECT_EQ(s.positions.size(), s.normals.size());
  EXPECT_EQ(s.indices.size(), 3 * s.triangle_count());
  for (const std::uint32_t i : s.indices) ASSERT_LT(i, s.positions.size());
  for (const glm::vec3& p : s.positions) EXPECT_TRUE(is_finite(p));
  std::size_t zero = 0;
  for (const glm::vec3& n : s.normals) {
    EXPECT_TRUE(is_finite(n));
    zero += n == glm::vec3(0);
    EXPECT_TRUE(n == glm::vec3(0) || std::abs(glm::length(n) - 1) < 1e-6f);
  }
  EXPECT_EQ(zero, s.bad_normals);
}

}  // namespace

TEST(Surface, a_cube_is_smooth_at_180_degrees_and_has_edges_at_30) {
  const MeshHandle cube = mesh_of(cube_corners(), cube_quads);
  for (const NormalRule rule : {NormalRule::mean, NormalRule::area, NormalRule::angle, NormalRule::file}) {
    const SurfaceHandle smooth = make_surface(*cube, rule, 180);
    ASSERT_EQ(smooth->positions.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i)
      EXPECT_LT(glm::distance(smooth->normals[i], smooth->positions[i] / std::sqrt(3.0f)), 1e-7f);
    // An edge of exactly the crease angle is still smooth.
    EXPECT_EQ(make_surface(*cube, rule, 90)->positions.size(), 8u);
    for (const double crease : {30.0, 89.99}) {
      const SurfaceHandle sharp = make_surface(*cube, rule, crease);
      EXPECT_EQ(sharp->positions.size(), 24u);
      for (std::size_t i = 0; i < sharp->positions.size(); ++i)
        EXPECT_FLOAT_EQ(glm::dot(sharp->normals[i], sharp->positions[i]), 1);
    }
  }
}

TEST(Surface, faces_have_vertices_of_their_own_for_flat_shading) {
  // Even where two faces lie in a plane and could share them.
  const MeshHandle plane = shape("plane", 2);
  EXPECT_EQ(make_surface(*plane, NormalRule::face, 180)->positions.size(), 16u);
  EXPECT_EQ(make_surface(*plane, NormalRule::angle, 180)->positions.size(), 9u);
}

// Grit Thürmer and Charles Wüthrich's reason for the angle: a square's two triangles count as the square.
TEST(Surface, angle_weights_do_not_see_how_quads_are_cut) {
  std::vector<std::vector<std::uint32_t>> triangles;
  for (const auto& q : cube_quads) {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[2], q[3], q[0]});
  }
  const MeshHandle quads = mesh_of(cube_corners(), cube_quads), cut = mesh_of(cube_corners(), triangles);
  const auto by_position = [](const SurfaceHandle& s) {
    std::map<std::array<float, 3>, glm::vec3> out;
    for (std::size_t i = 0; i < s->positions.size(); ++i)
      out[{s->positions[i].x, s->positions[i].y, s->positions[i].z}] = s->normals[i];
    return out;
  };
  const auto worst = [&](NormalRule rule) {
    const auto a = by_position(make_surface(*quads, rule, 180)), b = by_position(make_surface(*cut, rule, 180));
    double out = 0;
    for (const auto& [p, n] : a) out = std::max(out, double(glm::distance(n, b.at(p))));
    return out;
  };
  EXPECT_LT(worst(NormalRule::angle), 1e-7);
  EXPECT_GT(worst(NormalRule::mean), 0.1);
}

TEST(Surface, the_angle_of_a_concave_corner_is_the_inner_one) {
  // A notched face and a wall on its notch: 270 degrees of the face stand against 90 of the wall.
  const MeshHandle mesh =
      mesh_of({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {1, 1, -1}, {1, 0, -1}},
              {{6, 1, 2, 3, 4, 5}, {6, 5, 7, 8}});
  ASSERT_EQ(mesh->report(), MeshReport{});
  const SurfaceHandle s = make_surface(*mesh, NormalRule::angle, 180);
  bool found = false;
  for (std::size_t i = 0; i < s->positions.size(); ++i)
    if (s->positions[i] == glm::vec3(1, 1, 0)) {
      found = true;
      EXPECT_LT(glm::distance(s->normals[i], glm::normalize(glm::vec3(-1, 0, 3))), 1e-6f);
    }
  EXPECT_TRUE(found);
}

TEST(Surface, a_crease_follows_edges_around_the_vertex) {
  const MeshHandle cylinder = shape("cylinder", 16);
  const SurfaceHandle s = make_surface(*moved(*cylinder, 1, {0, 0, 0}), NormalRule::angle, 30);
  const SurfaceHandle exact = make_surface(*cylinder, NormalRule::file, 180);
  EXPECT_LT(largest_angle(*s, *exact), 1e-6);
}

TEST(Surface, averages_approach_the_exact_normals) {
  for (const char* id : {"uv-sphere", "icosphere", "torus"})
    for (const NormalRule rule : {NormalRule::mean, NormalRule::area, NormalRule::angle}) {
      const MeshHandle mesh = shape(id);
      const SurfaceHandle exact = make_surface(*mesh, NormalRule::file, 180);
      const SurfaceHandle averaged = make_surface(*moved(*mesh, 1, {0, 0, 0}), rule, 180);
      EXPECT_LT(largest_angle(*exact, *averaged), 0.03) << id;
    }
}

TEST(Surface, the_files_normals_are_taken_as_they_are) {
  MeshData data = mesh_of(cube_corners(), cube_quads)->data();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  data.normals = {{0, 0, 2}, {0, 0, 0}, {nan, 0, 1}, {1e-40, 0, 0}};
  const auto corner = [&](std::uint32_t position, std::uint32_t normal) {
    for (std::size_t c = data.first_corner[4]; c < data.first_corner[5]; ++c)
      if (data.corners[c].position == position) data.corners[c].normal = normal;
  };
  corner(4, 0), corner(5, 1), corner(6, 2), corner(7, 3);
  const SurfaceHandle s = make_surface(*Mesh::make(data), NormalRule::file, 180);
  EXPECT_EQ(s->bad_normals, 2u);
  // The other faces' corners have none: they are averaged by angle.
  EXPECT_EQ(s->positions.size(), 12u);
  const auto has = [&](const glm::vec3& n) { return std::count(s->normals.begin(), s->normals.end(), n); };
  EXPECT_EQ(has({0, 0, 2}), 1);
  EXPECT_EQ(has({1, 0, 0}), 1);
  EXPECT_EQ(has({0, 0, 0}), 2);
}

// 1e-20 and 1e20 leave float's range when squared; 1e6 leaves it 1/16 of a unit.
TEST(Surface, size_and_place_do_not_change_the_normals) {
  for (const char* id : {"torus", "teapot", "cube"}) {
    const MeshHandle mesh = shape(id);
    for (const NormalRule rule : all_rules) {
      const SurfaceHandle unit = make_surface(*moved(*mesh, 1, {0, 0, 0}), rule, 40);
      expect_sound(*unit);
      EXPECT_EQ(unit->centre, glm::dvec3(0));
      EXPECT_EQ(unit->radius, 1);
      for (const double scale : {1e-300, 1e-20, 1e20, 1e300}) {
        const SurfaceHandle scaled = make_surface(*moved(*mesh, scale, {0, 0, 0}), rule, 40);
        expect_sound(*scaled);
        EXPECT_LT(largest_angle(*unit, *scaled), 1e-6) << id << " " << scale;
      }
      const MeshHandle far = moved(*mesh, 1, {1e6, -1e6, 1e6});
      const SurfaceHandle surveyed = make_surface(*far, rule, 40);
      expect_sound(*surveyed);
      EXPECT_LT(largest_angle(*unit, *surveyed), 1e-5) << id;
      for (std::size_t i = 0; i < unit->positions.size(); ++i)
        ASSERT_LT(glm::distance(unit->positions[i], surveyed->positions[i]), 1e-6f);
    }
  }
}

TEST(Surface, to_mesh_leads_back) {
  const MeshHandle mesh = moved(*shape("cube"), 1e-9, {3e-7, 0, 5e-7});
  const SurfaceHandle s = make_surface(*mesh, NormalRule::angle, 180);
  EXPECT_NE(s->centre, glm::dvec3(0));
  glm::dvec3 low(1), high(-1);
  for (const glm::vec3& p : s->positions) {
    const glm::dvec3 q(s->to_mesh() * glm::dvec4(p, 1));
    low = glm::min(low, q), high = glm::max(high, q);
  }
  EXPECT_LT(glm::distance(low, mesh->low()), 1e-15);
  EXPECT_LT(glm::distance(high, mesh->high()), 1e-15);
}

TEST(Surface, triangles_that_repeat_their_vertices_are_smooth_all_the_same) {
  const MeshHandle mesh = moved(*shape("icosphere"), 1, {0, 0, 0});
  MeshData soup;
  for (const Corner& c : mesh->data().corners) {
    soup.corners.push_back({std::uint32_t(soup.positions.size()), no_index, no_index});
    soup.positions.push_back(mesh->data().positions[c.position]);
  }
  soup.first_corner = mesh->data().first_corner;
  const SurfaceHandle a = make_surface(*mesh, NormalRule::angle, 60),
                      b = make_surface(*Mesh::make(soup), NormalRule::angle, 60);
  EXPECT_EQ(a->positions, b->positions);
  EXPECT_EQ(a->normals, b->normals);
}

TEST(Surface, two_sides_of_a_sheet_do_not_cancel_out) {
  const MeshHandle sheet = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}});
  const SurfaceHandle s = make_surface(*sheet, NormalRule::angle, 180);
  EXPECT_EQ(s->bad_normals, 0u);
  EXPECT_EQ(s->normals[s->indices[0]], glm::vec3(0, 0, 1));
  EXPECT_EQ(s->normals[s->indices[3]], glm::vec3(0, 0, -1));
}

TEST(Surface, slivers_leave_their_neighbours_alone) {
  const MeshHandle mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 1e-30, 0}, {0.5, 0, 1e-9}},
                                  {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {1, 1, 0}});
  EXPECT_EQ(mesh->report().degenerate_faces, 2u);
  for (const NormalRule rule : all_rules)
    for (const double crease : {0.0, 60.0, 180.0}) {
      const SurfaceHandle s = make_surface(*mesh, rule, crease);
      expect_sound(*s);
      EXPECT_EQ(s->triangle_count(), 2u);
      EXPECT_EQ(s->bad_normals, 0u);
    }
}

TEST(Surface, nothing_comes_of_nothing) {
  for (const NormalRule rule : all_rules) {
    EXPECT_EQ(make_surface(*Mesh::make({}), rule, 180)->triangle_count(), 0u);
    const SurfaceHandle point = make_surface(*mesh_of({{7, 7, 7}}, {{0, 0, 0}}), rule, 180);
    EXPECT_EQ(point->triangle_count(), 0u);
    EXPECT_TRUE(point->positions.empty());
  }
}

TEST(Surface, a_faces_last_corner_comes_last_in_its_triangles) {
  const MeshHandle cube = mesh_of(cube_corners(), cube_quads);
  const SurfaceHandle s = make_surface(*cube, NormalRule::face, 180);
  ASSERT_EQ(s->triangle_count(), 12u);
  for (std::size_t t = 0; t < 12; ++t) {
    EXPECT_EQ(s->triangle[t], t);
    EXPECT_EQ(glm::dvec3(s->positions[s->indices[3 * t + 2]]), cube_corners()[cube_quads[t / 2][3]]);
  }
}

TEST(SurfaceCache, tells_meshes_of_one_owner_apart) {
  SurfaceCache cache;
  const auto model = std::make_shared<std::pair<MeshHandle, MeshHandle>>(shape("cube"), shape("plane"));
  const MeshHandle first(model, model->first.get()), second(model, model->second.get());
  EXPECT_EQ(cache.get(first, NormalRule::face, 180)->triangle_count(), 12u);
  EXPECT_NE(cache.get(second, NormalRule::face, 180), cache.get(first, NormalRule::face, 180));
}

TEST(SurfaceCache, makes_each_surface_once_and_forgets_those_of_lost_meshes) {
  SurfaceCache cache(2);
  MeshHandle mesh = shape("cube");
  std::vector<SurfaceHandle> got(4);
  {
    std::vector<std::jthread> threads;
    for (SurfaceHandle& s : got) threads.emplace_back([&] { s = cache.get(mesh, NormalRule::angle, 30); });
  }
  for (const SurfaceHandle& s : got) EXPECT_EQ(s, got[0]);
  EXPECT_NE(cache.get(mesh, NormalRule::angle, 31), got[0]);
  EXPECT_EQ(cache.get(mesh, NormalRule::angle, 30), got[0]);
  EXPECT_EQ(cache.get(mesh, NormalRule::face, 30), cache.get(mesh, NormalRule::face, 60));
  EXPECT_NE(cache.get(mesh, NormalRule::angle, 31), nullptr);
  const std::weak_ptr<const Surface> first = got[0];
  got.clear();
  EXPECT_TRUE(first.expired());  // two others were used since
  const std::weak_ptr<const Surface> last = cache.get(mesh, NormalRule::angle, 31);
  mesh.reset();
  cache.get(shape("plane"), NormalRule::face, 180);
  EXPECT_TRUE(last.expired());
}
