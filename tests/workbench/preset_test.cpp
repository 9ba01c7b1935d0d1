// Presets: every scene reads back bit for bit, only what differs is written, and each mistake is named.
#include "workbench/preset.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "params/file.h"
#include "params/input_error.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"
#include "tests/workbench/random_scene.h"
#include "workbench/open.h"

namespace cg {
namespace {

std::string error_of(const std::string& json) {
  std::string message = refusal_of([&] { scene_of(parse_json(json, "a.json"), "a.json"); });
  EXPECT_FALSE(message.empty()) << "accepted: " << json;
  return message;
}

Scene read(const std::string& json) { return scene_of(parse_json(json, "a.json"), "a.json"); }

TEST(Preset, RandomScenesReadBackBitForBit) {
  std::mt19937_64 random(21);
  for (int round = 0; round < 300; ++round) {
    Scene scene = random_scene(random);
    load_meshes(scene);
    const std::string text = to_json(preset_of(scene));
    Scene back = scene_of(parse_json(text, "a.json"), "a.json");
    ASSERT_EQ(back, scene) << text;
    ASSERT_EQ(to_json(values_of(slots(back))), to_json(values_of(slots(scene))));
    ASSERT_EQ(to_json(preset_of(back)), text);
  }
}

TEST(Preset, HoldsOnlyWhatDiffers) {
  Scene scene = open_scene("teapot");
  EXPECT_EQ(to_json(preset_of(scene), 0), R"({"schema":1,"model":"teapot"})");
  scene.material.k_d = {1, 0, 0};
  scene.lights.emplace_back();
  scene.lights[1].kind = LightKind::spot;
  EXPECT_EQ(to_json(preset_of(scene), 0),
            R"({"schema":1,"model":"teapot","lights":{"1":{"kind":"spot"}},"material":{"k_d":[1,0,0]}})");
  scene.lights.clear();
  scene.objects.clear();
  EXPECT_EQ(to_json(preset_of(scene), 0), R"({"schema":1,"lights":{"0":null},"material":{"k_d":[1,0,0]}})");
}

// Those beside the models look into them: no lamp, light from the surfaces alone.
TEST(Preset, TheBundledOnesOpen) {
  std::size_t found = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(SHADEBENCH_SOURCE_DIR) / "models")) {
    if (entry.path().extension() != ".json") continue;
    const Scene scene = open_scene(entry.path().string());
    EXPECT_EQ(scene.shading.ambient_source, AmbientSource::radiosity) << entry.path();
    EXPECT_FALSE(scene.lights[0].enabled);
    bool emits = false;
    for (const Object& object : scene.objects) emits = emits || object.material.emission != glm::dvec3(0);
    EXPECT_TRUE(emits) << entry.path();
    ++found;
  }
  EXPECT_EQ(found, 7u);
}

TEST(Preset, AddsAndTakesAwayItems) {
  EXPECT_EQ(read(R"({"schema":1})").objects.size(), 0u);
  EXPECT_EQ(read(R"({"schema":1,"model":"cube","lights":{"1":{},"2":{"kind":"spot"}}})").lights.size(), 3u);
  EXPECT_EQ(read(R"({"schema":1,"model":"cube","lights":{"2":{},"1":{}}})").lights.size(), 3u);
  EXPECT_EQ(read(R"({"schema":1,"model":"cube","lights":{"0":null}})").lights.size(), 0u);
  EXPECT_EQ(read(R"({"schema":1,"model":"cube","lights":{"0":null,"1":{"w":0.5}}})").lights[0].w, 0.5);
  EXPECT_EQ(read(R"({"schema":1,"model":"cube","lights":{}})").lights.size(), 1u);
  const Scene two = read(R"({"schema":1,"model":"cube","objects":{"1":{"model":"torus"}}})");
  ASSERT_EQ(two.objects.size(), 2u);
  EXPECT_EQ(two.objects[1].mesh, open_scene("torus").objects[0].mesh);
}

TEST(Preset, MistakesAreNamed) {
  const auto has = [](const std::string& json, const std::string& part) {
    const std::string error = error_of(json);
    EXPECT_NE(error.find(part), std::string::npos) << error;
  };
  has("[]", "a.json: this is no preset");
  has("{}", "a.json: schema: the preset has no version");
  has(R"({"schema":2})", "version 2 is not known");
  has(R"({"schema":"1"})", "schema");
  has(R"({"schema":1,"model":"teapto"})", "a.json: teapto: there is no such model");
  has(R"({"schema":1,"model":3})", "a.json: model");
  has(R"({"schema":1,"materal":{"n":1}})", "a.json: materal: there is no such parameter; known are: material");
  has(R"({"schema":1,"materal":{}})", "a.json: materal");
  has(R"({"schema":1,"material":{"kd":1}})", "a.json: material.kd: there is no such parameter; known are: material.k_");
  has(R"({"schema":1,"material":{"n":-1}})", "a.json: material.n: -1 is not possible here; give a number from 0 to");
  has(R"({"schema":1,"material":{"n":null}})", "a.json: material.n");
  has(R"({"schema":1,"material":null})", "a.json: material");
  has(R"({"schema":1,"material":{"n":{"x":1}}})", "a.json: material.n");
  has(R"({"schema":1,"material.n":1})", "a dot in a key");
  has(R"({"schema":1,"shading":{"mode":"fong"}})", "flat, gouraud, phong");
  has(R"({"schema":1,"lights":[{}]})", "a.json: lights: this is no list; write it as an object");
  has(R"({"schema":1,"lights":{"2":{}}})", "a.json: lights.2: there is no such item; the next new one is 1");
  has(R"({"schema":1,"lights":{"1":null}})", "a.json: lights.1");
  has(R"({"schema":1,"lights":{"00":{}}})", "a.json: lights.00");
  has(R"({"schema":1,"lights":{"-1":{}}})", "a.json: lights.-1");
  has(R"({"schema":1,"lights":{"0":3}})", "a.json: lights.0");
  has(R"({"schema":1,"objects":{"0":{}}})", "a.json: objects.0.model: the object has no model");
  has(R"({"schema":1,"model":"cube","objects":{"0":{"model":"none.obj"}}})", "none.obj: there is no such model");
  has(R"({"schema":1,"model":"cube","objects":{"0":{"tessellation":1999}}})", "objects.0.tessellation");
  std::string many = R"({"schema":1,"lights":{)";
  for (int i = 0; i < 65; ++i) many += (i ? "," : "") + ("\"" + std::to_string(i) + "\":{}");
  has(many + "}}", "there may be 64");
}

TEST(Preset, ModelsAreFoundBesideIt) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  save_file(folder / "三 角.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  Scene scene = open_scene((folder / "三 角.obj").string());
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_TRUE(std::filesystem::path(scene.objects[0].model).is_absolute());
  scene.shading.mode = ShadingMode::phong;
  save_preset(scene, folder / "a.json");
  EXPECT_NE(read_file(folder / "a.json").find("\"model\": \"三 角.obj\""), std::string::npos);
  EXPECT_EQ(read_preset(folder / "a.json"), scene);
  EXPECT_EQ(open_scene((folder / "a.json").string()), scene);
  save_preset(scene, folder / "sub/b.json");  // not below: by its whole path
  EXPECT_EQ(read_preset(folder / "sub/b.json"), scene);
  EXPECT_THROW(read_preset(folder / "none.json"), InputError);
  EXPECT_THROW(save_preset(scene, folder / "none/c.json"), InputError);
}

}  // namespace
}  // namespace cg
