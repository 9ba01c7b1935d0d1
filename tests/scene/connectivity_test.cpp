#include "scene/connectivity.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "math/transform.h"
#include "scene/model_file.h"
#include "scene/shape.h"

using namespace cg;

namespace {

MeshHandle shape(std::string_view id, int level = 0) { return make_shape(*find_shape(id), level); }

MeshHandle mesh_of(std::size_t positions, const std::vector<std::vector<std::uint32_t>>& faces) {
  MeshData data;
  // On a curve of which no three points lie on a line.
  for (std::size_t i = 0; i < positions; ++i) data.positions.emplace_back(double(i), double(i * i), double(i * i * i));
  for (const auto& face : faces) {
    std::vector<Corner> corners;
    for (const std::uint32_t i : face) corners.push_back({i, no_index, no_index});
    data.add_face(corners.data(), corners.data() + corners.size());
  }
  return Mesh::make(std::move(data));
}

using Faces = std::vector<std::uint32_t>;

}  // namespace

// V - E + F: 2 for a sphere, 0 for a torus, one less for each hole.
TEST(Topology, shapes_are_closed_and_wound_one_way) {
  for (const auto& [id, characteristic] : {std::pair{"uv-sphere", 2},
                                           {"icosphere", 2},
                                           {"torus", 0},
                                           {"torus-knot", 0},
                                           {"cube", 2},
                                           {"cylinder", 2},
                                           {"cone", 2}}) {
    for (const int level : {0, 3, 5}) {
      const MeshHandle mesh = shape(id, level);
      const Topology t = topology(*mesh);
      EXPECT_EQ(t.euler_characteristic(), characteristic) << id;
      EXPECT_TRUE(t.closed() && t.consistently_wound()) << id;
      EXPECT_EQ(t.vertices, mesh->data().positions.size()) << id;
      const Connectivity c(mesh);
      EXPECT_TRUE(c.refused_faces().empty()) << id;
      EXPECT_EQ(c.boundary_edges(), 0u) << id;
      EXPECT_EQ(c.boundary_loops(), 0u) << id;
    }
  }
  EXPECT_EQ(topology(*shape("plane")).euler_characteristic(), 1);
  EXPECT_EQ(Connectivity(shape("plane", 7)).boundary_edges(), 28u);
}

// A body open at the rim, a lid open below, a handle and a spout open at both ends.
TEST(Topology, the_teapot_has_six_rims) {
  for (const int level : {2, 3, 10}) {
    const MeshHandle teapot = shape("teapot", level);
    const Topology t = topology(*teapot);
    EXPECT_EQ(t.euler_characteristic(), 1 + 1 + 0 + 0);
    EXPECT_TRUE(t.consistently_wound());
    const Connectivity c(teapot);
    EXPECT_TRUE(c.refused_faces().empty());
    EXPECT_EQ(c.boundary_loops(), 6u);
    EXPECT_EQ(t.boundary_edges, std::size_t(level) * (4 + 4 + 2 * 2 + 2 * 2));
    EXPECT_EQ(c.boundary_edges(), t.boundary_edges);
  }
}

TEST(Topology, tells_faces_that_are_inside_out) {
  // A tetrahedron, then with one face turned.
  EXPECT_TRUE(topology(*mesh_of(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})).consistently_wound());
  const Topology t = topology(*mesh_of(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 2, 3}}));
  EXPECT_EQ(t.flipped_edges, 3u);
  EXPECT_EQ(t.crowded_edges, 0u);
  EXPECT_TRUE(t.closed());
}

TEST(Topology, counts_edges_of_three_faces) {
  const Topology t = topology(*mesh_of(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(t.crowded_edges, 1u);
  EXPECT_EQ(t.boundary_edges, 6u);
  EXPECT_EQ(t.flipped_edges, 0u);
}

TEST(Connectivity, refuses_what_is_not_manifold_and_keeps_the_rest) {
  // An edge of three faces; a face the wrong way; the same face again.
  EXPECT_EQ(Connectivity(mesh_of(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})).refused_faces(), Faces{2});
  EXPECT_EQ(Connectivity(mesh_of(4, {{0, 1, 2}, {0, 1, 3}})).refused_faces(), Faces{1});
  EXPECT_EQ(Connectivity(mesh_of(3, {{0, 1, 2}, {0, 1, 2}})).refused_faces(), Faces{1});
  // A closed fan around vertex 0, then one more face at it.
  EXPECT_EQ(Connectivity(mesh_of(6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}})).refused_faces(), Faces{3});
  // Two fans that meet in a vertex are manifold enough while both are open.
  EXPECT_TRUE(Connectivity(mesh_of(5, {{0, 1, 2}, {0, 3, 4}})).refused_faces().empty());
}

TEST(Connectivity, survives_degenerate_faces) {
  const MeshHandle mesh = mesh_of(6, {{0, 0, 0}, {}, {1, 2}, {0, 1, 2}, {0, 1, 0, 2}, {3, 4, 3, 5}, {2, 1, 3}, {5, 5}});
  const Connectivity c(mesh);
  const Faces& refused = c.refused_faces();
  EXPECT_TRUE(std::is_sorted(refused.begin(), refused.end()));
  for (const std::uint32_t f : {0, 1, 2, 4, 5, 7}) EXPECT_TRUE(std::count(refused.begin(), refused.end(), f)) << f;
  for (const std::uint32_t f : {3, 6}) EXPECT_FALSE(std::count(refused.begin(), refused.end(), f)) << f;
  EXPECT_TRUE(Connectivity(Mesh::make({})).refused_faces().empty());
}

TEST(Connectivity, walks_around_a_vertex) {
  const MeshHandle cube = shape("cube");
  const Connectivity c(cube);
  for (std::uint32_t p = 0; p < 8; ++p) {
    Faces around = c.faces_around(p), expected;
    for (std::uint32_t f = 0; f < 6; ++f)
      for (std::uint32_t k = cube->data().first_corner[f]; k < cube->data().first_corner[f + 1]; ++k)
        if (cube->data().corners[k].position == p) expected.push_back(f);
    std::sort(around.begin(), around.end());
    EXPECT_EQ(around, expected);
  }
  EXPECT_TRUE(c.faces_around(99).empty());
  // Clockwise: each face is followed by the one on the other side of the edge that leaves the vertex.
  const Connectivity fan(mesh_of(5, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}));
  Faces around = fan.faces_around(0);
  std::rotate(around.begin(), std::max_element(around.begin(), around.end()), around.end());
  EXPECT_EQ(around, (Faces{3, 2, 1, 0}));
}

TEST(Connectivity, measures_the_bend_of_an_edge_at_any_size) {
  for (const double scale : {1e-300, 1e-20, 1.0, 1e20, 1e300}) {
    MeshData data = shape("cube")->data();
    for (glm::dvec3& p : data.positions) p *= scale;
    const MeshHandle cube = Mesh::make(data);
    const Connectivity c(cube);
    std::size_t edges = 0;
    for (std::uint32_t a = 0; a < 8; ++a)
      for (std::uint32_t b = a + 1; b < 8; ++b)
        if (const auto bend = c.bend(a, b)) {
          EXPECT_NEAR(*bend, pi / 2, 1e-15);
          ++edges;
        }
    EXPECT_EQ(edges, 12u);
  }
  const Connectivity plane(shape("plane", 2));
  EXPECT_FALSE(plane.bend(0, 1));
  EXPECT_FALSE(plane.bend(0, 77));
}

// The cow has a vertex where two closed fans meet; the bunny has the holes of its scan.
TEST(Connectivity, real_models_are_taken_but_for_the_faces_that_are_not_manifold) {
  const std::filesystem::path folder = SHADEBENCH_SOURCE_DIR "/../shared/data/models";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the models are not here";
  struct Known {
    const char* file;
    std::size_t faces, boundary_edges, refused;
  };
  for (const Known& k : {Known{"fandisk.obj", 12946, 0, 0},
                         {"spot.obj", 5856, 0, 0},
                         {"cow.obj", 5804, 0, 4},
                         {"stanford-bunny.obj", 69451, 223, 0}}) {
    const Model model = read_model(folder / k.file);
    const MeshHandle mesh = model.parts.at(0).mesh;
    const Topology t = topology(*mesh);
    EXPECT_TRUE(t.consistently_wound()) << k.file;
    EXPECT_EQ(t.faces, k.faces) << k.file;
    EXPECT_EQ(t.boundary_edges, k.boundary_edges) << k.file;
    EXPECT_EQ(Connectivity(mesh).refused_faces().size(), k.refused) << k.file;
    EXPECT_TRUE(!t.closed() || k.refused > 0 || t.euler_characteristic() == 2) << k.file;
  }
}
