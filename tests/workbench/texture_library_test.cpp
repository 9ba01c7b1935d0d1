#include "workbench/texture_library.h"

#include <gtest/gtest.h>

#include "image/image_file.h"
#include "params/file.h"
#include "tests/temporary_folder.h"
#include "workbench/open.h"
#include "workbench/preset.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

// Red at the top left, else black.
Picture corner_picture() {
  Picture p(3, 2);
  p.at(0, 0) = {255, 0, 0, 255};
  return p;
}

Scene with_layer(const std::string& image) {
  Scene scene = open_scene("teapot");
  scene.material.layers.resize(1);
  scene.material.layers[0].image = image;
  return scene;
}

TEST(TextureLibrary, APictureStandsUpright) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "corner.png";
  write_image(file, corner_picture());
  Scene scene = with_layer(file);
  std::vector<InputError> bad;
  load_textures(scene, &bad);
  EXPECT_TRUE(bad.empty());
  const TextureHandle texture = scene.material.layers[0].texture;
  ASSERT_TRUE(texture);
  EXPECT_EQ(texture->width(), 3);
  EXPECT_EQ(texture->height(), 2);
  EXPECT_EQ(texture->texel(0, 0, 1), glm::vec4(1, 0, 0, 1));  // uv (0, 1) is the top left
  EXPECT_EQ(texture->texel(0, 0, 0), glm::vec4(0, 0, 0, 1));
  Scene again = with_layer(file);
  load_textures(again);
  EXPECT_EQ(again.material.layers[0].texture, texture) << "read once";
  again.material.layers[0].encoding = Encoding::srgb;
  load_textures(again);
  EXPECT_NE(again.material.layers[0].texture, texture);
}

TEST(TextureLibrary, APaintedFileIsReadAgain) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "painted.png";
  write_image(file, corner_picture());
  Scene scene = with_layer(file);
  load_textures(scene);
  write_image(file, Picture(5, 5));
  load_textures(scene);
  EXPECT_EQ(scene.material.layers[0].texture->width(), 5);
}

TEST(TextureLibrary, WhatCannotBeReadIsSeenAndSaid) {
  const TemporaryFolder folder;
  save_file(folder.path() / "empty.png", "");
  save_file(folder.path() / "text.png", "no picture");
  write_image(folder.path() / "whole.png", corner_picture());
  const std::string whole = read_file(folder.path() / "whole.png");
  save_file(folder.path() / "cut.png", whole.substr(0, whole.size() / 2));
  for (const char* name : {"empty.png", "text.png", "cut.png", "missing.png"}) {
    Scene scene = with_layer(folder.path() / name);
    std::vector<InputError> bad;
    load_textures(scene, &bad);
    ASSERT_EQ(bad.size(), 1u) << name;
    EXPECT_NE(bad[0].message(Language::english).find(name), std::string::npos) << bad[0].message(Language::english);
    EXPECT_TRUE(bad[0].where.starts_with("material.layers.0.image")) << bad[0].where;
    ASSERT_TRUE(scene.material.layers[0].texture) << name;
    EXPECT_EQ(scene.material.layers[0].texture->width(), TextureImage::placeholder()->width()) << name;
    EXPECT_EQ(scene.material.layers[0].image, (folder.path() / name).string()) << "the name is not lost";
  }
}

TEST(TextureLibrary, APresetNamesPicturesBesideIt) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "pictures");
  const fs::path file = folder.path() / "pictures" / "corner.png", preset = folder.path() / "scene.json";
  write_image(file, corner_picture());
  Scene scene = with_layer(file);
  scene.objects[0].own_material = true;
  scene.objects[0].material.layers.resize(2);
  scene.objects[0].material.layers[1].image = file;
  load_textures(scene);
  save_preset(scene, preset);
  EXPECT_NE(read_file(preset).find("\"pictures/corner.png\""), std::string::npos) << read_file(preset);
  EXPECT_EQ(read_preset(preset), scene);
  fs::remove(file);
  const Scene without = read_preset(preset);  // a missing picture loses nothing of the rest
  EXPECT_EQ(without.material.layers[0].image, file.string());
  EXPECT_EQ(without.objects[0].material.layers.size(), 2u);
}

TEST(TextureLibrary, LayersAreAddedByTheirPath) {
  Scene scene = open_scene("teapot");
  set_parameter(scene, "material.layers.0.target=k_d");
  set_parameter(scene, "objects.0.material.layers.0.blend=decal");
  set_parameter(scene, "objects.0.unwrapping.seams.0.b=7");
  ASSERT_EQ(scene.material.layers.size(), 1u);
  EXPECT_EQ(scene.material.layers[0].target, LayerTarget::k_d);
  ASSERT_EQ(scene.objects[0].material.layers.size(), 1u);
  EXPECT_EQ(scene.objects[0].unwrapping.seams[0].b, 7);
  EXPECT_THROW(set_parameter(scene, "material.layers.2.target=k_d"), InputError);
  for (std::size_t i = 1; i < most_layers; ++i)
    set_parameter(scene, "material.layers." + std::to_string(i) + ".visible=false");
  EXPECT_THROW(set_parameter(scene, "material.layers.16.visible=false"), InputError);
  const Tree preset = preset_of(scene);
  EXPECT_EQ(scene_of(preset, "test"), scene);
  Scene fewer = scene;
  fewer.material.layers.resize(3);
  EXPECT_EQ(scene_of(preset_of(fewer), "test"), fewer);
}

}  // namespace
}  // namespace cg
