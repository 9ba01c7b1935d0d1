// Reads STL, as text and as bytes. Corners at exactly the same place become one vertex, so that normals can be
// averaged. The facets' own normals repeat what the order of the vertices says and are not used. Source: 3D Systems,
// "StereoLithography Interface Specification", 1988.
#include <algorithm>
#include <bit>
#include <cstring>

#include "scene/model_file.h"
#include "scene/model_parts.h"
#include "scene/text_scanner.h"

namespace cg {

namespace {

constexpr std::size_t header_bytes = 84, facet_bytes = 50;

// The positions of a mesh, each once: a hash table with open addressing.
class Welder {
 public:
  explicit Welder(std::vector<glm::dvec3>& positions) : positions_(positions) {}

  std::uint32_t index(glm::dvec3 p) {
    p += 0.0;  // -0 and 0 are the same place
    if (2 * positions_.size() >= table_.size()) grow();
    std::uint32_t& slot = find(p);
    if (slot == no_index) {
      slot = std::uint32_t(positions_.size());
      positions_.push_back(p);
    }
    return slot;
  }

 private:
  std::uint32_t& find(const glm::dvec3& p) {
    std::uint64_t hash = 0;
    for (int k = 0; k < 3; ++k) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(p[k])) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    std::size_t i = hash & (table_.size() - 1);
    while (table_[i] != no_index && positions_[table_[i]] != p) i = (i + 1) & (table_.size() - 1);
    return table_[i];
  }

  void grow() {
    table_.assign(std::max<std::size_t>(64, 4 * table_.size()), no_index);
    for (std::uint32_t i = 0; i < positions_.size(); ++i) find(positions_[i]) = i;
  }

  std::vector<glm::dvec3>& positions_;
  std::vector<std::uint32_t> table_;  // a power of two of indices into positions_
};

void add_triangle(MeshData& mesh, Welder& weld, const glm::dvec3 (&p)[3]) {
  Corner corners[3];
  for (int k = 0; k < 3; ++k) corners[k].position = weld.index(p[k]);
  mesh.add_face(corners, corners + 3);
}

// Little-endian, whatever the machine is.
std::uint32_t load32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value |= std::uint32_t(std::uint8_t(bytes[at + k])) << (8 * k);
  return value;
}

Model read_binary(std::string_view bytes, const std::string& where) {
  const auto fail = [&](std::size_t at, Text found, Text accepted) {
    throw InputError(where, std::move(found), std::move(accepted), 0, static_cast<long long>(at));
  };
  if (bytes.size() < header_bytes)
    fail(bytes.size(), phrase({"a file of {0} bytes", "{0} バイトのファイル"}, {text_of(bytes.size())}),
         {"a binary STL file has at least 84, one of text begins with solid",
          "バイナリの STL は 84 バイト以上、テキストの STL は solid で始まる"});
  const std::uint64_t n = load32(bytes, 80), there = (bytes.size() - header_bytes) / facet_bytes;
  const std::size_t behind = (bytes.size() - header_bytes) % facet_bytes;
  if (n != there)
    fail(80,
         phrase({"{0} triangles are announced, but the file has the bytes of {1}",
                 "三角形が{0}個とあるが、ファイルには{1}個分のバイトがある"},
                {text_of(n), text_of(there)}),
         {"the file may be cut off or not be STL", "ファイルが途中で切れているか、STL でない可能性がある"});
  if (n == 0)
    fail(80, {"the file has no triangle", "三角形がない"}, {"a model needs at least one", "少なくとも 1 つ必要"});
  MeshData mesh;
  mesh.corners.reserve(3 * n);
  mesh.first_corner.reserve(n + 1);
  Welder weld(mesh.positions);
  for (std::uint64_t i = 0; i < n; ++i) {
    const std::size_t facet = header_bytes + facet_bytes * i;
    glm::dvec3 p[3];
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t at = facet + 12 + 4 * k;
      const double value = std::bit_cast<float>(load32(bytes, at));
      if (value - value != 0)
        fail(at,
             phrase({"triangle {0} has a coordinate that is not finite", "{0}番目の三角形の座標が有限の数ではない"},
                    {text_of(i)}),
             {"finite numbers are expected", "有限の数が必要"});
      p[k / 3][int(k % 3)] = value;
    }
    add_triangle(mesh, weld, p);
  }
  Model model = single_part(std::move(mesh));
  if (behind > 0)
    model.notes.push_back(
        phrase({"{0} bytes behind the last triangle were left out", "最後の三角形の後の {0} バイトを省いた"},
               {text_of(behind)}));
  return model;
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }
bool is_word(std::string_view found, std::string_view lower_case) {
  return std::ranges::equal(found, lower_case, {}, lower);
}

class StlTextReader {
 public:
  StlTextReader(std::string_view bytes, const std::string& where) : in_(bytes, where, {}) {}

  Model read() {
    Model model;
    std::string name;
    while (in_.next_line()) {
      expect({"solid"});
      name = in_.rest();
      if (MeshData mesh = solid(); mesh.face_count() > 0)
        model.parts.push_back({.name = name, .mesh = Mesh::make(std::move(mesh)), .material = std::nullopt});
    }
    if (model.parts.empty())
      in_.fail({"the file has no facet", "facet がない"}, {"a model needs at least one", "少なくとも 1 つ必要"});
    make_names_unique(model.parts);
    return model;
  }

 private:
  // The facets up to endsolid.
  MeshData solid() {
    MeshData mesh;
    Welder weld(mesh.positions);
    for (;;) {
      next_line();
      if (is_word(in_.peek(), "endsolid")) return mesh;
      facet(mesh, weld);
    }
  }

  void facet(MeshData& mesh, Welder& weld) {
    expect({"facet", "normal"});
    for (int k = 0; k < 3; ++k)
      if (in_.word().empty())
        in_.fail({"a normal with fewer than three numbers", "法線の数が 3 つない"},
                 {"facet normal x y z", "facet normal x y z と書く"});
    line_end();
    next_line(), expect({"outer", "loop"}), line_end();
    glm::dvec3 p[3];
    for (glm::dvec3& vertex : p) {
      next_line(), expect({"vertex"});
      vertex.x = in_.number({"an x coordinate", "x 座標"});
      vertex.y = in_.number({"a y coordinate", "y 座標"});
      vertex.z = in_.number({"a z coordinate", "z 座標"});
      line_end();
    }
    next_line(), expect({"endloop"}), line_end();
    next_line(), expect({"endfacet"}), line_end();
    add_triangle(mesh, weld, p);
  }

  void next_line() {
    if (!in_.next_line())
      in_.fail({"the file ends before endsolid", "endsolid の前にファイルが終わっている"},
               {"the file may be cut off: get it again", "ファイルが途中で切れている可能性がある"});
  }

  void line_end() { in_.expect_end({"one statement a line", "1 行に 1 つの命令"}); }

  void expect(std::initializer_list<std::string_view> words) {
    for (std::string_view word : words)
      if (const std::string_view found = in_.word(); !is_word(found, word))
        in_.fail(phrase({"{0} stands where {1} is expected", "{1}のはずが{0}になっている"},
                        {in_quotes(found), in_quotes(word)}),
                 {"a facet is three vertex lines between 'outer loop' and 'endloop'",
                  "facet は outer loop と endloop の間の 3 つの vertex"});
  }

  TextScanner in_;
};

// Many programs begin binary files with "solid" too. Such a file has the size that its count says, or bytes that no
// text has.
bool is_text(std::string_view bytes) {
  if (bytes.size() >= header_bytes && bytes.size() - header_bytes == facet_bytes * std::uint64_t(load32(bytes, 80)))
    return false;
  const std::size_t begin = bytes.starts_with("\xef\xbb\xbf") ? 3 : 0;
  const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n\v\f", begin), bytes.size());
  if (!is_word(bytes.substr(first, 5), "solid")) return false;
  return bytes.substr(0, 512).find('\0') == bytes.npos;
}

}  // namespace

Model read_stl(std::string_view bytes, const std::string& where) {
  return is_text(bytes) ? StlTextReader(bytes, where).read() : read_binary(bytes, where);
}

}  // namespace cg
