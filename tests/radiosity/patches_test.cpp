// Areas, normals and counts of patches, which of their vertices are shared, and which scenes are closed.
#include "radiosity/patches.h"

#include <gtest/gtest.h>

#include <set>

#include "math/transform.h"
#include "params/input_error.h"
#include "scene/cornell_box.h"
#include "tests/radiosity/scenes.h"

namespace cg {
namespace {

using namespace testing;

double total_area(const Patches& p) {
  double sum = 0;
  for (const Patch& patch : p.patches) sum += patch.area;
  return sum;
}

// What holds of any patches: sizes, normals against corners, one element each, areas.
void expect_sound(const Patches& p, double size) {
  ASSERT_EQ(p.first_element.size(), p.patches.size() + 1);
  ASSERT_EQ(p.elements.size(), p.patches.size());
  for (std::size_t i = 0; i < p.patches.size(); ++i) {
    const Patch& patch = p.patches[i];
    EXPECT_NEAR(glm::length(patch.normal), 1, 1e-15);
    EXPECT_GT(patch.area, 0);
    for (int k = 0; k < patch.corners; ++k) {
      const glm::dvec3 &a = patch.corner[std::size_t(k)], &b = patch.corner[std::size_t((k + 1) % patch.corners)],
                       &c = patch.corner[std::size_t((k + 2) % patch.corners)];
      EXPECT_LE(glm::distance(a, b), size * (1 + 1e-8));
      EXPECT_GT(glm::dot(patch.normal, glm::cross(b - a, c - b)), 0);
      EXPECT_NEAR(glm::dot(patch.normal, a - patch.centre), 0, 1e-13);
    }
    const Element& e = p.elements[p.first_element[i]];
    EXPECT_EQ(e.patch, i);
    EXPECT_EQ(e.area, patch.area);
    for (int k = 0; k < e.corners; ++k)
      EXPECT_EQ(p.vertices[e.vertex[std::size_t(k)]].position, patch.corner[std::size_t(k)]);
  }
}

TEST(Patches, ACubeRoom) {
  const Scene scene = scene_of({object_of(room({1, 1, 1}))});
  for (const int n : {1, 2, 3, 4, 7, 10, 32}) {
    const Patches p = patches_of(scene, 1.0 / n);
    EXPECT_EQ(p.patches.size(), std::size_t(6 * n * n));
    EXPECT_EQ(p.vertices.size(), std::size_t(6 * (n + 1) * (n + 1)));  // not shared over the room's edges
    EXPECT_TRUE(p.closed);
    EXPECT_EQ(p.degenerate, 0u);
    EXPECT_NEAR(total_area(p), 6, 1e-13);
    expect_sound(p, 1.0 / n);
    for (const Patch& patch : p.patches) EXPECT_GT(glm::dot(patch.normal, glm::dvec3(0.5) - patch.centre), 0);
  }
}

// Four small ones for one large: triangles stay alike.
TEST(Patches, Triangles) {
  const Scene scene = scene_of({object_of({{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}})});
  for (int level = 0; level < 5; ++level) {
    const double size = 5 / std::exp2(level);
    const Patches p = patches_of(scene, size);
    EXPECT_EQ(p.patches.size(), std::size_t(1) << (2 * level));
    EXPECT_NEAR(total_area(p), 6, 1e-13);
    const std::size_t n = std::size_t(1) << level;
    EXPECT_EQ(p.vertices.size(), (n + 1) * (n + 2) / 2);
    expect_sound(p, size);
  }
  EXPECT_EQ(patches_of(scene, 4.9).patches.size(), 4u);
}

// Pentagons and quads that are bent or concave are cut into triangles first, with the same area.
TEST(Patches, OtherPolygons) {
  const std::vector<std::vector<glm::dvec3>> polygons{{{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {0, 2, 0}},
                                                      {{0, 0, 5}, {2, 0, 5}, {0.5, 0.5, 5}, {0, 2, 5}},
                                                      {{0, 0, 9}, {1, 0, 9}, {1, 1, 9.5}, {0, 1, 9}}};
  const Patches p = patches_of(scene_of({object_of(polygons)}), 0.3);
  expect_sound(p, 0.3);
  double plane = 0, bent = 0;
  for (const Patch& patch : p.patches) (patch.face == 2 ? bent : plane) += patch.area;
  EXPECT_NEAR(plane, 7, 1e-13);
  // Fan around the last corner, or the other diagonal: either way two triangles of known area.
  const auto triangle = [&](int i, int j, int k) {
    const auto& q = polygons[2];
    return 0.5 * glm::length(glm::cross(q[j] - q[i], q[k] - q[i]));
  };
  EXPECT_NEAR(bent, triangle(0, 1, 3) + triangle(1, 2, 3), 1e-13);
  for (const Patch& patch : p.patches) EXPECT_EQ(patch.corners, 3);
}

TEST(Patches, TransformsScaleAndMirror) {
  Scene scene = scene_of({object_of(room({1, 1, 1}))});
  scene.objects[0].transform = {.translate = {5, -3, 1}, .rotate = {20, 30, 40}, .scale = {2, 3, 0.5}};
  const Patches p = patches_of(scene, 0.5);
  EXPECT_NEAR(total_area(p), 2 * (6 + 1 + 1.5), 1e-12);
  EXPECT_EQ(p.patches.size(), std::size_t(2 * (4 * 6 + 4 * 1 + 6 * 1)));
  EXPECT_TRUE(p.closed);
  expect_sound(p, 0.5);
  // A mirror leaves inside inside.
  scene.objects[0].transform.scale.x = -2;
  const Patches mirrored = patches_of(scene, 0.5);
  EXPECT_TRUE(mirrored.closed);
  EXPECT_NEAR(total_area(mirrored), 17, 1e-12);
  expect_sound(mirrored, 0.5);
}

TEST(Patches, MaterialsAndFaces) {
  Scene scene = scene_of({object_of({rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})}, "a"),
                          object_of({rectangle({0, 0, 1}, {0, 1, 0}, {1, 0, 0})}, "b"), shape_object("cube")});
  scene.material.k_d = {0.1, 0.2, 0.3};
  scene.objects[1].own_material = true;
  scene.objects[1].material.k_d = {1, 0, 0.5};
  scene.objects[1].material.emission = {3, 4, 5};
  scene.objects[2].visible = false;
  const Patches p = patches_of(scene, 0.5);
  ASSERT_EQ(p.patches.size(), 8u);
  for (const Patch& patch : p.patches) {
    const Material& m = patch.object == 0 ? scene.material : scene.objects[1].material;
    EXPECT_EQ(patch.reflectance, m.k_d);
    EXPECT_EQ(patch.emission, m.emission);
  }
}

TEST(Patches, RefusesWhatCannotBe) {
  Scene scene = scene_of({object_of(room({1, 1, 1}), "hall")});
  scene.material.k_d = {0.5, 1.25, 0.5};
  Progress progress;
  try {
    make_patches(scene, {}, progress);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(e.where, "material.k_d");
    EXPECT_NE(e.message(Language::english).find("hall reflects 1.25 of the green light"), std::string::npos);
    EXPECT_NE(e.message(Language::japanese).find("緑"), std::string::npos);
  }
  scene.material.k_d = {1, 1, 1};
  EXPECT_NO_THROW(make_patches(scene, {}, progress));
  try {
    make_patches(scene, {.patch_size = 1e-5}, progress);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(e.message(Language::english).find("radiosity.patch_size"), std::string::npos);
    // The size that it names is enough.
    const std::string text = e.accepted.en;
    const double size = std::stod(text.substr(text.rfind(' ')));
    EXPECT_LT(6 / (size * size), 4194304) << text;
    EXPECT_GT(6 / (size * size), 500000) << text;
  }
  progress.cancelled = true;
  EXPECT_THROW(make_patches(scene, {}, progress), Cancelled);
}

// Without area: counted, left out.
TEST(Patches, DegenerateFaces) {
  Scene scene = scene_of({object_of({rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}),
                          object_of(room({1, 1, 1}))});
  scene.objects[1].transform.scale = {1, 0, 1};  // flat: four walls are gone
  const Patches p = patches_of(scene, 1);
  EXPECT_EQ(p.degenerate, 5u);
  EXPECT_EQ(p.patches.size(), 3u);
  EXPECT_EQ(patches_of(scene_of({}), 1).patches.size(), 0u);
}

// 1e-12 square metres keep their area.
TEST(Patches, Tiny) {
  const Patches p = patches_of(scene_of({object_of({rectangle({3, 4, 5}, {1e-6, 0, 0}, {0, 1e-6, 0})})}), 1);
  ASSERT_EQ(p.patches.size(), 1u);
  EXPECT_NEAR(p.patches[0].area / 1e-12, 1, 1e-8);
}

TEST(Patches, WhichScenesAreClosed) {
  const auto closed = [](const Scene& scene) { return patches_of(scene, 10).closed; };
  const Object hall = object_of(room({4, 3, 5}));
  Object block = object_of(room({1, 1, 1}));
  block.transform = {.translate = {2, 1, 2}, .scale = {-1, 1, 1}};
  // A room, and a block seen from outside: its faces turned round.
  auto outward = room({1, 1, 1});
  for (auto& polygon : outward) std::reverse(polygon.begin(), polygon.end());
  Object solid = object_of(outward);
  solid.transform.translate = {2, 1, 2};
  EXPECT_TRUE(closed(scene_of({hall})));
  EXPECT_TRUE(closed(scene_of({hall, solid})));
  EXPECT_FALSE(closed(scene_of({solid})));        // nothing around it
  EXPECT_FALSE(closed(scene_of({hall, block})));  // a room in a room: between them backs are seen
  solid.transform.translate = {2, 0, 2};
  EXPECT_TRUE(closed(scene_of({hall, solid})));  // on the floor
  solid.transform.translate = {20, 1, 2};
  EXPECT_FALSE(closed(scene_of({hall, solid})));  // outside
  Object other = hall;
  other.transform.translate = {20, 1, 2};
  EXPECT_TRUE(closed(scene_of({hall, other})));  // two rooms
  auto open = room({4, 3, 5});
  open.pop_back();
  EXPECT_FALSE(closed(scene_of({object_of(open)})));
  // The same wall in two pieces: a T-junction is no gap.
  open.push_back(rectangle({4, 0, 0}, {0, 0, 2}, {0, 3, 0}));
  open.push_back(rectangle({4, 0, 2}, {0, 0, 3}, {0, 3, 0}));
  EXPECT_TRUE(closed(scene_of({object_of(open)})));
  open.back() = rectangle({4, 0, 2}, {0, 0, 2.99}, {0, 3, 0});
  EXPECT_FALSE(closed(scene_of({object_of(open)})));
  // A ball seen from outside, and from inside.
  Object ball = shape_object("icosphere", 2);
  EXPECT_FALSE(closed(scene_of({ball})));
}

// The Cornell box is open to the front, as published.
TEST(Patches, CornellBox) {
  Scene scene;
  for (const BundledPart& part : cornell_parts()) {
    Object object;
    object.name = part.name;
    object.mesh = Mesh::make(part.mesh);
    scene.objects.push_back(object);
  }
  const Patches p = patches_of(scene, 0.02);
  EXPECT_FALSE(p.closed);
  EXPECT_GT(p.patches.size(), 3000u);
  expect_sound(p, 0.02);
  double light = 0;
  for (const Patch& patch : p.patches)
    if (scene.objects[patch.object].name == "light") light += patch.area;
  EXPECT_NEAR(light, 0.13 * 0.105, 1e-15);
}

// A smooth shape is one surface; a cube has six.
TEST(Patches, Surfaces) {
  const auto surfaces = [](const char* id) {
    std::set<std::uint32_t> out;
    for (const ElementVertex& v : patches_of(scene_of({shape_object(id)}), 0.2).vertices) out.insert(v.surface);
    return out.size();
  };
  EXPECT_EQ(surfaces("uv-sphere"), 1u);
  EXPECT_EQ(surfaces("torus"), 1u);
  EXPECT_EQ(surfaces("cube"), 6u);
  EXPECT_EQ(surfaces("cylinder"), 3u);
  EXPECT_EQ(surfaces("plane"), 1u);
}

TEST(Patches, GeometryKey) {
  Scene scene = scene_of({object_of(room({1, 1, 1})), shape_object("cube")});
  const Radiosity options;
  const std::uint64_t key = geometry_key(scene, options);
  Scene other = scene;
  other.material.k_d = {0.1, 0.1, 0.1};
  other.objects[0].own_material = true;
  other.camera.position.x += 1;
  EXPECT_EQ(geometry_key(other, options), key);
  Radiosity solver = options;
  solver.resolution = 64, solver.residual = 1e-3, solver.gradient = 0.5;
  EXPECT_EQ(geometry_key(scene, solver), key);
  std::set<std::uint64_t> keys{key};
  const auto expect_other = [&](const Scene& s, const Radiosity& o) {
    EXPECT_TRUE(keys.insert(geometry_key(s, o)).second);
  };
  other = scene, other.objects[1].transform.translate.x = 1e-9, expect_other(other, options);
  other = scene, other.objects[1].visible = false, expect_other(other, options);
  other = scene, other.objects[1] = shape_object("cube", 2), expect_other(other, options);
  std::swap(other.objects[0], other.objects[1]), expect_other(other, options);
  expect_other(scene, {.patch_size = 0.125});
  expect_other(scene, {.adaptive_levels = 1});
  expect_other(scene, {.adaptive_levels = 1, .gradient = 0.2});
}

}  // namespace
}  // namespace cg
