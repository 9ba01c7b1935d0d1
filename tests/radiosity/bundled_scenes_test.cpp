// The scenes that are shipped for radiosity: which are closed, and what they are made of.
#include <gtest/gtest.h>

#include <map>

#include "math/transform.h"
#include "radiosity/patches.h"
#include "scene/model_file.h"

namespace cg {
namespace {

Scene bundled(const std::string& name) {
  const Model model = read_model(std::filesystem::path(SHADEBENCH_SOURCE_DIR) / "models" / (name + ".obj"));
  EXPECT_TRUE(model.notes.empty()) << name;
  Scene scene;
  for (const ModelPart& part : model.parts) {
    Object object;
    object.name = part.name;
    object.mesh = part.mesh;
    object.own_material = true;
    object.material = part.material.value();
    EXPECT_EQ(part.mesh->report(), MeshReport{}) << name << ' ' << part.name;
    scene.objects.push_back(object);
  }
  return scene;
}

Patches patches_of(const Scene& scene, double size) {
  Progress progress;
  return make_patches(scene, {.patch_size = size}, progress);
}

TEST(BundledScenes, AreClosedWhereTheySaySo) {
  for (const char* name : {"closed-cube", "sphere-interior", "furnished-room", "corridor"}) {
    const Patches p = patches_of(bundled(name), 0.25);
    EXPECT_TRUE(p.closed) << name;
    EXPECT_EQ(p.degenerate, 0u) << name;
  }
  for (const char* name : {"parallel-squares", "perpendicular-squares", "cornell-box"})
    EXPECT_FALSE(patches_of(bundled(name), 0.25).closed) << name;
}

TEST(BundledScenes, HaveTheirMeasuresAndLights) {
  const auto area = [](const char* name) {
    const Scene scene = bundled(name);
    std::map<std::string, double> out;
    for (const Patch& patch : patches_of(scene, 0.25).patches) {
      out["all"] += patch.area;
      out[scene.objects[patch.object].name] += patch.area;
      if (patch.emission.x > 0) out["lights"] += patch.area;
    }
    return out;
  };
  auto cube = area("closed-cube");
  EXPECT_NEAR(cube["all"], 6, 1e-13);
  EXPECT_NEAR(cube["floor"], 1, 1e-13);
  EXPECT_NEAR(cube["lights"], 1, 1e-13);
  auto sphere = area("sphere-interior");
  EXPECT_NEAR(sphere["all"], 4 * pi, 0.05);
  EXPECT_NEAR(sphere["lower"] / sphere["upper"], 1, 1e-12);
  EXPECT_NEAR(sphere["lights"], sphere["lower"], 1e-12);
  auto hall = area("corridor");
  EXPECT_NEAR(hall["all"], 4 * 16 + 2, 1e-12);
  EXPECT_NEAR(hall["lights"], 1, 1e-13);
  auto room = area("furnished-room");
  EXPECT_NEAR(room["window"], 1.4 * 2, 1e-12);
  EXPECT_NEAR(room["window"] + room["window-wall"], 4 * 2.7, 1e-12);
  EXPECT_NEAR(room["lights"], room["window"], 1e-13);
  for (const char* name : {"parallel-squares", "perpendicular-squares"}) EXPECT_NEAR(area(name)["all"], 2, 1e-14);
}

}  // namespace
}  // namespace cg
