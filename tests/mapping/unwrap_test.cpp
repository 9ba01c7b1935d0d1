// Unwraps: developable surfaces come out exact, every bundled model and the field's meshes without flips or overlaps,
// and what is no surface is refused in words.
#include "mapping/unwrap.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "mapping/cut_to_disk.h"
#include "mapping/flatten.h"
#include "mapping/pack.h"
#include "mapping/simple_border.h"
#include "math/counter_random.h"
#include "math/transform.h"
#include "params/input_error.h"
#include "scene/bundled_models.h"
#include "scene/model_file.h"
#include "scene/shape.h"

namespace cg {
namespace {

MeshHandle shape(const char* id, int level = 0) { return make_shape(*find_shape(id), level); }

// The whole mesh as one chart, opened where it has to be.
ChartMesh opened(const MeshHandle& mesh, const std::vector<SeamEdge>& seams = {}) {
  const UnwrapSurface s(mesh, "");
  EdgeCuts cuts = border_cuts(s);
  cut_seams(s, seams, cuts);
  const ChartFaces charts = charts_between(s, cuts);
  EXPECT_EQ(charts.faces.size(), 1u);
  std::vector<std::uint32_t> vertex_of(s.corner_count());
  cut_to_disk(s, charts.faces[0], cuts, vertex_of);
  ChartMesh out = make_chart_mesh(s, cuts, charts.faces[0], vertex_of);
  EXPECT_TRUE(is_disk(out, charts.faces[0].size()));
  return out;
}

MeshHandle quads(int columns, int rows, const std::function<glm::dvec3(int, int)>& at) {
  MeshData data;
  for (int y = 0; y <= rows; ++y)
    for (int x = 0; x <= columns; ++x) data.positions.push_back(at(x, y));
  const auto corner = [&](int x, int y) { return Corner{std::uint32_t(y * (columns + 1) + x)}; };
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const Corner face[] = {corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)};
      data.add_face(face, face + 4);
    }
  return Mesh::make(data);
}

TEST(Distortion, OfLinearMapsIsKnown) {
  const FlatTriangle t = lay_flat({0, 0, 0}, {2, 0, 0}, {0.5, 3, 0});
  EXPECT_DOUBLE_EQ(t.area(), 3);
  // (x, y) -> (3x, y/2), then turned: singular values 3 and 1/2.
  const auto map = [](double x, double y) {
    const double c = std::cos(0.7), s = std::sin(0.7);
    return glm::dvec2(c * 3 * x - s * y / 2, s * 3 * x + c * y / 2);
  };
  const Stretch s = stretch_of(t, map(0, 0), map(2, 0), map(0.5, 3));
  EXPECT_NEAR(s.sigma_1, 3, 1e-12);
  EXPECT_NEAR(s.sigma_2, 0.5, 1e-12);
  EXPECT_NEAR(s.quasi_conformal(), 6, 1e-12);
  const Stretch flipped = stretch_of(t, map(0, 0), map(-2, 0), map(-0.5, 3));
  EXPECT_LT(flipped.area_scale(), 0);
  DistortionSum sum;
  sum.add(s), sum.add(flipped);
  EXPECT_EQ(sum.flipped, 1u);
  // Half of the area four times as large as the other: sqrt(mean(1, 4) mean(1, 1/4)) = 1.25.
  DistortionSum two;
  two.add({1, 1, 1}), two.add({2, 2, 1});
  EXPECT_NEAR(two.area_distortion(), 1.25, 1e-12);
}

TEST(SimpleBorder, FindsCrossingsAndTouches) {
  const auto simple = [](std::vector<glm::dvec2> p) { return is_simple_polygon(p); };
  EXPECT_TRUE(simple({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_TRUE(simple({{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_FALSE(simple({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));          // a bow tie
  EXPECT_FALSE(simple({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));  // a corner on a side
  EXPECT_FALSE(simple({{0, 0}, {2, 0}, {1, 0}, {1, 1}}));          // folds back
  EXPECT_FALSE(simple({{0, 0}, {1, 0}, {NAN, 1}}));
  std::vector<glm::dvec2> spiral;  // three turns out and back, 0.2 beside itself
  for (int i = 0; i < 600; ++i)
    spiral.push_back((1 + i * 0.005) * glm::dvec2(std::cos(i * .0314), std::sin(i * .0314)));
  for (int i = 599; i >= 0; --i)
    spiral.push_back((1.2 + i * 0.005) * glm::dvec2(std::cos(i * .0314), std::sin(i * .0314)));
  EXPECT_TRUE(simple(spiral));
  for (std::size_t i = 600; i < spiral.size(); ++i) spiral[i] *= 2.2 / 1.2;
  EXPECT_FALSE(simple(spiral));
}

TEST(CutToDisk, OpensHolesHandlesAndSpheres) {
  for (const char* id : {"torus", "torus-knot", "uv-sphere", "cube", "cylinder"}) opened(shape(id));
  // A tube: an annulus, opened by a single straight line of edges.
  const MeshHandle tube = quads(
      24, 5, [](int x, int y) { return glm::dvec3(std::cos(x % 24 * pi / 12), 0.3 * y, -std::sin(x % 24 * pi / 12)); });
  MeshData data = tube->data();
  for (Corner& c : data.corners)
    if (c.position % 25 == 24) c.position -= 24;
  const ChartMesh chart = opened(Mesh::make(data));
  EXPECT_EQ(chart.position.size(), 6u * 25u);
  // Which rolls out to a rectangle, exactly.
  for (const UnwrapMethod m : {UnwrapMethod::lscm, UnwrapMethod::spectral, UnwrapMethod::free_boundary}) {
    const FlatChart flat = flatten(chart, m);
    EXPECT_TRUE(flat.injective());
    const double tolerance = m == UnwrapMethod::free_boundary ? 1e-2 : 1e-6;  // it stops where it gains little
    EXPECT_NEAR(flat.distortion.worst_quasi_conformal, 1, tolerance);
    EXPECT_NEAR(flat.distortion.area_distortion(), 1, tolerance);
  }
}

TEST(Flatten, KeepsTheAnglesOfAHemisphere) {
  // The conformal map of a cap of the sphere is the stereographic one, up to the mesh: mean distortion towards 1 as the
  // mesh gets finer, by h².
  const auto cap = [](int n) {
    return quads(n, n, [&](int x, int y) {
      const glm::dvec2 p{2.0 * x / n - 1, 2.0 * y / n - 1};
      return unit(glm::dvec3(p, 1.0));
    });
  };
  double error[2];
  for (int k = 0; k < 2; ++k)
    error[k] = flatten(opened(cap(8 << k)), UnwrapMethod::lscm).distortion.mean_quasi_conformal() - 1;
  EXPECT_LT(error[0], 0.1);
  EXPECT_LT(error[1], 0.6 * error[0]);
}

TEST(Flatten, FlipFreeMethodsFlipNothing) {
  // A closed surface opened along one line: conformal maps may fail here, these may not.
  for (const char* id : {"uv-sphere", "torus", "cube", "cone"}) {
    const ChartMesh chart = opened(shape(id));
    const FlatChart round = flatten(chart, UnwrapMethod::mean_value),
                    free = flatten(chart, UnwrapMethod::free_boundary);
    EXPECT_EQ(round.distortion.flipped, 0u) << id;
    EXPECT_TRUE(round.simple_border) << id;
    EXPECT_EQ(free.distortion.flipped, 0u) << id;
    EXPECT_LE(free.distortion.area_distortion(), round.distortion.area_distortion()) << id;
  }
}

void expect_good(const UvLayout& layout, const std::string& name, double least_share = 0.2) {
  const LayoutFigures f = figures_of(layout);
  EXPECT_EQ(f.distortion.flipped, 0u) << name;
  EXPECT_EQ(f.overlapping_pixels, 0u) << name;
  EXPECT_LE(f.distortion.mean_quasi_conformal(), 1.1) << name;
  EXPECT_GT(f.share_used(), least_share) << name;
  for (const glm::dvec2& p : layout.uv) {
    EXPECT_GE(std::min(p.x, p.y), 0) << name;
    EXPECT_LE(std::max(p.x, p.y), 1) << name;
  }
}

TEST(Unwrap, EveryShape) {
  for (const Shape& s : shapes())
    for (const int level : {0, s.min_level}) expect_good(unwrap(make_shape(s, level), {}), std::string(s.id));
}

TEST(Unwrap, EveryBundledModel) {
  for (const BundledFile& file : bundled_models()) {
    if (!file.name.ends_with(".obj")) continue;
    for (const ModelPart& part : read_obj(file.text, file.name, {}).parts)
      // The corridor's walls are strips of 1 : 16: alone in the square they fill at most a sixteenth of it.
      expect_good(unwrap(part.mesh, {}, file.name), file.name + " " + part.name,
                  file.name == "corridor.obj" ? 0.95 / 16 : 0.2);
  }
}

TEST(Unwrap, MeshesOfTheField) {
  const std::filesystem::path folder = SHADEBENCH_SOURCE_DIR "/../shared/data/models";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no models from outside";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    for (const ModelPart& part : read_model(entry.path()).parts)
      expect_good(unwrap(part.mesh, {}), entry.path().filename().string());
}

TEST(Unwrap, IsTheSameEachTime) {
  const MeshHandle mesh = shape("teapot");
  EXPECT_EQ(unwrap(mesh, {}), unwrap(mesh, {}));
}

TEST(Unwrap, ASizeOrAPlaceFarAwayChangesLittle) {
  const MeshHandle mesh = shape("torus", 12);
  const UvLayout plain = unwrap(mesh, {});
  for (const double size : {std::ldexp(1.0, -900), std::ldexp(1.0, 900)}) {
    MeshData data = mesh->data();
    for (glm::dvec3& p : data.positions) p *= size;
    EXPECT_EQ(unwrap(Mesh::make(data), {}).uv, plain.uv);
  }
}

TEST(Unwrap, CutsAlongMarkedSeams) {
  // A cube opened along the edges of a cross: exact, one chart, the seams those that were marked.
  const MeshHandle cube = shape("cube");
  Unwrapping options;
  options.automatic_seams = false;
  UvLayout closed = unwrap(cube, options);
  EXPECT_EQ(closed.charts, 1u);
  const std::vector<SeamEdge> all = [&] {
    const UnwrapSurface s(cube, "");
    EdgeCuts cuts(s.corner_count(), 1);
    return seams_of(s, cuts);
  }();
  ASSERT_EQ(all.size(), 12u);
  options.seams = all;
  const UvLayout apart = unwrap(cube, options);
  EXPECT_EQ(apart.charts, 6u);
  EXPECT_EQ(seams_of(apart), all);
  EXPECT_NEAR(figures_of(apart, 256).distortion.worst_quasi_conformal, 1, 1e-9);
}

TEST(Unwrap, ChartsKeepTheMargin) {
  Unwrapping options;
  options.margin = 8, options.texture_size = 512;
  const UvLayout layout = unwrap(shape("teapot"), options);
  // Pixels of two charts are 8 apart: none has another chart within 6 pixels.
  std::vector<int> owner(512 * 512, -1);
  for (std::uint32_t chart = 0; chart < layout.charts; ++chart) {
    UvLayout one = layout;
    for (std::size_t f = 0; f < layout.chart.size(); ++f)
      if (layout.chart[f] != chart)
        for (std::uint32_t c = layout.mesh->data().first_corner[f]; c < layout.mesh->data().first_corner[f + 1]; ++c)
          one.uv[c] = glm::dvec2(-1);
    const std::vector<std::uint8_t> covered = coverage_of(one, 512);
    for (std::size_t i = 0; i < covered.size(); ++i)
      if (covered[i]) owner[i] = int(chart);
  }
  std::size_t close = 0;
  for (int y = 0; y < 512; ++y)
    for (int x = 0; x < 512; ++x)
      for (const auto& [dx, dy] : {std::pair(6, 0), std::pair(0, 6), std::pair(4, 4), std::pair(4, -4)}) {
        if (x + dx >= 512 || y + dy >= 512 || y + dy < 0) continue;
        const int a = owner[std::size_t(y * 512 + x)], b = owner[std::size_t((y + dy) * 512 + x + dx)];
        close += a >= 0 && b >= 0 && a != b;
      }
  EXPECT_EQ(close, 0u);
}

TEST(Unwrap, CountsOverlapsAndFlips) {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Corner face[] = {{0}, {1}, {2}, {3}};
  data.add_face(face, face + 4), data.add_face(face, face + 4);
  data.positions.insert(data.positions.end(), data.positions.begin(), data.positions.end());
  for (int i = 4; i < 8; ++i) data.corners[std::size_t(i)].position += 4;
  const MeshHandle mesh = Mesh::make(data);
  // One square, and its mirror image half over it: a quarter of the texture each.
  const UvLayout layout =
      make_layout(mesh, {{0, 0}, {.5, 0}, {.5, .5}, {0, .5}, {.75, 0}, {.25, 0}, {.25, .5}, {.75, .5}});
  const LayoutFigures f = figures_of(layout, 64);
  EXPECT_EQ(layout.charts, 2u);
  EXPECT_EQ(f.distortion.flipped, 2u);
  EXPECT_EQ(f.covered_pixels, 48u * 32u);
  EXPECT_EQ(f.overlapping_pixels, 16u * 32u);
}

TEST(Unwrap, RefusesWhatIsNoSurface) {
  MeshData data;
  data.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
  for (const std::uint32_t tip : {2u, 3u, 4u}) {
    const Corner face[] = {{0}, {1}, {tip}};
    data.add_face(face, face + 3);
  }
  try {
    unwrap(Mesh::make(data), {}, "fins.obj");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(e.message(Language::english)
                  .find("fins.obj: the mesh is not a surface at 1 edge: the one between "
                        "vertices 0 and 1 (counted from 0) has 3 faces; "),
              std::string::npos)
        << e.message(Language::english);
    EXPECT_NE(e.message(Language::japanese).find("3 枚"), std::string::npos);
  }
  EXPECT_THROW(unwrap(Mesh::make({}), {}), InputError);
}

TEST(Unwrap, LivesWithOddMeshes) {
  // Two tetrahedra that touch at a vertex, a face without area, one turned round, a corner in the middle of a side.
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1},
                    {5, 0, 0}, {6, 0, 0}, {7, 0, 0}, {7, 1, 0}, {5, 1, 0},  {9, 9, 9}};
  const std::vector<std::vector<std::uint32_t>> faces{
      {0, 2, 1}, {0, 1, 3}, {0, 3, 2},   {1, 2, 3},         {0, 4, 5},   {0, 6, 4},  {0, 5, 6},
      {4, 6, 5}, {7, 8, 9}, {12, 12, 7}, {7, 8, 9, 10, 11}, {11, 10, 2}, {10, 11, 3}};
  for (const auto& f : faces) {
    std::vector<Corner> corners;
    for (const std::uint32_t p : f) corners.push_back({p});
    data.add_face(corners.data(), corners.data() + corners.size());
  }
  const MeshHandle mesh = Mesh::make(data);
  for (int m = 0; m < 4; ++m) {
    Unwrapping options;
    options.method = UnwrapMethod(m);
    UvLayout layout;
    try {
      layout = unwrap(mesh, options);
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("3 faces"), std::string::npos);
      continue;
    }
    for (const glm::dvec2& p : layout.uv) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
    EXPECT_EQ(figures_of(layout, 512).overlapping_pixels, 0u);
  }
}

// Random faces over few vertices: most meet at edges of many faces, are turned round, cross each other. Triangles never
// flip or overlap in the texture; polygons that cross themselves may.
TEST(Unwrap, LivesWithAnyMesh) {
  std::size_t unwrapped = 0;
  for (std::uint64_t seed = 0; seed < 32; ++seed) {
    std::uint64_t counter = 0;
    const auto random = [&](int n) { return int(random_number(seed, counter++) * n); };
    MeshData data;
    for (int i = 0; i < 40; ++i) data.positions.push_back({random(4), random(4), random(4)});
    const bool triangles = seed % 2 == 0;
    for (int f = 2 + random(12); f > 0; --f) {
      std::vector<Corner> corners;
      for (int k = triangles ? 3 : 3 + random(4); k > 0; --k) corners.push_back({std::uint32_t(random(40))});
      data.add_face(corners.data(), corners.data() + corners.size());
    }
    const MeshHandle mesh = Mesh::make(data);
    Unwrapping options;
    options.method = UnwrapMethod(seed / 2 % 4);
    options.automatic_seams = seed % 16 < 14;
    try {
      const UvLayout layout = unwrap(mesh, options);
      ++unwrapped;
      for (const glm::dvec2& p : layout.uv) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y)) << seed;
      const LayoutFigures f = figures_of(layout, 256);
      if (triangles && options.automatic_seams) {
        EXPECT_EQ(f.distortion.flipped, 0u) << seed;
        EXPECT_EQ(f.overlapping_pixels, 0u) << seed;
      }
    } catch (const InputError&) {
    }
  }
  EXPECT_GT(unwrapped, 16u);
}

TEST(Pack, TurnsToTheSmallestBox) {
  std::vector<glm::dvec2> p;
  const double a = 0.6;
  for (const auto& q : {glm::dvec2(0, 0), glm::dvec2(4, 0), glm::dvec2(4, 1), glm::dvec2(0, 1)})
    p.push_back({std::cos(a) * q.x - std::sin(a) * q.y, std::sin(a) * q.x + std::cos(a) * q.y});
  turn_to_smallest_box(p);
  double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;
  for (const auto& q : p)
    low_x = std::min(low_x, q.x), high_x = std::max(high_x, q.x), low_y = std::min(low_y, q.y),
    high_y = std::max(high_y, q.y);
  EXPECT_NEAR((high_x - low_x) * (high_y - low_y), 4, 1e-12);
}

}  // namespace
}  // namespace cg
