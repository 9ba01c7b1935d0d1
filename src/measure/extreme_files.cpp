// Files that other readers abort, hang or lie about: each is read as it says, or refused with its line or byte.
#include <cmath>

#include "measure/extreme_tables.h"
#include "params/input_error.h"
#include "scene/model_file.h"

namespace cg {

namespace {

using Read = Model (*)(const std::string&);

Model obj(const std::string& text) { return read_obj(text, "a.obj", {}); }
Model ply(const std::string& text) { return read_ply(text, "a.ply"); }
Model off(const std::string& text) { return read_off(text, "a.off"); }
Model stl(const std::string& text) { return read_stl(text, "a.stl"); }

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

// The text as it can be shown: its beginning.
std::string shown(const std::string& text) {
  std::string out;
  for (const char c : text.substr(0, 240)) out += (c == '\n' || (c >= ' ' && c < 127)) ? c : '?';
  return text.size() > 240 ? out + "..." : out;
}

Text message_of(const InputError& e) { return {e.message(Language::english), e.message(Language::japanese)}; }

ExtremeCase file_case(std::string id, Words name, std::string kind, std::string value, Text right, std::string text,
                      std::function<ExtremeError()> take) {
  ExtremeCase c;
  c.id = "file-" + std::move(id), c.group = "files", c.name = name;
  c.parameter = std::move(kind), c.value = std::move(value), c.right = std::move(right);
  c.input = ExtremeInput{shown(text), std::move(take)};
  return c;
}

// An error that names the line (> 0), or some byte (0), in one line of both languages.
ExtremeError refusal(Read read, const std::string& text, long line) {
  try {
    read(text);
    return {1, Words{"it was read, without an error", "エラーにならず読み込まれた"}};
  } catch (const InputError& e) {
    const Text said = message_of(e);
    const bool placed = line > 0 ? e.line == line : e.line > 0 || e.byte >= 0;
    const bool one_line = said.en.find('\n') == said.en.npos && said.ja.find('\n') == said.ja.npos;
    return {placed && one_line ? 0.0 : 1.0, said};
  }
}

ExtremeCase refused(std::string id, Words name, std::string kind, std::string value, Read read, std::string text,
                    long line) {
  const std::string at = std::to_string(line);
  Text right = line > 0 ? Text{"An error that names line " + at + "; nothing is dropped or shifted.",
                               at + " 行目を示すエラー。何も落とさず、番号もずらさない。"}
                        : Text{"An error that names the line or byte; no memory for what is not there.",
                               "行かバイトを示すエラー。実際にない分のメモリーは確保しない。"};
  return file_case(std::move(id), name, std::move(kind), std::move(value), std::move(right), text,
                   [=] { return refusal(read, text, line); });
}

// The sum of the areas of a model's triangles, which is larger than the face's own where one covers another.
double area_of(const Model& model) {
  double area = 0;
  for (const ModelPart& part : model.parts)
    for (const Triangle& t : part.mesh->triangles()) {
      const MeshData& d = part.mesh->data();
      const auto p = [&](int i) { return d.positions[d.corners[t.corner[std::size_t(i)]].position]; };
      area += glm::length(glm::cross(p(1) - p(0), p(2) - p(0))) / 2;
    }
  return area;
}

std::size_t faces_of(const Model& model) {
  std::size_t n = 0;
  for (const ModelPart& part : model.parts) n += part.mesh->data().face_count();
  return n;
}

// Read, with so many faces and triangles of that area (less than 0: not asked).
ExtremeCase read_as(std::string id, Words name, std::string kind, std::string value, Text right, Read read,
                    std::string text, std::size_t faces, double area) {
  return file_case(
      std::move(id), name, std::move(kind), std::move(value), std::move(right), text, [=]() -> ExtremeError {
        try {
          const Model model = read(text);
          const std::string n = std::to_string(faces_of(model));
          const bool same = faces_of(model) == faces && (area < 0 || std::abs(area_of(model) - area) <= 1e-9 * area);
          return {same ? 0.0 : 1.0, {n + " faces", n + " 面"}};
        } catch (const InputError& e) {
          return {1, message_of(e)};
        }
      });
}

std::string ply_head(const std::string& vertices, const std::string& faces) {
  return "ply\nformat ascii 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

void add_obj(ExtremeTable& all) {
  const std::string t = triangle, face = "f 1 2 3\n";
  const auto add = [&](std::string id, Words name, std::string value, std::string text, long line) {
    all.push_back(refused("obj-" + std::move(id), name, "OBJ file", std::move(value), obj, std::move(text), line));
  };
  const Words number{"A coordinate that is no number", "数でない座標"},
      index{"An index that is not there", "存在しない番号"};
  add("nan", number, "v nan 0 0", "v nan 0 0\n" + t + face, 1);
  add("inf", number, "v 0 inf 0", "v 0 0 0\nv 0 inf 0\n" + t + face, 2);
  add("1e400", {"A number beyond double", "double を超える数"}, "v 1e400 0 0", t + "v 1e400 0 0\n" + face, 4);
  add("two-coordinates", {"A vertex of two coordinates", "座標が二つだけの頂点"}, "v 0 0", t + "v 0 0\n" + face, 4);
  add("decimal-comma", {"A decimal comma", "小数点がコンマ"}, "v -1,5 0 0", "v -1,5 0 0\n" + t + face, 1);
  add("index-too-large", index, "f 1/1 2/2 99999999/3", t + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 99999999/3\n", 7);
  add("index-0", index, "f 0 1 2", t + "f 0 1 2\n", 4);
  add("index-negative", index, "f 1//1 2//1 -50000000//1", t + "vn 0 0 1\nf 1//1 2//1 -50000000//1\n", 5);
  add("index-empty", {"A face that begins with a slash", "スラッシュで始まる面"}, "f //1 //1 //1",
      t + "vn 0 0 1\nf //1 //1 //1\n", 5);
  add("empty", {"An empty file", "空のファイル"}, "0 bytes", "", 0);
  add("jpeg", {"A JPEG that is called .obj", ".obj という名前の JPEG"}, "ff d8 ff e0",
      "\xff\xd8\xff\xe0\x10JFIF\x01\x01", 0);
  const Text same = Words{"The same triangle.", "同じ三角形になる。"};
  const auto taken = [&](std::string id, Words name, std::string value, Text right, std::string text, std::size_t faces,
                         double area) {
    all.push_back(read_as("obj-" + std::move(id), name, "OBJ file", std::move(value), std::move(right), obj,
                          std::move(text), faces, area));
  };
  taken("carriage-returns", {"Lines that end in a carriage return", "CR だけの改行"}, "\\r", same,
        "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", 1, 0.5);
  taken("byte-order-mark", {"A byte order mark", "バイト順マーク"}, "ef bb bf", same, "\xef\xbb\xbf" + t + face, 1,
        0.5);
  taken("concave", {"A concave quadrilateral", "凹んだ四角形"}, "f 1 2 3 4",
        Words{"Its triangles have the face's own area, 0.4: none covers another.",
              "三角形の面積の和は面と同じ 0.4。重なりはない。"},
        "v 0 -1 0\nv 1 0 0\nv 0 1 0\nv 0.6 0 0\nf 1 2 3 4\n", 1, 0.4);
  taken("1e20", {"Coordinates of 1e20", "1e20 の座標"}, "v 1e20 0 0",
        Words{"Kept in double: the face has an area of 5e39.", "double で保たれ、面積は 5e39。"},
        "v 0 0 0\nv 1e20 0 0\nv 0 1e20 0\nf 1 2 3\n", 1, 5e39);
}

void add_polygon(ExtremeTable& all) {
  constexpr int corners = 100000;
  std::string text, face = "f";
  for (int i = 0; i < corners; ++i) {
    const double a = 2 * 3.14159265358979323846 * i / corners;
    text += "v " + std::to_string(std::cos(a)) + " " + std::to_string(std::sin(a)) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  text += face + "\n";
  all.push_back(read_as("obj-100000-gon", {"A face of 100 000 corners", "100 000 角形"}, "OBJ file", "f 1 2 … 100000",
                        Words{"One face, and in well under the time of a quadratic search.",
                              "一つの面として、二乗の時間をかけずに読む。"},
                        obj, text, 1, -1));
}

void add_others(ExtremeTable& all) {
  const auto add = [&](std::string id, Words name, std::string kind, std::string value, Read read, std::string text,
                       long line = 0) {
    all.push_back(refused(std::move(id), name, std::move(kind), std::move(value), read, std::move(text), line));
  };
  const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
  add("ply-no-end", {"A header without an end", "終わりのないヘッダ"}, "PLY file", "no end_header", ply,
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n");
  add("ply-property-first", {"A property of no element", "要素のないプロパティ"}, "PLY file", "property float x", ply,
      "ply\nformat ascii 1.0\nproperty float x\nend_header\n");
  for (const char* count : {"4000000000", "-1"})
    add(std::string("ply-count") + (count[0] == '-' ? "-negative" : "-4e9"), {"A count that lies", "嘘の個数"},
        "PLY file", std::string("element vertex ") + count, ply, ply_head(count, "1") + three + "3 0 1 2\n");
  add("ply-nan", {"A coordinate that is no number", "数でない座標"}, "PLY file", "nan", ply,
      ply_head("3", "1") + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", 11);
  add("ply-face-size", {"A face of -1 corners", "-1 角形"}, "PLY file", "-1 0 1 2", ply,
      ply_head("3", "1") + three + "-1 0 1 2\n");
  add("off-counts", {"A count that lies", "嘘の個数"}, "OFF file", "4000000000 1 0", off,
      "OFF\n4000000000 1 0\n" + three + "3 0 1 2\n");
  add("off-index", {"An index that is not there", "存在しない番号"}, "OFF file", "3 0 1 7", off,
      "OFF\n3 1 0\n" + three + "3 0 1 7\n", 6);
  std::string binary(80, ' ');
  binary += std::string("\xff\xff\xff\xff", 4) + std::string(50, '\0');
  add("stl-count", {"A count that lies", "嘘の個数"}, "STL file", "4294967295 triangles, 50 bytes", stl, binary);
  add("stl-cut", {"A file that ends early", "途中で終わるファイル"}, "STL file", "no endsolid", stl,
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n");
}

}  // namespace

void add_file_extremes(ExtremeTable& all) {
  add_obj(all);
  add_polygon(all);
  add_others(all);
}

}  // namespace cg
