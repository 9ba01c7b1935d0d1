// Models by name, fitted, and read once.
#include "workbench/model_library.h"

#include <gtest/gtest.h>

#include <set>

#include "params/file.h"
#include "params/input_error.h"
#include "raster/software.h"
#include "scene/shape.h"
#include "tests/temporary_folder.h"
#include "workbench/open.h"

namespace cg {
namespace {

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr const char* two_parts = "v 0 0 0\nv 8 0 0\nv 0 8 0\nv 0 0 8\no floor\nf 1 2 3\no wall\nf 1 2 4\n";

// The farthest that a vertex of the scene lies from the origin.
double reach(const Scene& scene) {
  double out = 0;
  for (const Object& object : scene.objects)
    for (const glm::dvec3& p : object.mesh->data().positions)
      out = std::max(out, glm::length(glm::dvec3(matrix(object.transform) * glm::dvec4(p, 1))));
  return out;
}

TEST(ModelLibrary, EveryShapeOpensAsItIs) {
  for (const Shape& shape : shapes()) {
    const Scene scene = open_scene(std::string(shape.id));
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.objects[0].transform, Transform{});
    EXPECT_EQ(open_scene(std::string(shape.id)), scene);
  }
}

TEST(ModelLibrary, BundledModelsOpenByName) {
  for (const std::string& name : bundled_models()) {
    const Scene scene = open_scene(name);
    EXPECT_LE(reach(scene), 1.01) << name;
    EXPECT_EQ(scene.objects.at(0).model, name);
    EXPECT_EQ(open_scene(std::filesystem::path(name).stem().string()).objects.size() > 0, true);
  }
}

// Seen from in front, as it was photographed: all of its parts, about the origin.
TEST(ModelLibrary, TheCornellBoxFillsThePicture) {
  const Scene scene = open_scene("cornell-box.obj");
  ASSERT_EQ(scene.objects.size(), 8u);
  EXPECT_GT(reach(scene), 0.99);
  const Technique software = software_technique();
  const View view{.width = 64, .height = 64, .ids = true};
  Progress progress;
  const Frame frame = software.render(scene, software.plan(scene, view), view, progress);
  std::set<int> seen(frame.object.pixels().begin(), frame.object.pixels().end());
  seen.erase(nothing);
  EXPECT_GE(seen.size(), 7u);  // the ceiling or the light may be seen edge-on
}

TEST(ModelLibrary, UnknownNamesListWhatThereIs) {
  for (const char* name : {"teapto", "", "no/such.obj", "/", "."}) try {
      open_scene(name);
      ADD_FAILURE() << name;
    } catch (const InputError& e) {
      const std::string message = e.message(Language::english);
      EXPECT_TRUE(message.find("teapot") != message.npos || message.find("folder") != message.npos) << message;
    }
}

TEST(ModelLibrary, FilesAreFittedInShortNumbers) {
  const TemporaryFolder folder;
  const auto scaled = [&](double s, double offset) {
    std::string text;
    for (const glm::dvec3& p : {glm::dvec3(-1, -1, 0), glm::dvec3(1, -1, 0), glm::dvec3(0, 1, 0)}) {
      text += "v";
      for (int i = 0; i < 3; ++i) text += " " + std::to_string(p[i] * s + offset);
      text += "\n";
    }
    save_file(folder / "t.obj", text + "f 1 2 3\n");
    return open_scene((folder / "t.obj").string());
  };
  for (const double s : {0.01, 1.0, 3.7, 1e6})
    for (const double offset : {0.0, 2.5, 1e6}) {
      const Scene scene = scaled(s, offset);
      EXPECT_NEAR(reach(scene), 1, 0.01) << s << " " << offset;
    }
  const Transform t = fitting_transform({0.5, -12345.678, 0}, 3);
  EXPECT_EQ(t.scale, glm::dvec3(0.333));
  EXPECT_EQ(t.translate, glm::dvec3(-0.167, 4111.111, 0));
  EXPECT_FALSE(std::signbit(t.translate.z));
  EXPECT_EQ(fitting_transform({0, 0, 0}, 0), Transform{});
  EXPECT_EQ(fitting_transform({0, 0, 0}, 1e-40).scale, glm::dvec3(1e30));
}

TEST(ModelLibrary, PartsShareOneTransformAndAreFoundAgain) {
  const TemporaryFolder folder;
  save_file(folder / "room.obj", two_parts);
  Scene scene = open_scene((folder / "room.obj").string());
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.objects[0].part, "floor");
  EXPECT_EQ(scene.objects[1].name, "wall");
  EXPECT_EQ(scene.objects[0].transform, scene.objects[1].transform);
  const MeshHandle wall = scene.objects[1].mesh;
  scene.objects[0].part = "wall";
  scene.objects[1].part = "";
  load_meshes(scene);
  EXPECT_EQ(scene.objects[0].mesh, wall);
  EXPECT_EQ(scene.objects[1].mesh->data().face_count(), 2u);
  scene.objects[0].part = "roof";
  const Scene before = scene;
  EXPECT_THROW(load_meshes(scene), InputError);
  EXPECT_EQ(scene, before);
}

TEST(ModelLibrary, AChangedFileIsReadAgain) {
  const TemporaryFolder folder;
  const std::string file = (folder / "a.obj").string();
  save_file(file, triangle);
  Scene scene = open_scene(file);
  const MeshHandle first = scene.objects[0].mesh;
  load_meshes(scene);
  EXPECT_EQ(scene.objects[0].mesh, first);
  save_file(file, std::string(triangle) + "f 3 2 1\n");
  load_meshes(scene);
  EXPECT_EQ(scene.objects[0].mesh->data().face_count(), 2u);
  save_file(file, "broken");
  const Scene before = scene;
  EXPECT_THROW(load_meshes(scene), InputError);
  EXPECT_EQ(scene, before);
}

TEST(SetParameter, AddsTheNextLightAndReloads) {
  Scene scene = open_scene("torus");
  set_parameter(scene, "lights.1.position=1,2,3");
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[1].position, glm::dvec3(1, 2, 3));
  set_parameter(scene, "material.k_d=0.5");
  EXPECT_EQ(scene.material.k_d, glm::dvec3(0.5));
  set_parameter(scene, "objects.1.model=cube");
  load_meshes(scene);
  EXPECT_EQ(scene.objects.size(), 2u);
  const std::size_t faces = scene.objects[0].mesh->data().face_count();
  set_parameter(scene, "objects.0.tessellation=12");
  load_meshes(scene);
  EXPECT_NE(scene.objects[0].mesh->data().face_count(), faces);
  const Scene before = scene;
  for (const char* bad : {"material.k_d", "material.kd=1", "lights.3.w=1", "material.n=-1", "lights.2.w=nan", "=1",
                          "objects.0.model=none", "lights.2.none=1"})
    EXPECT_THROW(set_parameter(scene, bad), InputError) << bad;
  EXPECT_EQ(scene, before);
}

}  // namespace
}  // namespace cg
