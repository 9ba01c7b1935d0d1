// Files on the disk: which reader is taken, and which material files are opened.
#include "tests/scene/reading.h"

namespace cg {
namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string off = "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string red = "newmtl red\nKd 1 0 0\n";

std::string with_material(const std::string& mtllib) { return "mtllib " + mtllib + "\nusemtl red\n" + triangle; }

std::string notes_of(const Model& model) {
  std::string all;
  for (const Text& note : model.notes) all += note.en + "\n";
  return all;
}

TEST(ReadModel, TheExtensionDecidesThenTheFirstBytes) {
  TestFolder folder;
  EXPECT_EQ(face_count(read_model(folder.write("a.OBJ", triangle))), 1u);
  EXPECT_EQ(face_count(read_model(folder.write("a.off", off))), 1u);
  EXPECT_EQ(face_count(read_model(folder.write("no extension", off))), 1u);
  EXPECT_EQ(face_count(read_model(folder.write("a.txt", triangle))), 1u);
  EXPECT_THROW(read_model(folder.write("a.xyz", "0 0 0\n")), InputError);
  EXPECT_THROW(read_model(folder.write("a.ply", off)), InputError);
  EXPECT_THROW(read_model(folder / "missing.obj"), InputError);
  std::filesystem::create_directory(folder / "folder.obj");
  EXPECT_THROW(read_model(folder / "folder.obj"), InputError);
}

// Every face is kept; those of which nothing is drawn are counted.
TEST(ReadModel, OddFacesAreNoted) {
  TestFolder folder;
  const Model model =
      read_model(folder.write("a.obj", triangle + "v 2 0 0\nvn 0 0 0\nf 1 2 4\nf 1//1 2//1 2//1 3//1\nf 1 1 1\n"));
  EXPECT_EQ(face_count(model), 4u);
  EXPECT_EQ(notes_of(model),
            "2 of 4 faces have no area: nothing of them is drawn\n"
            "corners that repeat the vertex before them, taken once: 3\n"
            "normals without a length: 1\n");
}

TEST(ReadModel, MaterialFilesOfTheFolderAndBelow) {
  TestFolder folder;
  folder.write("red.mtl", red);
  folder.write("two words.mtl", red);
  folder.write("parts/deep.mtl", red);
  folder.write("blue.mtl", "newmtl blue\n");
  for (const char* name : {"red.mtl", "./red.mtl", "two words.mtl", "parts/deep.mtl", "parts\\deep.mtl",
                           "blue.mtl red.mtl", "parts/../red.mtl", "red.mtl  \t"}) {
    SCOPED_TRACE(name);
    const Model model = read_model(folder.write("a.obj", with_material(name)));
    EXPECT_EQ(notes_of(model), "");
    ASSERT_TRUE(model.parts[0].material.has_value());
    EXPECT_EQ(model.parts[0].material->k_d, glm::dvec3(1, 0, 0));
  }
}

// Nothing outside the model's folder is opened, by whatever name; the mesh opens without it.
TEST(ReadModel, NoMaterialFileOutsideTheFolder) {
  TestFolder folder;
  folder.write("secret.mtl", red);
  folder.write("models/inside.mtl", red);
  std::filesystem::create_symlink(folder / "secret.mtl", folder / "models/link.mtl");
  std::filesystem::create_directory(folder / "models/folder.mtl");
  for (const std::string& name :
       std::vector<std::string>{"../secret.mtl", "..\\secret.mtl", (folder / "secret.mtl").string(), "link.mtl",
                                "/dev/zero", "../../../../../../dev/zero", "/etc/passwd", "folder.mtl", "missing.mtl",
                                ".", "..", std::string("inside.mtl\0", 11), std::string(5000, 'x')}) {
    SCOPED_TRACE(name);
    const Model model = read_model(folder.write("models/a.obj", with_material(name)));
    EXPECT_EQ(face_count(model), 1u);
    EXPECT_FALSE(model.parts[0].material.has_value());
    EXPECT_NE(notes_of(model).find("is not in the model's folder"), std::string::npos) << notes_of(model);
  }
}

TEST(ReadModel, AWrongMaterialFileIsANote) {
  TestFolder folder;
  folder.write("bad.mtl", "newmtl red\nKd x\n");
  const Model model = read_model(folder.write("a.obj", with_material("bad.mtl")));
  EXPECT_FALSE(model.parts[0].material.has_value());
  EXPECT_TRUE(notes_of(model).starts_with("materials are left out: bad.mtl:2: 'x' is not a number")) << notes_of(model);
}

}  // namespace
}  // namespace cg
