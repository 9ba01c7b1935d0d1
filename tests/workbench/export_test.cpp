// What leaves the workbench: an OBJ that draws as the scene does, C with the functions of the course, files whole or
// not at all.
#include "workbench/export.h"

#include <gtest/gtest.h>

#include "params/file.h"
#include "params/input_error.h"
#include "scene/model_file.h"
#include "shading/surface.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"
#include "workbench/model_library.h"
#include "workbench/open.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

struct Vertex {
  glm::vec3 position, normal;
  friend bool operator==(const Vertex&, const Vertex&) = default;
};

// What OpenGL is given: three vertices a triangle, in order.
std::vector<Vertex> vertices(const Surface& s) {
  std::vector<Vertex> out;
  for (const std::uint32_t i : s.indices)
    out.push_back({s.positions[i] * float(s.radius) + glm::vec3(s.centre), s.normals[i]});
  return out;
}

TEST(ExportObj, DrawsWhatTheSceneDraws) {
  const TemporaryFolder folder;
  for (const std::string& model : bundled_models())
    for (const NormalRule rule : {NormalRule::file, NormalRule::face, NormalRule::mean, NormalRule::area})
      for (const double crease : {180.0, 40.0}) {
        Scene scene = open_model(find_model(model));
        scene.shading.normals = rule, scene.shading.crease_angle = crease;
        save_export(scene, ExportFormat::obj, folder / "a.obj");
        const Model read = read_model(folder / "a.obj");
        ASSERT_EQ(read.parts.size(), scene.objects.size());
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
          const SurfaceHandle drawn = make_surface(*scene.objects[i].mesh, rule, crease),
                              exported = make_surface(*read.parts[i].mesh, NormalRule::file, 180);
          ASSERT_TRUE(vertices(*exported) == vertices(*drawn)) << model << " " << int(rule) << " " << crease;
        }
      }
}

TEST(ExportObj, AConcaveFaceBecomesTriangles) {
  MeshData data;
  data.positions = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 1, 0}, {0, 4, 0}, {5, 5, 5}};
  const Corner arrow[5] = {{0}, {1}, {2}, {3}, {4}};
  data.add_face(arrow, arrow + 5);
  Scene scene;
  scene.objects.resize(1);
  scene.objects[0].name = "odd name # \\ \n";
  scene.objects[0].mesh = Mesh::make(data);
  const std::string text = export_obj(scene);
  EXPECT_EQ(std::count(text.begin(), text.end(), 'f'), 3 + 0) << text;
  EXPECT_NE(text.find("\no odd_name______x0a\n"), std::string::npos) << text;
}

TEST(ExportObj, LeavesOutWhatIsNotVisible) {
  Scene scene = open_scene("cornell-box.obj");
  scene.objects[0].visible = false;
  const std::string text = export_obj(scene);
  std::size_t objects = 0;
  for (std::size_t at = text.find("\no "); at != text.npos; at = text.find("\no ", at + 1)) ++objects;
  EXPECT_EQ(objects, scene.objects.size() - 1);
}

TEST(ExportC, HasTheFunctionsOfTheCourse) {
  const std::string text = export_c(open_scene("teapot"));
  for (const char* part : {"void set_lights( void )", "void set_material( void )", "void set_camera( double aspect )",
                           "    float light0_position[] = { 10.0, 10.0, 10.0, 1.0 };\n",
                           "    glLightfv( GL_LIGHT0, GL_POSITION, light0_position );\n",
                           "    gluLookAt( 0.0, 1.0, 3.4, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 );\n"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(ExportC, ACameraThatLooksAlongItsUpGetsAnother) {
  Scene scene = open_scene("teapot");
  scene.camera.position = {0, 3, 0};
  const std::string text = export_c(scene);
  EXPECT_NE(text.find("gluLookAt( 0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0 );"), std::string::npos) << text;
}

class ExportFileTest : public testing::Test {
 protected:
  // The message of the refusal.
  std::string refusal(ExportFormat format, const std::string& name) {
    return refusal_of([&] { save_export(scene, format, folder / name); });
  }
  const Scene scene = open_scene("cube");
  const TemporaryFolder folder;
};

TEST_F(ExportFileTest, EachFormat) {
  for (const auto& [format, name] : {std::pair(ExportFormat::json, "a.json"),
                                     {ExportFormat::c, "a.c"},
                                     {ExportFormat::obj, "a.OBJ"},
                                     {ExportFormat::glut, "b.c"}})
    EXPECT_EQ(refusal(format, name), "");
  EXPECT_EQ(open_scene((folder / "a.json").string()), scene);
  EXPECT_EQ(read_file(folder / "a.c"), export_text(scene, ExportFormat::c));
  EXPECT_EQ(read_file(folder / "b.c"), export_glut(scene, "b.obj"));
  EXPECT_EQ(read_file(folder / "b.obj"), export_obj(scene));
  EXPECT_TRUE(export_obj(scene).starts_with(exported_obj_begin));
}

TEST_F(ExportFileTest, ARefusalNamesWhatWouldWork) {
  EXPECT_NE(refusal(ExportFormat::glut, "a.obj").find("a.c would work"), std::string::npos);
  EXPECT_NE(refusal(ExportFormat::c, "a").find("a.c would work"), std::string::npos);
  EXPECT_NE(refusal(ExportFormat::json, "a.txt").find("a.json would work"), std::string::npos);
  EXPECT_NE(refusal(ExportFormat::obj, "missing/a.obj").find("missing"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST_F(ExportFileTest, AProgramsMeshesReplaceNoModelOfTheUsers) {
  save_file(folder / "mine.obj", "v 0 0 0\n");
  EXPECT_NE(refusal(ExportFormat::glut, "mine.c").find("another name"), std::string::npos);
  EXPECT_EQ(read_file(folder / "mine.obj"), "v 0 0 0\n");
  EXPECT_FALSE(fs::exists(folder / "mine.c"));
  EXPECT_EQ(refusal(ExportFormat::glut, "again.c"), "");
  EXPECT_EQ(refusal(ExportFormat::glut, "again.c"), "");  // its own may be replaced
}

TEST_F(ExportFileTest, NoFileBesideOneThatCannotBeWritten) {
  fs::create_directory(folder / "a.c");
  EXPECT_NE(refusal(ExportFormat::glut, "a.c"), "");
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name == "a.c" || name == "a.obj") << name;
  }
}

}  // namespace
}  // namespace cg
