#include <algorithm>
#include <bit>

#include "tests/scene/reading.h"

namespace cg {
namespace {

const std::string corners = "-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n";
const std::string quads = "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

// A header of 8 vertices and 6 faces, with more lines behind the vertex's and the face's properties.
std::string header(const std::string& format = "ascii", const std::string& vertex = "", const std::string& face = "") {
  return "ply\nformat " + format + " 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n" +
         vertex + "element face 6\nproperty list uchar int vertex_indices\n" + face + "end_header\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// Writes numbers as a binary PLY of either order has them.
class Bytes {
 public:
  explicit Bytes(bool big) : swap_(big == (std::endian::native == std::endian::little)) {}
  template <class T>
  Bytes& add(T value) {
    std::string raw(reinterpret_cast<const char*>(&value), sizeof(T));
    if (swap_) std::reverse(raw.begin(), raw.end());
    text += raw;
    return *this;
  }
  std::string text;

 private:
  bool swap_;
};

TEST(ReadPly, Text) {
  const Model model = read_bytes("ply", header() + corners + quads);
  ASSERT_EQ(model.parts.size(), 1u);
  EXPECT_TRUE(model.notes.empty());
  const MeshData& d = model.parts[0].mesh->data();
  ASSERT_EQ(d.positions.size(), 8u);
  EXPECT_EQ(d.positions[6], glm::dvec3(1, 1, 1));
  EXPECT_EQ(d.face_count(), 6u);
  EXPECT_EQ(d.corners[1], (Corner{3, no_index, no_index}));
  EXPECT_TRUE(d.normals.empty() && d.uvs.empty());
}

TEST(ReadPly, FormsOfTheSameText) {
  const auto with_lines = [](std::string text, const std::string& end) {
    std::string out;
    for (char c : text) out += c == '\n' ? end : std::string(1, c);
    return out;
  };
  const std::string plain = header() + corners + quads;
  const MeshData expected = read_bytes("ply", plain).parts[0].mesh->data();
  for (const std::string& text :
       {with_lines(plain, "\r\n"), with_lines(plain, "\r"), plain.substr(0, plain.size() - 1),
        replaced(plain, "list uchar int", "list uint32 uint32"), replaced(plain, "list uchar int", "list int short"),
        replaced(plain, "list uchar int", "list char uint8"), replaced(plain, "vertex_indices", "vertex_index"),
        replaced(plain, "format", "comment element vertex 9\nobj_info element vertex 99999999\nformat"),
        replaced(plain, "float x", "double x"),
        replaced(plain, "end_header", "obj_info x\nelement nothing 0\nend_header"),
        replaced(plain, "end_header", "element nothing 99\nend_header")}) {
    SCOPED_TRACE(text);
    Model model;
    ASSERT_NO_THROW(model = read_bytes("ply", text));
    EXPECT_EQ(model.parts[0].mesh->data().positions, expected.positions);
    EXPECT_EQ(model.parts[0].mesh->data().corners, expected.corners);
  }
}

TEST(ReadPly, NormalsAndUvOfVertices) {
  for (const auto& [first, second] : {std::pair{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}}) {
    const std::string text =
        std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float nx\n") +
        "property float ny\nproperty float nz\nproperty list uchar int skip\nproperty double y\n" +
        "property float z\nproperty uchar red\nproperty float " + second + "\nproperty float " + first +
        "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
        "0 0 0 1 0 10 20 255 0.25 0.5\n1 0 0 1 2 7 7 11 21 255 0.75 1\n2 0 1 0 1 7 12 22 0 0 0\n3 2 1 0\n";
    const Model model = read_bytes("ply", text);
    const MeshData& d = model.parts[0].mesh->data();
    EXPECT_EQ(d.positions[1], glm::dvec3(1, 11, 21));
    EXPECT_EQ(d.normals[2], glm::dvec3(0, 1, 0));
    EXPECT_EQ(d.uvs[0], glm::dvec2(0.5, 0.25));
    EXPECT_EQ(d.corners[0], (Corner{2, 2, 2}));
    EXPECT_EQ(model.notes.size(), 1u);
  }
}

TEST(ReadPly, UvOfCorners) {
  std::string faces;
  for (int f = 0; f < 6; ++f)
    faces +=
        quads.substr(std::size_t(10 * f), 9) + (f == 2 ? " 0\n" : " 8 0 0 1 0 1 1 0." + std::to_string(f) + " 1\n");
  const Model model = read_bytes("ply", header("ascii", "", "property list uchar float texcoord\n") + corners + faces);
  const MeshData& d = model.parts[0].mesh->data();
  EXPECT_EQ(d.face_count(), 6u);
  EXPECT_EQ(d.uvs.size(), 20u);
  EXPECT_EQ(d.uvs[d.corners[23].uv], glm::dvec2(0.5, 1));
  EXPECT_EQ(d.corners[8].uv, no_index);
}

TEST(ReadPly, BytesInEitherOrderAgreeWithText) {
  const MeshData expected = read_bytes("ply", header() + corners + quads).parts[0].mesh->data();
  for (bool big : {false, true}) {
    Bytes body(big);
    for (const glm::dvec3& p : expected.positions)
      body.add(float(p.x)).add(float(p.y)).add(float(p.z)).add(0.1).add<std::uint16_t>(2).add<short>(7).add<short>(8);
    for (std::size_t f = 0; f < 6; ++f) {
      body.add<std::uint8_t>(4);
      for (std::size_t k = 0; k < 4; ++k) body.add(std::int32_t(expected.corners[4 * f + k].position));
      body.add<std::uint8_t>(255);
    }
    const std::string format = big ? "binary_big_endian" : "binary_little_endian";
    const std::string head =
        header(format, "property double quality\nproperty list ushort short more\n", "property uchar red\n");
    for (const char* tail : {"", "\n", "\r\n"}) {
      const MeshData d = read_bytes("ply", head + body.text + tail).parts[0].mesh->data();
      EXPECT_EQ(d.positions, expected.positions);
      EXPECT_EQ(d.corners, expected.corners);
    }
    EXPECT_NE(error_of("ply", head + body.text + "x"), "");
    for (std::size_t cut = 1; cut < body.text.size(); ++cut)
      EXPECT_NE(error_of("ply", head + body.text.substr(0, body.text.size() - cut)), "") << cut;
  }
}

// A body that begins with a byte of a line end, behind each kind of line end.
TEST(ReadPly, TheBodyBeginsBehindTheHeader) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string head;
    for (char c : replaced(header("binary_little_endian"), "vertex 8", "vertex 3"))
      head += c == '\n' ? std::string(end) : std::string(1, c);
    const std::size_t at = head.find("face 6");
    head.replace(at, 6, "face 1");
    Bytes body(false);
    body.add<std::uint32_t>(0x0a0d0a0au);  // a small float
    for (int k = 1; k < 9; ++k) body.add(float(k));
    body.add<std::uint8_t>(3).add(0).add(1).add(2);
    EXPECT_EQ(face_count(read_bytes("ply", head + body.text)), 1u);
  }
}

TEST(ReadPly, FacesMayComeFirstAndOtherElementsBetween) {
  const Model model = read_bytes("ply",
                                 "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
                                 "element edge 2\nproperty int a\nproperty list int float b\nelement vertex 3\n"
                                 "property float x\nproperty float y\nproperty float z\nend_header\n"
                                 "3 0 1 2\n5 2 1 2\n6 0\n0 0 0\n1 0 0\n0 1 0\n");
  EXPECT_EQ(face_count(model), 1u);
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_EQ(model.notes[0].en, "2 'edge' were left out: only faces are drawn");
}

TEST(ReadPly, RefusedHeaders) {
  const std::string begin = "ply\nformat ascii 1.0\n";
  expect_refused("ply",
                 {{"", "test.ply:1: ", "does not begin with 'ply'"},
                  {"ply\n", "test.ply:1: ", "format is missing"},
                  {"OFF\n", "test.ply:1: ", "does not begin with 'ply'"},
                  {begin, "test.ply:2: ", "without end_header"},
                  {begin + "element", "test.ply:3: ", "element without a name"},
                  {begin + "element vertex", "test.ply:3: ", "the count of an element"},
                  {begin + "element vertex 8\nproperty", "test.ply:4: ", "property without a type"},
                  {begin + "element vertex 8\nproperty float", "test.ply:4: ", "property without a name"},
                  {begin + "property float x\n", "test.ply:3: ", "before any element"},
                  {begin + "property list uchar int vertex_indices\nend_header\n", "test.ply:3: ", "before any"},
                  {begin + "element vertex -1\n", "test.ply:3: ", "the count -1"},
                  {begin + "element vertex 1e3\n", "test.ply:3: ", "'1e3' is not a whole number"},
                  {begin + "element vertex 99999999999999999999\n", "test.ply:3: ", "too large"},
                  {begin + "element vertex 1\nelement vertex 2\n", "test.ply:4: ", "there twice"},
                  {begin + "element vertex 1\nproperty float x\nproperty float x\n", "test.ply:5: ", "there twice"},
                  {begin + "element vertex 1\nproperty real x\n", "test.ply:4: ", "'real' is not a type"},
                  {begin + "element face 1\nproperty list float int vertex_indices\n", "test.ply:4: ", "length"},
                  {begin + "what\n", "test.ply:3: ", "'what' is not a word"},
                  {"ply\nformat ebcdic 1.0\n", "test.ply:2: ", "'ebcdic 1.0'"},
                  {"ply\nformat ascii 2.0\n", "test.ply:2: ", "'ascii 2.0'"},
                  {begin + "element vertex 0\nend_header\n", "test.ply:1: ", "no face"}});
}

TEST(ReadPly, RefusedCounts) {
  const std::string body = corners + quads;
  const auto with = [&](const std::string& from, const std::string& to) { return replaced(header() + body, from, to); };
  expect_refused("ply", {{with("vertex 8", "vertex 4000000000"), "test.ply:3: ", "4000000000 'vertex' are announced"},
                         {with("vertex 8", "vertex 9223372036854775807"), "test.ply:3: ", "are announced"},
                         {with("vertex 8", "vertex 1000000"), "test.ply:3: ", "are announced"},
                         {with("face 6", "face 4000000000"), "test.ply:7: ", "4000000000 'face' are announced"},
                         {with("face 6", "face 7"), "test.ply:23: ", "the file ends after 6 of 7 'face'"},
                         {with("face 6", "face 5"), "test.ply:23: ", "more lines than the header announces"},
                         {with("vertex 8", "vertex 7"), "test.ply:17: ", "a list of length -1"},
                         {with("vertex 8", "vertex 9"), "test.ply:18: ", "'2' is more than"},
                         {replaced(header("binary_little_endian"), "face 6", "face 4000000000") + std::string(96, '\0'),
                          "test.ply:7: ", "are announced"}});
}

TEST(ReadPly, RefusedBodies) {
  const auto with = [&](const std::string& from, const std::string& to) {
    return replaced(header() + corners + quads, from, to);
  };
  expect_refused("ply", {{with("1 -1 -1", "nan -1 -1"), "test.ply:10: ", "'-nan' is not a finite number"},
                         {with("\n1 -1 -1", "\ninf -1 -1"), "test.ply:11: ", "'inf' is not a finite number"},
                         {with("\n1 -1 -1", "\nabc -1 -1"), "test.ply:11: ", "'abc' is not a number"},
                         {with("\n1 -1 -1", "\n1,5 -1 -1"), "test.ply:11: ", "comma"},
                         {with("\n1 -1 -1", "\n1 -1"), "test.ply:11: ", "a z coordinate"},
                         {with("\n1 -1 -1", "\n1 -1 -1 -1"), "test.ply:11: ", "more than this line"},
                         {with("4 0 3 2 1", "4 0 3 2"), "test.ply:18: ", "the line ends where a vertex index"},
                         {with("4 0 3 2 1", "3 0 3 2 1"), "test.ply:18: ", "more than this line"},
                         {with("4 0 3 2 1", "4 0 3 2 8"), "test.ply:18: ", "a face uses vertex 8, but there are 8"},
                         {with("4 0 3 2 1", "4 0 3 2 -1"), "test.ply:18: ", "a face uses vertex -1"},
                         {with("4 0 3 2 1", "4 0 3 2 1.5"), "test.ply:18: ", "not a whole number"},
                         {with("4 0 3 2 1", "-1 0 3 2 1"), "test.ply:18: ", "a list of length -1"},
                         {with("4 0 3 2 1", "4000000000 0 3 2 1"), "test.ply:18: ", "the line ends"},
                         {with("4 0 3 2 1", "2 0 3"), "test.ply:18: ", "a face with 2 corners"},
                         {with("uchar int vertex", "uchar float vertex"), "test.ply:7: ", "no list of vertex indices"},
                         {with("list uchar int", "int"), "test.ply:7: ", "no list of vertex indices"},
                         {with("property float z\n", ""), "test.ply:3: ", "no property 'z'"}});
  Bytes body(false);
  for (int k = 0; k < 23; ++k) body.add(float(k));
  const std::string start = header("binary_little_endian") + body.text;
  const std::string place = std::to_string(start.size());
  const std::string nan = Bytes(false).add(std::bit_cast<float>(0x7fc00000u)).text + std::string(200, '\0');
  expect_refused("ply", {{start + nan, "test.ply (byte " + place + "): ", "a z coordinate of 'vertex' number 7"},
                         {start + std::string(4, '\0') + "\3" + Bytes(false).add(0).add(1).add(12345678).text +
                              std::string(200, '\0'),
                          "test.ply (byte " + std::to_string(start.size() + 13) + "): ", "vertex 12345678"}});
}

}  // namespace
}  // namespace cg
