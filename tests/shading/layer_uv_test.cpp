#include "shading/layer_uv.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mapping/projection.h"
#include "scene/shape.h"
#include "shading/ambient_term.h"

using namespace cg;

namespace {

TextureHandle white() { return TextureImage::make(Image<glm::u8vec4>(1, 1, glm::u8vec4(255)), Encoding::as_stored); }

TextureLayer layer_from(UvSource source) {
  TextureLayer layer;
  layer.uv = source;
  layer.texture = white();
  return layer;
}

Scene scene_of(MeshHandle mesh, std::vector<TextureLayer> layers) {
  Scene scene;
  scene.objects.resize(1);
  scene.objects[0].name = "thing";
  scene.objects[0].mesh = std::move(mesh);
  scene.material.layers = std::move(layers);
  return scene;
}

MeshHandle shape(std::string_view id) { return make_shape(*find_shape(id), 0); }

// Two triangles over a square, their uv apart along the diagonal, or the same.
MeshHandle two_triangles(bool apart, double u = 0) {
  MeshData d;
  d.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  d.uvs = {{u, 0}, {1, 0}, {1, 1}, {0, 1}, {5, 5}, {6, 6}};
  const Corner a[3] = {{0, no_index, 0}, {1, no_index, 1}, {2, no_index, 2}};
  const Corner b[3] = {{0, no_index, apart ? 4u : 0u}, {2, no_index, apart ? 5u : 2u}, {3, no_index, 3}};
  d.add_face(a, a + 3), d.add_face(b, b + 3);
  return Mesh::make(std::move(d));
}

}  // namespace

TEST(LayerUv, each_set_stands_once) {
  std::vector<TextureLayer> layers{layer_from(UvSource::mesh), layer_from(UvSource::projector),
                                   layer_from(UvSource::projector), layer_from(UvSource::unwrap),
                                   layer_from(UvSource::mesh)};
  layers[4].projector.repeat_u = 9;  // not asked
  Scene scene = scene_of(shape("cube"), layers);
  LayerUv uv = layer_uv(scene, 0, nullptr);
  EXPECT_EQ(uv.sets.size(), 3u);
  EXPECT_EQ(uv.set_of_layer, (std::vector<int>{0, 1, 1, 2, 0}));
  scene.material.layers[2].projector.repeat_u = 9;
  scene.material.layers[0].visible = false;
  uv = layer_uv(scene, 0, nullptr);
  EXPECT_EQ(uv.set_of_layer, (std::vector<int>{0, 1, 2, 3}));
}

TEST(LayerUv, what_is_not_drawn_needs_none) {
  Scene scene = scene_of(shape("cube"), {layer_from(UvSource::mesh), layer_from(UvSource::unwrap)});
  scene.material.layers[0].target = LayerTarget::k_r;
  scene.material.layers[1].target = LayerTarget::opacity;
  EXPECT_TRUE(layer_uv(scene, 0, nullptr).layers.empty());
  EXPECT_TRUE(drawn_surface(scene, 0, nullptr)->uv.empty());
  EXPECT_EQ(layer_notes(scene, nullptr).size(), 1u);
  scene.shading.transparency = Transparency::test;
  EXPECT_EQ(layer_uv(scene, 0, nullptr).layers.size(), 1u);
}

TEST(LayerUv, surfaces_bring_each_corner_its_own) {
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud})
    for (const std::string_view id : {"cube", "uv-sphere", "teapot", "torus"}) {
      std::vector<TextureLayer> layers{layer_from(UvSource::mesh), layer_from(UvSource::projector),
                                       layer_from(UvSource::unwrap)};
      Scene scene = scene_of(shape(id), layers);
      scene.shading.mode = mode;
      const MeshHandle mesh = scene.objects[0].mesh;
      const SurfaceHandle s = drawn_surface(scene, 0, nullptr);
      ASSERT_EQ(s->uv.size(), 3u);
      const LayerUv uv = layer_uv(scene, 0, nullptr);
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_EQ(s->uv[k].size(), s->positions.size());
        const CornerUv corners = uv_of(uv.sets[k], mesh);
        for (std::size_t t = 0; t < s->triangle_count(); ++t)
          for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(s->uv[k][s->indices[3 * t + i]], glm::vec2(corners[mesh->triangles()[s->triangle[t]].corner[i]]));
      }
      EXPECT_EQ(drawn_surface(scene, 0, nullptr), s);
      scene.material.layers.clear();
      const SurfaceHandle plain = drawn_surface(scene, 0, nullptr);
      EXPECT_TRUE(plain->uv.empty());
      EXPECT_LE(plain->positions.size(), s->positions.size());
    }
}

TEST(LayerUv, a_vertex_is_split_only_where_uv_differ) {
  const auto positions = [](MeshHandle mesh) {
    Scene scene = scene_of(std::move(mesh), {layer_from(UvSource::mesh)});
    return drawn_surface(scene, 0, nullptr)->positions.size();
  };
  EXPECT_EQ(positions(two_triangles(false)), 4u);
  EXPECT_EQ(positions(two_triangles(true)), 6u);
}

TEST(LayerUv, what_is_no_number_is_0_for_the_whole_face) {
  const MeshHandle mesh = two_triangles(true, std::numeric_limits<double>::quiet_NaN());
  const CornerUv uv = uv_of({}, mesh);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(uv[c], glm::dvec2(0));
  EXPECT_EQ(uv[3], glm::dvec2(5));
  EXPECT_EQ(uv[5], glm::dvec2(0, 1));
}

TEST(LayerUv, what_a_mesh_does_not_have_is_said) {
  MeshData fan;  // three faces at one edge
  fan.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {-1, 0, -1}};
  for (const std::uint32_t i : {2u, 3u, 4u}) {
    const Corner face[3] = {{0, no_index, no_index}, {1, no_index, no_index}, {i, no_index, no_index}};
    fan.add_face(face, face + 3);
  }
  Scene scene = scene_of(Mesh::make(fan), {layer_from(UvSource::mesh), layer_from(UvSource::unwrap)});
  const std::vector<Text> notes = layer_notes(scene, nullptr);
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_NE(notes[0].en.find("thing: uv are 0: the mesh has no uv"), std::string::npos) << notes[0].en;
  const SurfaceHandle s = drawn_surface(scene, 0, nullptr);
  ASSERT_EQ(s->uv.size(), 2u);
  for (const auto& set : s->uv)
    for (const glm::vec2& p : set) EXPECT_EQ(p, glm::vec2(0));
}

TEST(LayerUv, elements_of_a_solution_have_projected_uv) {
  std::vector<TextureLayer> layers{layer_from(UvSource::mesh), layer_from(UvSource::projector),
                                   layer_from(UvSource::projector)};
  layers[2].target = LayerTarget::k_a;
  Scene scene = scene_of(shape("cube"), layers);
  RadiosityField field;
  field.objects = {{shape("cube"), {}}};
  field.objects[0].corners.assign(field.objects[0].mesh->data().corners.size(), glm::vec3(0.25f));
  scene.radiosity_field = std::make_shared<const RadiosityField>(field);
  scene.shading.ambient_source = AmbientSource::radiosity;
  const RadiosityField* drawn = drawn_field(scene);
  ASSERT_NE(drawn, nullptr);
  EXPECT_EQ(layer_uv(scene, 0, drawn).layers, (std::vector<const TextureLayer*>{&scene.material.layers[1]}));
  const SurfaceHandle s = drawn_surface(scene, 0, drawn);
  EXPECT_EQ(s->uv.size(), 1u);
  EXPECT_EQ(s->radiosity.size(), s->positions.size());
  EXPECT_EQ(s->uv[0].size(), s->positions.size());
  EXPECT_EQ(layer_notes(scene, drawn).size(), 2u);
}
