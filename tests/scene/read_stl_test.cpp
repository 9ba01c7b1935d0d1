#include <cstring>
#include <limits>

#include "tests/scene/reading.h"

namespace cg {
namespace {

std::string little(std::uint32_t n) {
  std::string out;
  for (int k = 0; k < 4; ++k) out += char(n >> (8 * k) & 0xff);
  return out;
}

// The facets of a tetrahedron, each vertex written three times.
const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -0.0f, 0.1f}};
const int sides[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

std::string facet(int side) {
  std::string out;
  const auto add = [&](float v) { out.append(reinterpret_cast<const char*>(&v), 4); };
  for (int k = 0; k < 3; ++k) add(0);
  for (int c : sides[side])
    for (float v : corners[c]) add(v);
  return out + std::string(2, '\0');
}

std::string binary(std::uint32_t announced = 4, std::string head = "made by a test") {
  head.resize(80, ' ');
  return head + little(announced) + facet(0) + facet(1) + facet(2) + facet(3);
}

std::string text(const std::string& name = "a b") {
  std::string out = "solid " + name + "\n";
  for (const auto& side : sides) {
    out += "  facet normal 0 0 1\n    outer loop\n";
    for (int c : side)
      out += "      vertex " + std::to_string(corners[c][0]) + " " + std::to_string(corners[c][1]) + " " +
             (c == 3 ? "0.1" : "0e0") + "\n";
    out += "    endloop\n  endfacet\n";
  }
  return out + "endsolid " + name + "\n";
}

TEST(ReadStl, EqualCornersAreOneVertex) {
  for (const std::string& bytes : {binary(), binary(4, "solid exported as binary"), text(), text("")}) {
    const Model model = read_bytes("stl", bytes);
    ASSERT_EQ(model.parts.size(), 1u);
    EXPECT_TRUE(model.notes.empty());
    const MeshData& d = model.parts[0].mesh->data();
    ASSERT_EQ(d.positions.size(), 4u);
    EXPECT_EQ(d.face_count(), 4u);
    EXPECT_EQ(positions_of_face(*model.parts[0].mesh, 1)[1], glm::dvec3(1, 0, 0));
    EXPECT_EQ(d.corners[0].position, d.corners[3].position);
  }
  EXPECT_EQ(read_bytes("stl", text()).parts[0].name, "a b");
  EXPECT_EQ(read_bytes("stl", binary()).parts[0].mesh->data().positions[3], glm::dvec3(0, 0, double(0.1f)));
  EXPECT_EQ(read_bytes("stl", text()).parts[0].mesh->data().positions[3], glm::dvec3(0, 0, 0.1));
}

TEST(ReadStl, ManyVerticesAreWeldedExactly) {
  std::string all(80, ' ');
  const std::uint32_t n = 20000;
  all += little(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    float v[12] = {0, 0, 0, float(i), 0, 0, float(i + 1), 0, 0, float(i), 1, 0};
    all.append(reinterpret_cast<const char*>(v), 48) += std::string(2, '\0');
  }
  const MeshData d = read_bytes("stl", all).parts[0].mesh->data();
  EXPECT_EQ(d.face_count(), n);
  EXPECT_EQ(d.positions.size(), 2 * n + 1);
  for (std::uint32_t c = 0; c < 3 * n; ++c)
    ASSERT_EQ(d.positions[d.corners[c].position], glm::dvec3(c / 3 + (c % 3 == 1), c % 3 == 2, 0));
}

TEST(ReadStl, SeveralSolidsAndOddForms) {
  const Model two = read_bytes("stl", text("a") + "solid empty\nendsolid\n" + text("a"));
  ASSERT_EQ(two.parts.size(), 2u);
  EXPECT_EQ(two.parts[0].name, "a");
  EXPECT_EQ(two.parts[1].name, "a 2");
  std::string upper = text();
  for (char& c : upper) c = char(std::toupper(c));
  EXPECT_EQ(face_count(read_bytes("stl", upper)), 4u);
  std::string cr = text();
  for (char& c : cr) c = c == '\n' ? '\r' : c;
  EXPECT_EQ(face_count(read_bytes("stl", cr)), 4u);
}

TEST(ReadStl, Refused) {
  const auto without = [](const std::string& line) {
    std::string all = text();
    return all.erase(all.find(line), line.size());
  };
  const auto put = [](float v) {
    std::string all = binary();
    std::memcpy(all.data() + 84 + 50 + 12 + 16, &v, 4);
    return all;
  };
  const std::string place = "test.stl (byte " + std::to_string(84 + 50 + 12 + 16) + "): ";
  expect_refused(
      "stl", {{"", "test.stl (byte 0): ", "0 bytes"},
              {std::string(80, 'x'), "test.stl (byte 80): ", "80 bytes"},
              {std::string(80, 'x') + little(0), "test.stl (byte 80): ", "no triangle"},
              {binary(0), "test.stl (byte 80): ", "0 triangles are announced"},
              {binary(3), "test.stl (byte 80): ", "3 triangles are announced, but the file has the bytes of 4"},
              {binary(1000000), "test.stl (byte 80): ", "1000000 triangles"},
              {binary(0xffffffffu), "test.stl (byte 80): ", "4294967295 triangles"},
              {binary().substr(0, 270), "test.stl (byte 80): ", "the bytes of 3"},
              {put(std::numeric_limits<float>::quiet_NaN()), place, "triangle 1 has a coordinate that is not finite"},
              {put(-std::numeric_limits<float>::infinity()), place, "not finite"},
              {"solid a\nendsolid a\n", "test.stl:2: ", "no facet"},
              {"solid a\n", "test.stl:1: ", "ends before endsolid"},
              {text().substr(0, 50), "test.stl:", ""},
              {without("endsolid a b\n"), "test.stl:29: ", "ends before endsolid"},
              {without("    outer loop\n"), "test.stl:3: ", "'vertex' stands where 'outer' is expected"},
              {without("      vertex 0.000000 0.000000 0e0\n"), "test.stl:6: ", "'endloop' stands where 'vertex'"},
              {without("    endloop\n"), "test.stl:7: ", "'endfacet' stands where 'endloop'"},
              {without("  endfacet\n"), "test.stl:8: ", "'facet' stands where 'endfacet'"},
              {without(" 0 1"), "test.stl:2: ", "fewer than three"},
              {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 nan 0\n", "test.stl:4: ", "'nan' is not a finite"},
              {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", "test.stl:4: ", "z coordinate"},
              {text() + "facet\n", "test.stl:31: ", "'facet' stands where 'solid'"}});
}

}  // namespace
}  // namespace cg
