// T-junctions, the light at vertices, which elements are cut, and the mesh that is drawn.
#include "radiosity/elements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "math/transform.h"
#include "radiosity/field.h"
#include "scene/connectivity.h"
#include "scene/polygon.h"
#include "tests/radiosity/scenes.h"

namespace cg {
namespace {

using namespace testing;

glm::dvec3 middle_of(const Patches& p, const Element& e) {
  glm::dvec3 sum(0);
  for (int i = 0; i < e.corners; ++i) sum += p.vertices[e.vertex[std::size_t(i)]].position / double(e.corners);
  return sum;
}

// One value an element from a function of its middle.
template <class Function>
std::vector<glm::dvec3> values_of(const Patches& p, const Function& f) {
  std::vector<glm::dvec3> out;
  for (const Element& e : p.elements) out.emplace_back(f(middle_of(p, e)));
  return out;
}

double total_area(const Patches& p) {
  double sum = 0;
  for (const Element& e : p.elements) sum += e.area;
  return sum;
}

// Every edge of an outline but those on the surface's border is an edge of exactly one other outline: no crack.
void expect_no_crack(const Patches& p, std::size_t border_edges) {
  const Outlines outlines = outlines_of(p);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t e = 0; e < p.elements.size(); ++e)
    for (std::uint32_t i = outlines.first[e]; i < outlines.first[e + 1]; ++i) {
      const std::uint32_t next = i + 1 < outlines.first[e + 1] ? i + 1 : outlines.first[e];
      EXPECT_EQ(++edges[std::pair(outlines.vertex[i], outlines.vertex[next])], 1);
    }
  std::size_t border = 0;
  for (const auto& [edge, count] : edges) border += !edges.contains({edge.second, edge.first});
  EXPECT_EQ(border, border_edges);
}

// A large rectangle beside two small ones, beside three.
Scene uneven() {
  std::vector<std::vector<glm::dvec3>> r{rectangle({0, 0, 0}, {3, 0, 0}, {0, 6, 0})};
  for (int i = 0; i < 2; ++i) r.push_back(rectangle({3, 3.0 * i, 0}, {2, 0, 0}, {0, 3, 0}));
  for (int i = 0; i < 3; ++i) r.push_back(rectangle({5, 2.0 * i, 0}, {1, 0, 0}, {0, 2, 0}));
  return scene_of({object_of(r)});
}

TEST(Elements, FacesOfDifferentSizes) {
  const Patches p = patches_of(uneven(), 10);
  ASSERT_EQ(p.elements.size(), 6u);
  EXPECT_EQ(p.vertices.size(), 14u);
  expect_no_crack(p, 3 + 2 + 5);
  const Outlines outlines = outlines_of(p);
  EXPECT_EQ(outlines.first[1] - outlines.first[0], 5u);
  EXPECT_EQ(outlines.hanging.size(), 1u + 3);  // at 3; at 2 and 4, and 3 again
  for (std::size_t i = 1; i < outlines.hanging.size(); ++i) {
    const auto length = [&](const HangingVertex& h) {
      return glm::distance(p.vertices[h.a].position, p.vertices[h.b].position);
    };
    EXPECT_GE(length(outlines.hanging[i - 1]), length(outlines.hanging[i]));
  }
}

// A constant stays constant at every vertex; light of one plane does not reach another, nor another object.
TEST(Elements, NoLeakOverEdgesAndObjects) {
  Scene scene = uneven();
  scene.objects.push_back(object_of({rectangle({6, 0, 0}, {1, 0, 0}, {0, 6, 0})}));
  scene.objects.push_back(object_of(room({1, 1, 1})));
  scene.objects.push_back(object_of({rectangle({0, 0, 0}, {0, 6, 0}, {3, 0, 0})}));  // the back of the first
  const Patches p = patches_of(scene, 0.5);
  // Each plane of each object gets a number of its own.
  std::vector<glm::dvec3> number;
  for (const Element& e : p.elements) {
    const Patch& patch = p.patches[e.patch];
    number.emplace_back(double(patch.object), patch.normal.x + 2 * patch.normal.y + 4 * patch.normal.z, 1);
  }
  const Outlines outlines = outlines_of(p);
  const std::vector<glm::dvec3> values = vertex_values(p, outlines, number);
  for (std::size_t e = 0; e < p.elements.size(); ++e)
    for (std::uint32_t i = outlines.first[e]; i < outlines.first[e + 1]; ++i)
      EXPECT_LT(glm::distance(values[outlines.vertex[i]], number[e]), 1e-13);
}

// Along an edge with T-junctions both sides have the same light: that between the ends of the large edge.
TEST(Elements, LightIsContinuousAtTJunctions) {
  const Patches p = patches_of(uneven(), 10);
  const Outlines outlines = outlines_of(p);
  const std::vector<glm::dvec3> values = vertex_values(
      p, outlines, values_of(p, [](const glm::dvec3& m) { return glm::dvec3(m.x * m.x, std::sin(m.y), 1); }));
  const auto at = [&](double x, double y) {
    for (std::size_t v = 0; v < values.size(); ++v)
      if (glm::distance(p.vertices[v].position, {x, y, 0}) < 1e-12) return values[v];
    return glm::dvec3(-1);
  };
  EXPECT_LT(glm::distance(at(3, 3), 0.5 * (at(3, 0) + at(3, 6))), 1e-14);
}

// A linear light is linear inside a regular grid.
TEST(Elements, MeansKeepALinearLight) {
  const Patches p = patches_of(scene_of({object_of({rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})})}), 0.1);
  const auto light = [](const glm::dvec3& m) { return glm::dvec3(1 + m.x, 2 - m.y, 3 + m.x + 2 * m.y); };
  const std::vector<glm::dvec3> values = vertex_values(p, outlines_of(p), values_of(p, light));
  for (std::size_t v = 0; v < values.size(); ++v) {
    const glm::dvec3& m = p.vertices[v].position;
    const bool inside = m.x > 0.05 && m.x < 0.95 && m.y > 0.05 && m.y < 0.95;
    EXPECT_LT(glm::distance(values[v], light(m)), inside ? 1e-14 : 0.2);
  }
}

// A step of light in a corner is cut as often as allowed, all around it gently; areas and patches stay.
TEST(Elements, AreCutWhereTheLightChanges) {
  for (const bool triangles : {false, true}) {
    const std::vector<glm::dvec3> square = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const Scene scene =
        scene_of({triangles ? object_of({{square[0], square[1], square[2]}, {square[0], square[2], square[3]}})
                            : object_of({square})});
    Patches p = patches_of(scene, 0.25);
    const std::size_t patches = p.patches.size();
    const Radiosity options{.patch_size = 0.25, .adaptive_levels = 4, .gradient = 0.1};
    Progress progress;
    const auto light = [](const glm::dvec3& m) { return glm::dvec3(m.x + m.y < 0.3 ? 10 : 1); };
    std::vector<std::size_t> counts{p.elements.size()};
    for (int round = 0; round < 10; ++round) {
      const Patches before = p;
      const std::vector<std::uint32_t> whole = refine_elements(p, values_of(p, light), options, progress);
      if (whole.empty()) break;
      ASSERT_EQ(whole.size(), p.elements.size());
      for (std::size_t e = 0; e < whole.size(); ++e) {
        EXPECT_EQ(before.elements[whole[e]].patch, p.elements[e].patch);
        EXPECT_GE(p.elements[e].level, before.elements[whole[e]].level);
      }
      counts.push_back(p.elements.size());
      EXPECT_NEAR(total_area(p), 1, 1e-13);
      ASSERT_EQ(p.first_element.size(), patches + 1);
      for (std::size_t i = 0; i < patches; ++i) {
        double area = 0;
        for (std::uint32_t e = p.first_element[i]; e < p.first_element[i + 1]; ++e) {
          EXPECT_EQ(p.elements[e].patch, i);
          area += p.elements[e].area;
          const Patch part = element_as_patch(p, e);
          EXPECT_NEAR(part.area, p.elements[e].area, 1e-15);
        }
        EXPECT_NEAR(area, p.patches[i].area, 1e-15);
      }
    }
    EXPECT_EQ(counts.size(), 5u);                  // four levels, and no more
    EXPECT_LT(counts.back(), (patches << 8) / 4);  // not everywhere
    int finest = 0, coarsest = 9;
    for (const Element& e : p.elements) finest = std::max(finest, e.level), coarsest = std::min(coarsest, e.level);
    EXPECT_EQ(finest, 4);
    EXPECT_EQ(coarsest, 0);
    // Neighbours differ by one level: no more than one vertex in an edge.
    const Outlines outlines = outlines_of(p);
    for (std::size_t e = 0; e < p.elements.size(); ++e)
      EXPECT_LE(outlines.first[e + 1] - outlines.first[e], 2 * unsigned(p.elements[e].corners));
    std::size_t border = 0;
    for (const Element& e : p.elements)
      for (int i = 0; i < e.corners; ++i) {
        const glm::dvec3 &a = p.vertices[e.vertex[std::size_t(i)]].position,
                         &b = p.vertices[e.vertex[std::size_t((i + 1) % e.corners)]].position;
        border += (a.x == b.x && (a.x == 0 || a.x == 1)) || (a.y == b.y && (a.y == 0 || a.y == 1));
      }
    expect_no_crack(p, border);
  }
}

TEST(Elements, EvenLightCutsNothing) {
  Patches p = patches_of(scene_of({object_of(room({1, 1, 1}))}), 0.5);
  Progress progress;
  const std::vector<glm::dvec3> even(p.elements.size(), glm::dvec3(3)), dark(p.elements.size(), glm::dvec3(0));
  EXPECT_TRUE(refine_elements(p, even, {.adaptive_levels = 3}, progress).empty());
  EXPECT_TRUE(refine_elements(p, dark, {.adaptive_levels = 3, .gradient = 0}, progress).empty());
  EXPECT_TRUE(
      refine_elements(p, values_of(p, [](const auto& m) { return m; }), {.adaptive_levels = 0}, progress).empty());
  EXPECT_EQ(p.elements.size(), 24u);
}

// The mesh that is drawn: the object's area and side, its normals, watertight where elements of different sizes meet.
TEST(Field, MeshesOfElements) {
  Scene scene = scene_of({shape_object("cube"), shape_object("uv-sphere", 16), uneven().objects[0]});
  scene.objects[0].transform = {.translate = {1, 2, 3}, .rotate = {10, 20, 30}, .scale = {-2, 1, 1}};
  scene.objects.insert(scene.objects.begin() + 1, scene.objects[0]);
  scene.objects[1].visible = false;
  scene.material.emission = {1, 2, 3};
  Patches p = patches_of(scene, 0.3);
  Progress progress;
  refine_elements(p, values_of(p, [](const glm::dvec3& m) { return glm::abs(m); }),
                  {.adaptive_levels = 1, .gradient = 0.05}, progress);
  EXPECT_GT(p.elements.size(), p.patches.size());
  const RadiosityField field = field_of(
      scene, p, values_of(p, [](const glm::dvec3& m) { return glm::dvec3(1, 2, 3) + glm::dvec3(0.5, 0, m.z); }), 77);
  EXPECT_EQ(field.geometry, 77u);
  ASSERT_EQ(field.objects.size(), 4u);
  EXPECT_EQ(field.objects[1].mesh, nullptr);
  for (const std::size_t o : {0u, 2u, 3u}) {
    const ObjectRadiosity& object = field.objects[o];
    ASSERT_TRUE(object.mesh);
    EXPECT_EQ(object.of, scene.objects[o].mesh);
    EXPECT_EQ(object.mesh->report(), MeshReport{});
    ASSERT_EQ(object.corners.size(), object.mesh->data().corners.size());
    const auto area = [](const Mesh& mesh) {
      double sum = 0, outwards = 0;  // the second: three times the volume
      for (const Triangle& t : mesh.triangles()) {
        const auto at = [&](int k) {
          return mesh.data().positions[mesh.data().corners[t.corner[std::size_t(k)]].position];
        };
        const glm::dvec3 n = 0.5 * glm::cross(at(1) - at(0), at(2) - at(0));
        sum += glm::length(n);
        outwards += glm::dot(n, at(0) - mesh.centre());
      }
      return std::pair(sum, outwards);
    };
    const auto [found, side] = area(*object.mesh);
    const auto [expected, expected_side] = area(*scene.objects[o].mesh);
    EXPECT_NEAR(found, expected, 1e-12 * expected);
    EXPECT_NEAR(side, expected_side, 1e-10);
    for (const glm::vec3& c : object.corners) {
      EXPECT_FLOAT_EQ(c.x, 0.5f);
      EXPECT_EQ(c.y, 0.0f);
      EXPECT_GE(c.z, 0.0f);
    }
  }
  const Topology ball = topology(*field.objects[2].mesh);
  EXPECT_TRUE(ball.closed() && ball.consistently_wound());
  EXPECT_EQ(ball.euler_characteristic(), 2);
  // The shape's normals are there, and between vertices they stay near the ball's.
  const MeshData& data = field.objects[2].mesh->data();
  for (const Corner& c : data.corners) {
    const glm::dvec3 n = data.normals[c.normal];
    EXPECT_GT(glm::dot(unit(n), unit(data.positions[c.position])), 0.999);
  }
  EXPECT_FALSE(field.objects[3].mesh->has_normals());
}

// Two walls of two objects that are cut in 3 and in 4 along their common edge: both get the points of both there, and
// keep their light.
TEST(Field, SurfacesThatMeetHaveTheSamePoints) {
  Scene scene = scene_of({object_of({rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})}),
                          object_of({rectangle({0, 0, 0}, {0, 1.25, 0}, {0, 0, 1})})});
  scene.objects[1].transform.scale.y = 0.8;
  for (const double size : {0.3, 0.26, 0.5}) {
    Patches p = patches_of(scene, size);
    Progress progress;
    const auto corner = [](const glm::dvec3& m) { return glm::dvec3(m.z > 0 && m.y < 0.3 ? 9 : 1); };
    refine_elements(p, values_of(p, corner), {.adaptive_levels = 2, .gradient = 0.1}, progress);
    const auto light = [](const glm::dvec3& m) { return glm::dvec3(m.z > 0 ? 5 : 2); };
    const RadiosityField field = field_of(scene, p, values_of(p, light), 0);
    std::array<std::set<long>, 2> places;
    for (std::size_t o = 0; o < 2; ++o) {
      const MeshData& data = field.objects[o].mesh->data();
      EXPECT_EQ(field.objects[o].mesh->report(), MeshReport{});
      for (std::size_t c = 0; c < data.corners.size(); ++c) {
        const glm::dvec3 at = data.positions[data.corners[c].position] * scene.objects[o].transform.scale;
        if (at.x == 0 && at.z == 0) places[o].insert(std::lround(at.y * 1e9));
        EXPECT_FLOAT_EQ(field.objects[o].corners[c].x, o == 0 ? 2.0f : 5.0f);
      }
    }
    EXPECT_GT(places[0].size(), 4u);
    EXPECT_EQ(places[0], places[1]) << size;
  }
}

}  // namespace
}  // namespace cg
