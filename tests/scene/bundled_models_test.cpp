#include "scene/bundled_models.h"

#include <gtest/gtest.h>

#include <map>

#include "math/vec.h"
#include "params/file.h"
#include "scene/cornell_box.h"
#include "scene/model_file.h"
#include "scene/shape.h"

using namespace cg;

namespace {

const std::filesystem::path models = std::filesystem::path(SHADEBENCH_SOURCE_DIR) / "models";

// Equal faces, and numbers equal but for the last bits, in which the C library's sine may differ elsewhere.
void expect_same(const Model& a, const Model& b, std::string_view name) {
  ASSERT_EQ(a.parts.size(), b.parts.size()) << name;
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    const MeshData &l = a.parts[i].mesh->data(), &r = b.parts[i].mesh->data();
    EXPECT_EQ(a.parts[i].name, b.parts[i].name);
    EXPECT_TRUE(l.corners == r.corners && l.first_corner == r.first_corner) << name;
    const auto expect_near = [&](const auto& left, const auto& right) {
      ASSERT_EQ(left.size(), right.size()) << name;
      for (std::size_t k = 0; k < left.size(); ++k) ASSERT_LT(glm::distance(left[k], right[k]), 1e-14) << name;
    };
    expect_near(l.positions, r.positions), expect_near(l.normals, r.normals), expect_near(l.uvs, r.uvs);
  }
}

}  // namespace

// After a change of a shape: shadebench-models models
TEST(BundledModels, are_what_the_generator_writes) {
  std::size_t bytes = 0, files = 0;
  for (const BundledFile& file : bundled_models()) {
    const std::string committed = read_file(models / file.name);
    if (file.name.ends_with(".obj"))
      expect_same(read_obj(committed, file.name, {}), read_obj(file.text, file.name, {}), file.name);
    else
      EXPECT_EQ(committed, file.text);
    bytes += file.text.size();
    ++files;
  }
  EXPECT_LT(bytes, std::size_t(3) << 20);
  for (const auto& entry : std::filesystem::directory_iterator(models)) files -= entry.is_regular_file();
  EXPECT_EQ(files, 0u);
}

TEST(BundledModels, read_back_as_the_shapes_they_are) {
  for (const Shape& s : shapes()) {
    const Model model = read_model(models / (std::string(s.id) + ".obj"));
    EXPECT_TRUE(model.notes.empty());
    expect_same(model, {{{std::string(s.id), make_shape(s), {}}}, {}}, s.id);
  }
}

TEST(BundledModels, the_cornell_box_has_its_named_objects) {
  const Model model = read_model(models / "cornell-box.obj");
  EXPECT_TRUE(model.notes.empty());
  const std::vector<std::string> names{"floor",      "ceiling",     "back-wall",  "left-wall",
                                       "right-wall", "short-block", "tall-block", "light"};
  ASSERT_EQ(model.parts.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(model.parts[i].name, names[i]);
    EXPECT_EQ(model.parts[i].mesh->report(), MeshReport{});
    ASSERT_TRUE(model.parts[i].material);
    EXPECT_EQ(model.parts[i].material->k_s, glm::dvec3(0));
  }
  const Material &red = *model.parts[3].material, &green = *model.parts[4].material, &light = *model.parts[7].material;
  EXPECT_GT(red.k_d.r, 5 * red.k_d.g);
  EXPECT_GT(green.k_d.g, 4 * green.k_d.r);
  EXPECT_GT(light.emission.r, light.emission.b);
  // The published spectrum of white lies between 0.7 and 0.78 where the eye sees most.
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(model.parts[0].material->k_d[i], 0.74, 0.01);
}

// Published: 556 x 548.8 x 559.2 mm, a light of 130 x 105, blocks of about 165 and 165 x 165 x 330.
TEST(BundledModels, the_cornell_box_has_its_measures) {
  glm::dvec3 low(1), high(-1);
  double ceiling_and_light = 0;
  std::map<std::string, glm::dvec3> sizes;
  for (const BundledPart& part : cornell_parts()) {
    const MeshHandle mesh = Mesh::make(part.mesh);
    low = glm::min(low, mesh->low()), high = glm::max(high, mesh->high());
    sizes[part.name] = mesh->high() - mesh->low();
    // Walls look into the box, whose middle is here; the blocks' faces look away from their own.
    const glm::dvec3 middle = part.name.ends_with("block") ? mesh->centre() : glm::dvec3(-0.278, 0.2744, -0.2796);
    const double outwards = part.name.ends_with("block") ? 1 : -1;
    for (const Corner& c : mesh->data().corners)
      EXPECT_GT(outwards * glm::dot(mesh->data().positions[c.position] - middle, mesh->data().normals[c.normal]), 0);
    if (part.name == "ceiling" || part.name == "light")
      for (const Triangle& t : mesh->triangles()) {
        const auto p = [&](int k) { return mesh->data().positions[mesh->data().corners[t.corner[k]].position]; };
        ceiling_and_light += 0.5 * glm::length(glm::cross(p(1) - p(0), p(2) - p(0)));
      }
  }
  EXPECT_LT(glm::distance(sizes["light"], {0.13, 0, 0.105}), 1e-12);
  EXPECT_NEAR(sizes["tall-block"].y, 0.33, 1e-12);
  EXPECT_NEAR(sizes["short-block"].y, 0.165, 1e-12);
  EXPECT_LT(glm::distance(low, {-0.556, 0, -0.5592}), 1e-12);
  EXPECT_LT(glm::distance(high, {0, 0.5488, 0}), 1e-12);
  EXPECT_NEAR(ceiling_and_light, 0.556 * 0.5592, 1e-12);
}
