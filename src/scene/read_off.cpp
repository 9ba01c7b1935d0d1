// Reads OFF as text: OFF, and NOFF, COFF, STOFF and their combinations (normals, colours, uv of the vertices).
// Source: Geomview Manual, "OFF Files", The Geometry Center, University of Minnesota.
#include "scene/model_file.h"
#include "scene/model_parts.h"
#include "scene/text_scanner.h"

namespace cg {

namespace {

class OffReader {
 public:
  OffReader(std::string_view bytes, const std::string& where)
      : in_(bytes, where, {.comment = '#'}), size_(bytes.size()) {}

  Model read() {
    keyword();
    counts();
    for (std::int64_t i = 0; i < vertices_; ++i) vertex(i);
    for (std::int64_t i = 0; i < faces_; ++i) face(i);
    if (in_.next_line())
      in_.fail({"more lines than the counts announce", "個数より多くの行がある"},
               {"as many vertices and faces as the counts say", "頂点と面は最初に書いた個数だけ"});
    Model model = single_part(std::move(mesh_));
    if (colours_)
      model.notes.push_back(
          phrase({"the colours of {0} vertices are not used", "頂点{0}個の色は使われない"}, {text_of(vertices_)}));
    return model;
  }

 private:
  // [ST][C][N]OFF; a count may follow without a space, as in many files of ModelNet.
  void keyword() {
    const Text accepted{"OFF, NOFF, COFF, STOFF or a combination, as text",
                        "OFF, NOFF, COFF, STOFF またはその組み合わせ（テキスト）が必要"};
    if (!in_.next_line()) in_.fail({"the file is empty", "ファイルが空"}, accepted);
    const std::string_view word = in_.word();
    std::string_view left = word;
    const auto take = [&](std::string_view prefix) {
      const bool found = left.starts_with(prefix);
      if (found) left.remove_prefix(prefix.size());
      return found;
    };
    uvs_ = take("ST");
    colours_ = take("C");
    normals_ = take("N");
    if (left.starts_with("4OFF") || left.starts_with("nOFF") || left.starts_with("4nOFF"))
      in_.fail(
          phrase({"{0} has vertices of other than three dimensions", "{0}の頂点は 3 次元でない"}, {in_quotes(word)}),
          accepted);
    if (!take("OFF"))
      in_.fail(phrase({"the file begins with {0}", "ファイルが{0}で始まっている"}, {in_quotes(word)}), accepted);
    if (in_.peek() == "BINARY") in_.fail({"a binary OFF file", "バイナリの OFF ファイル"}, accepted);
    if (!left.empty())
      in_.rewind(left);
    else if (in_.at_end() && !in_.next_line())
      in_.fail({"the file ends before the counts", "個数の前にファイルが終わっている"},
               {"'8 6 12': vertices, faces, edges", "8 6 12 のように頂点、面、辺の数を書く"});
  }

  void counts() {
    vertices_ = in_.integer({"the number of vertices", "頂点の数"});
    faces_ = in_.integer({"the number of faces", "面の数"});
    if (!in_.at_end()) in_.integer({"the number of edges", "辺の数"});
    const Text accepted{"'8 6 12': vertices, faces, edges", "8 6 12 のように頂点、面、辺の数を書く"};
    in_.expect_end(accepted);
    if (vertices_ < 0 || faces_ < 0) in_.fail({"a count below 0", "個数が負"}, accepted);
    if (faces_ == 0)
      in_.fail({"the file has no face", "面がない"}, {"a model needs at least one", "面が少なくとも 1 つ必要"});
    // "0 0 0\\n" and "3 0 0 0\\n" are the shortest lines.
    const auto bytes = std::int64_t(size_);
    if (vertices_ > bytes / 6 + 1 || faces_ > bytes / 8 + 1)
      in_.fail(phrase({"{0} vertices and {1} faces are announced, but the file has only {2} bytes",
                       "頂点{0}個と面{1}個とあるが、ファイルは {2} バイトしかない"},
                      {text_of(vertices_), text_of(faces_), text_of(bytes)}),
               {"the file may be cut off: get it again", "ファイルが途中で切れている可能性がある"});
    mesh_.positions.reserve(std::size_t(vertices_));
    mesh_.first_corner.reserve(std::size_t(faces_) + 1);
  }

  void line_of(const Words& what, std::int64_t i, std::int64_t n) {
    if (!in_.next_line())
      in_.fail(phrase({"the file ends after {0} of {1} {2}", "{2}{1}個のうち{0}個で終わっている"},
                      {text_of(i), text_of(n), what}),
               {"the file may be cut off: get it again", "ファイルが途中で切れている可能性がある"});
  }

  // x y z [nx ny nz] [r g b [a]] [s t]
  void vertex(std::int64_t i) {
    line_of({"vertices", "頂点"}, i, vertices_);
    mesh_.positions.push_back(triple({"a coordinate", "座標"}));
    if (normals_) mesh_.normals.push_back(triple({"a number of a normal", "法線の数"}));
    if (colours_) colour(uvs_ ? 2 : 0);
    if (uvs_) {
      const double s = in_.number({"a texture coordinate s", "テクスチャ座標 s"});
      mesh_.uvs.emplace_back(s, in_.number({"a texture coordinate t", "テクスチャ座標 t"}));
    }
    in_.expect_end({"one vertex a line: x y z; normals need NOFF, colours COFF",
                    "1 行に 1 頂点 x y z。法線は NOFF、色は COFF と書く"});
  }

  glm::dvec3 triple(const Words& what) {
    glm::dvec3 v;
    for (int k = 0; k < 3; ++k) v[k] = in_.number(what);
    return v;
  }

  // r g b or r g b a, with `behind` more numbers on the line.
  void colour(int behind) {
    triple({"a colour r g b", "色 r g b"});
    if (in_.words_left() > behind) in_.number({"an opacity", "不透明度"});
  }

  // n, n indices, then nothing or a colour: an index into a colour map, r g b or r g b a.
  void face(std::int64_t i) {
    line_of({"faces", "面"}, i, faces_);
    const std::int64_t n = in_.integer({"the number of corners", "角の数"});
    if (n < 3)
      in_.fail(phrase({"a face with {0} corners", "角が{0}個の面"}, {text_of(n)}),
               {"a face has at least three", "面の角は 3 個以上"});
    for (std::int64_t k = 0; k < n; ++k) {
      const std::int64_t index = in_.integer({"a vertex index", "頂点番号"});
      if (index < 0 || index >= vertices_)
        in_.fail(phrase({"a face uses vertex {0}, but there are {1}", "面が頂点{0}を使うが、頂点は{1}個"},
                        {text_of(index), text_of(vertices_)}),
                 {"vertices count from 0", "頂点の番号は 0 から"});
      const auto at = std::uint32_t(index);
      mesh_.corners.push_back({at, normals_ ? at : no_index, uvs_ ? at : no_index});
    }
    mesh_.first_corner.push_back(std::uint32_t(mesh_.corners.size()));
    const int more = in_.words_left();
    if (more == 2 || more > 4)
      in_.fail(phrase({"{0} values behind the indices of a face", "面の番号の後に値が{0}個ある"}, {text_of(more)}),
               {"a colour of 1, 3 or 4 values, or none", "色なら値は 1, 3, 4 個、またはなし"});
    for (int k = 0; k < more; ++k) in_.number({"a colour", "色"});
  }

  TextScanner in_;
  std::size_t size_;
  bool normals_ = false, colours_ = false, uvs_ = false;
  std::int64_t vertices_ = 0, faces_ = 0;
  MeshData mesh_;
};

}  // namespace

Model read_off(std::string_view bytes, const std::string& where) { return OffReader(bytes, where).read(); }

}  // namespace cg
