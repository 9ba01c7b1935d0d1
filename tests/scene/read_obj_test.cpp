#include <clocale>
#include <locale>

#include "tests/scene/reading.h"

namespace cg {
namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string cube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

TEST(ReadObj, CornersHaveTheirOwnUvAndNormal) {
  const Model model = read_bytes("obj",
                                 "v 0 0 0\nv 1.5 0 0\nv 0 -2e-3 0.25\nvt 0 1\nvt 0.5\nvt 1 0 7\nvn 0 0 1\nvn 0 0 -2\n"
                                 "f 1/1/1 2/2/1 3/3/2\nf -1 1//2 2/1\n");
  ASSERT_EQ(model.parts.size(), 1u);
  EXPECT_TRUE(model.notes.empty());
  const MeshData& d = model.parts[0].mesh->data();
  EXPECT_EQ(d.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {1.5, 0, 0}, {0, -2e-3, 0.25}}));
  EXPECT_EQ(d.uvs, (std::vector<glm::dvec2>{{0, 1}, {0.5, 0}, {1, 0}}));
  EXPECT_EQ(d.normals, (std::vector<glm::dvec3>{{0, 0, 1}, {0, 0, -2}}));
  EXPECT_EQ(d.first_corner, (std::vector<std::uint32_t>{0, 3, 6}));
  const std::vector<Corner> corners{{0, 0, 0},        {1, 0, 1},       {2, 1, 2}, {2, no_index, no_index},
                                    {0, 1, no_index}, {1, no_index, 0}};
  EXPECT_EQ(d.corners, corners);
}

// The same cube whatever the line ends, marks, blanks and signs.
TEST(ReadObj, FormsOfTheSameText) {
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
      text.replace(at, from.size(), to);
    return text;
  };
  const MeshData expected = read_bytes("obj", cube).parts[0].mesh->data();
  EXPECT_EQ(expected.positions.size(), 8u);
  EXPECT_EQ(expected.face_count(), 6u);
  for (const std::string& text :
       {with(cube, "\n", "\r\n"), with(cube, "\n", "\r"), "\xef\xbb\xbf" + cube, cube.substr(0, cube.size() - 1),
        with(cube, " ", " \t "), with(cube, "\n", "  # a comment\n"), with(cube, "\n", "\n\n"),
        with(cube, "v -1 ", "v -1.0e+0 "), with(cube, "f 1 4", "f 1 \\\n 4"), with(cube, "f 1 4", "f 1\\\r\n4"),
        "# ends in a backslash \\\n" + cube, "g \x95\x5c\n" + cube, "s off\nvp 0 0\n" + cube, "o a\n" + cube}) {
    SCOPED_TRACE(text);
    Model model;
    ASSERT_NO_THROW(model = read_bytes("obj", text));
    ASSERT_EQ(model.parts.size(), 1u);
    EXPECT_EQ(model.parts[0].mesh->data().positions, expected.positions);
    EXPECT_EQ(model.parts[0].mesh->data().corners, expected.corners);
    EXPECT_EQ(model.parts[0].mesh->data().first_corner, expected.first_corner);
  }
}

TEST(ReadObj, NegativeAndForwardIndices) {
  const Model model =
      read_bytes("obj", triangle + "f -3 -2 -1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf -3 -2 -1\nf 1 2 7\nv 9 9 9\n");
  EXPECT_EQ(face_count(model), 3u);
  EXPECT_EQ(positions_of_face(*model.parts[0].mesh, 1), (std::vector<glm::dvec3>{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}));
  EXPECT_EQ(positions_of_face(*model.parts[0].mesh, 2)[2], glm::dvec3(9, 9, 9));
}

TEST(ReadObj, NumbersKeepEveryBit) {
  const Model model = read_bytes("obj", "v 0.1 1e20 1e-20\nv 123456.789 1e-7 -0\nv 1e39 1e-400 1e300\nf 1 2 3\n");
  const auto& p = model.parts[0].mesh->data().positions;
  EXPECT_EQ(p[0], glm::dvec3(0.1, 1e20, 1e-20));
  EXPECT_EQ(p[1], glm::dvec3(123456.789, 1e-7, -0.0));
  EXPECT_EQ(p[2], glm::dvec3(1e39, 0, 1e300));
}

TEST(ReadObj, PartsByObjectAndMaterial) {
  const Model model =
      read_bytes("obj", triangle +
                            "v 0 0 1\nvt 0 0\nvt 1 1\nf 1 2 3\no a\nusemtl red\nf 2/1 3/1 4/2\nusemtl blue\nf 4 3 2\n"
                            "o b\nusemtl red\nf 1 2 4\no a\nf 4/2 1/2 2/2\n");
  ASSERT_EQ(model.parts.size(), 4u);
  EXPECT_EQ(model.parts[0].name, "part 1");
  EXPECT_EQ(model.parts[1].name, "a:red");
  EXPECT_EQ(model.parts[2].name, "a:blue");
  EXPECT_EQ(model.parts[3].name, "b");
  const MeshData& red = model.parts[1].mesh->data();
  EXPECT_EQ(red.face_count(), 2u);
  EXPECT_EQ(red.positions, (std::vector<glm::dvec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}));
  EXPECT_EQ(red.corners[2], (Corner{2, no_index, 1}));
  EXPECT_EQ(positions_of_face(*model.parts[1].mesh, 1), (std::vector<glm::dvec3>{{0, 0, 1}, {0, 0, 0}, {1, 0, 0}}));
  EXPECT_EQ(face_count(model), 5u);
}

TEST(ReadObj, GroupsNamePartsUntilThereIsAnObject) {
  const Model groups = read_bytes("obj", triangle + "g left hand\nf 1 2 3\ng right\nf 3 2 1\ng left hand\nf 2 3 1\n");
  ASSERT_EQ(groups.parts.size(), 2u);
  EXPECT_EQ(groups.parts[0].name, "left hand");
  EXPECT_EQ(groups.parts[0].mesh->data().face_count(), 2u);
  const Model objects = read_bytes("obj", triangle + "o one\ng a\nf 1 2 3\ng b\nf 3 2 1\n");
  ASSERT_EQ(objects.parts.size(), 1u);
  EXPECT_EQ(objects.parts[0].name, "one");
}

TEST(ReadObj, NamesAreReadableAndDifferent) {
  const Model model =
      read_bytes("obj", triangle + "o \x95\x5c\nf 1 2 3\no a:b\nf 1 2 3\no a\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\n");
  ASSERT_EQ(model.parts.size(), 4u);
  EXPECT_EQ(model.parts[0].name, "\\x95\\");
  EXPECT_EQ(model.parts[1].name, "a:b");
  EXPECT_EQ(model.parts[2].name, "a:b 2");
  EXPECT_EQ(model.parts[3].name, "a:c");
}

TEST(ReadObj, WhatIsNotDrawnIsNoted) {
  const Model model = read_bytes("obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0 1\nv 0 1 0 1\nl 1 2\ncall other.obj\nfo 1 2 3\n");
  ASSERT_EQ(model.notes.size(), 2u);
  EXPECT_EQ(model.notes[0].en,
            "2 lines, points, curves or calls were left out (the first in line 4): only faces are drawn");
  EXPECT_EQ(model.notes[1].en, "the colours of 2 vertices are not used");
}

TEST(ReadObj, Refused) {
  expect_refused("obj",
                 {{"", "test.obj:1: ", "no face"},
                  {triangle, "test.obj:3: ", "no face (3 vertices)"},
                  {"v nan 0 0\n" + cube, "test.obj:1: ", "'nan' is not a finite number"},
                  {"v 0 inf 0\n" + cube, "test.obj:1: ", "'inf' is not a finite number"},
                  {"v 0 0 1e400\n" + cube, "test.obj:1: ", "outside the range"},
                  {"\nv 0 0\n" + cube, "test.obj:2: ", "the line ends where a z coordinate"},
                  {"v -1,5 0 0\n" + cube, "test.obj:1: ", "comma"},
                  {"v 1x 0 0\n" + cube, "test.obj:1: ", "'1x' is not a number"},
                  {"v +-1 0 0\n" + cube, "test.obj:1: ", "'+-1' is not a number"},
                  {"v 0 0 0 1 2\n" + cube, "test.obj:1: ", "5 numbers"},
                  {"vt nan 0\n" + cube, "test.obj:1: ", "'nan'"},
                  {"vn 0 1\n" + cube, "test.obj:1: ", "the z of a normal"},
                  {"vn 0 1 0 0\n" + cube, "test.obj:1: ", "more than"},
                  {cube + "f 1/1 2/2 99999999/3\n", "test.obj:15: ", ""},
                  {cube + "f 1 2 9\n", "test.obj:15: ", "a face uses 9, but there are 8 vertices"},
                  {cube + "vt 0 0\nf 1/1 2/2 3/1\nf 1/1 2/3 3/1\n", "test.obj:17: ", "uses 3, but there are 1 texture"},
                  {cube + "vn 0 0 1\nf 1//1 2//1 -50000000//1\n", "test.obj:16: ", "'-50000000//1'"},
                  {cube + "vn 0 0 1\nf 1//1 2//1 3//-5\n", "test.obj:16: ", "but there are 1 normals"},
                  {cube + "f 1 2 99999999999999999999\n", "test.obj:15: ", "a face uses"},
                  {cube + "f 0 1 2\n", "test.obj:15: ", "a face uses '0'"},
                  {cube + "f //1 //1 //1\n", "test.obj:15: ", "'//1' is not the corner of a face"},
                  {cube + "f /1 /1 /1\n", "test.obj:15: ", "'/1' is not the corner of a face"},
                  {cube + "f 1/1/1/1 2 3\n", "test.obj:15: ", "is not the corner"},
                  {cube + "f a b c\n", "test.obj:15: ", "is not the corner"},
                  {cube + "f 1.5 2 3\n", "test.obj:15: ", "is not the corner"},
                  {cube + "f 1 2\n", "test.obj:15: ", "a face with 2 corners"},
                  {cube + "f\n", "test.obj:15: ", "a face with 0 corners"},
                  {cube + "\n\nff 1 2 3\n", "test.obj:17: ", "'ff' is not a statement"},
                  {"f \\\n 1 2 \\\n 3\n", "test.obj:1: ", "but there are 0 vertices"},
                  {"\xff\xd8\xff\xe0 JFIF", "test.obj:1: ", "'\\xff\\xd8\\xff\\xe0'"},
                  {std::string("\xff\xfe") + "v", "test.obj:1: ", "UTF-16"},
                  {std::string(200, 'x'), "test.obj:1: ", "xxxx…' is not a statement"}});
}

// A process under a locale with a decimal comma reads the same.
TEST(ReadObj, LocaleDoesNotMatter) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale old = std::locale::global(std::locale(std::locale(), new Comma));
  const Model model = read_bytes("obj", "v 0.5 0 0\nv 1.25 0 0\nv 0 1 0\nf 1 2 3\n");
  std::locale::global(old);
  EXPECT_EQ(model.parts[0].mesh->data().positions[1], glm::dvec3(1.25, 0, 0));
}

TEST(ReadObj, DownloadedModels) {
  const std::filesystem::path folder = SHADEBENCH_SOURCE_DIR "/../shared/data/models";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no models beside the project";
  struct Expected {
    const char* name;
    std::size_t positions, uvs, faces;
  };
  for (const Expected& e : {Expected{"cow.obj", 2903, 0, 5804}, Expected{"fandisk.obj", 6475, 0, 12946},
                            Expected{"spot.obj", 2930, 3225, 5856}, Expected{"stanford-bunny.obj", 35947, 0, 69451},
                            Expected{"teapot.obj", 3644, 0, 6320}}) {
    SCOPED_TRACE(e.name);
    const Model model = read_model(folder / e.name);
    ASSERT_EQ(model.parts.size(), 1u);
    EXPECT_EQ(model.parts[0].mesh->data().positions.size(), e.positions);
    EXPECT_EQ(model.parts[0].mesh->data().uvs.size(), e.uvs);
    EXPECT_EQ(model.parts[0].mesh->data().face_count(), e.faces);
  }
}

}  // namespace
}  // namespace cg
