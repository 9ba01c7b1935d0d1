#include "workbench/scene_change.h"

#include <gtest/gtest.h>

namespace cg {
namespace {

TEST(SceneChange, NamesWhatChangedAndNoMore) {
  Scene a;
  a.objects.resize(1);
  const auto changed = [&](auto edit) {
    Scene b = a;
    edit(b);
    return text_of(scene_change(a, b)).en;
  };
  EXPECT_EQ(changed([](Scene&) {}), "");
  EXPECT_EQ(changed([](Scene& s) { s.camera.position.x = 9; }), "the camera");
  EXPECT_EQ(changed([](Scene& s) { s.lights[0].w = 0; }), "the light");
  EXPECT_EQ(changed([](Scene& s) { s.shading.reflection = Reflection::reflection_vector; }), "the light");
  EXPECT_EQ(changed([](Scene& s) { s.shading.ambient_source = AmbientSource::radiosity; }), "the light");
  EXPECT_EQ(changed([](Scene& s) { s.radiosity_field = std::make_shared<RadiosityField>(); }),
            "the radiosity solution");
  EXPECT_EQ(changed([](Scene& s) { s.radiosity.resolution = 64; }), "");  // not before it is solved again
  EXPECT_EQ(changed([](Scene& s) { s.material.n = 3; }), "the material");
  EXPECT_EQ(changed([](Scene& s) { s.objects[0].own_material = true; }), "the material");
  EXPECT_EQ(changed([](Scene& s) { s.objects[0].transform.scale.x = 2; }), "the shapes");
  EXPECT_EQ(changed([](Scene& s) { s.objects.clear(); }), "the shapes, the material");
  EXPECT_EQ(changed([](Scene& s) { s.shading.normals = NormalRule::mean; }), "the shapes");
  EXPECT_EQ(changed([](Scene& s) { s.shading.mode = ShadingMode::flat; }), "the shapes, the light");
  EXPECT_EQ(changed([](Scene& s) { s.display.background = {1, 1, 1}; }), "the background");
  EXPECT_EQ(changed([](Scene& s) { s.display.exposure = 1; }), "the display");
  EXPECT_EQ(changed([](Scene& s) { s.objects[0].name = "other"; }), "");
}

}  // namespace
}  // namespace cg
