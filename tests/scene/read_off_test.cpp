#include "tests/scene/reading.h"

namespace cg {
namespace {

const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n";
const std::string faces = "4 0 1 2 3\n3 2 1 0\n";

TEST(ReadOff, FormsOfTheSameText) {
  for (const std::string& text : std::vector<std::string>{
           "OFF\n4 2 6\n" + vertices + faces, "OFF 4 2 6\n" + vertices + faces, "OFF4 2 6\n" + vertices + faces,
           "# c\nOFF # c\n\n# c\n4 2 6 # c\n# c\n" + vertices + "# c\n\n" + faces + "\n# c\n",
           "OFF\n4 2\n" + vertices + faces,
           "OFF\r\n4 2 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 .5\r\n4 0 1 2 3\r\n3 2 1 0\r\n",
           "OFF\r4 2 0\r0 0 0\r1 0 0\r1 1 0\r0 1 .5\r4 0 1 2 3\r3 2 1 0",
           "OFF 4 2 6\n" + vertices + "4 0 1 2 3 255 0 0\n3 2 1 0 0.5 0.5 0.5 1\n",
           "OFF 4 2 6\n" + vertices + "4 0 1 2 3 7\n3 2 1 0\n"}) {
    SCOPED_TRACE(text);
    Model model;
    ASSERT_NO_THROW(model = read_bytes("off", text));
    const MeshData& d = model.parts[0].mesh->data();
    EXPECT_EQ(d.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}}));
    EXPECT_EQ(d.first_corner, (std::vector<std::uint32_t>{0, 4, 7}));
    EXPECT_EQ(d.corners[6], (Corner{0, no_index, no_index}));
  }
}

TEST(ReadOff, NormalsColoursAndUv) {
  struct Case {
    std::string keyword, behind;
    bool normals, uvs, colours;
  };
  for (const Case& c : {Case{"NOFF", " 0 0 2", true, false, false}, Case{"COFF", " 255 0 0 255", false, false, true},
                        Case{"COFF", " 1 0 0", false, false, true}, Case{"STOFF", " 0.25 0.75", false, true, false},
                        Case{"STCNOFF", " 0 0 2 1 0 0 1 0.25 0.75", true, true, true},
                        Case{"STCOFF", " 1 0 0 0.25 0.75", false, true, true}}) {
    SCOPED_TRACE(c.keyword);
    std::string text = c.keyword + "\n3 1 0\n";
    for (const char* p : {"0 0 0", "1 0 0", "0 1 0"}) text += p + c.behind + "\n";
    const Model model = read_bytes("off", text + "3 0 1 2\n");
    const MeshData& d = model.parts[0].mesh->data();
    EXPECT_EQ(d.positions[1], glm::dvec3(1, 0, 0));
    EXPECT_EQ(d.normals.size(), c.normals ? 3u : 0u);
    EXPECT_EQ(d.uvs.size(), c.uvs ? 3u : 0u);
    if (c.normals) {
      EXPECT_EQ(d.normals[2], glm::dvec3(0, 0, 2));
    }
    if (c.uvs) {
      EXPECT_EQ(d.uvs[2], glm::dvec2(0.25, 0.75));
    }
    EXPECT_EQ(d.corners[1], (Corner{1, c.normals ? 1u : no_index, c.uvs ? 1u : no_index}));
    EXPECT_EQ(model.notes.size(), c.colours ? 1u : 0u);
  }
}

TEST(ReadOff, Refused) {
  expect_refused("off", {{"", "test.off:1: ", "the file is empty"},
                         {"OFF\n", "test.off:1: ", "ends before the counts"},
                         {"OFF BINARY\n\1\2\3", "test.off:1: ", "a binary OFF file"},
                         {"4OFF\n", "test.off:1: ", "three dimensions"},
                         {"nOFF\n3\n", "test.off:1: ", "three dimensions"},
                         {"ply\n", "test.off:1: ", "begins with 'ply'"},
                         {"OFF\n4\n" + vertices + faces, "test.off:2: ", "the number of faces"},
                         {"OFF\n4 2 6 8\n" + vertices + faces, "test.off:2: ", "more than this line"},
                         {"OFFx 4 2 6\n" + vertices + faces, "test.off:1: ", "'x' is not a whole number"},
                         {"OFF\n-4 -2 0\n", "test.off:2: ", "a count below 0"},
                         {"OFF\n4 0 0\n" + vertices, "test.off:2: ", "no face"},
                         {"OFF\n4000000000 2 6\n" + vertices + faces, "test.off:2: ", "4000000000 vertices"},
                         {"OFF\n4 4000000000 6\n" + vertices + faces, "test.off:2: ", "4000000000 faces"},
                         {"OFF\n4 3 6\n" + vertices + faces, "test.off:8: ", "the file ends after 2 of 3 faces"},
                         {"OFF\n4 1 6\n" + vertices + faces, "test.off:8: ", "more lines than the counts"},
                         {"OFF\n3 2 6\n" + vertices + faces, "test.off:6: ", ""},
                         {"OFF\n5 2 6\n" + vertices + faces, "test.off:7: ", "more than this line"},
                         {"OFF\n4 2 6\nnan" + vertices + faces, "test.off:3: ", "'nan0' is not a number"},
                         {"OFF\n4 2 6\ninf 0 0\n" + vertices + faces, "test.off:3: ", "'inf' is not a finite"},
                         {"OFF\n4 2 6\n0 0\n" + vertices + faces, "test.off:3: ", "the line ends"},
                         {"OFF\n4 2 6\n0 0 0 1\n" + vertices + faces, "test.off:3: ", "NOFF"},
                         {"OFF\n4 1 6\n" + vertices + "3 0 1 4\n", "test.off:7: ", "vertex 4, but there are 4"},
                         {"OFF\n4 1 6\n" + vertices + "3 0 1 -1\n", "test.off:7: ", "vertex -1"},
                         {"OFF\n4 1 6\n" + vertices + "4000000000 0 1 2\n", "test.off:7: ", "the line ends"},
                         {"OFF\n4 1 6\n" + vertices + "-3 0 1 2\n", "test.off:7: ", "a face with -3 corners"},
                         {"OFF\n4 1 6\n" + vertices + "2 0 1\n", "test.off:7: ", "a face with 2 corners"},
                         {"OFF\n4 1 6\n" + vertices + "3 0 1 2 255 0\n", "test.off:7: ", "2 values behind"}});
}

}  // namespace
}  // namespace cg
