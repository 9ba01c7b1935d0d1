// Reads Wavefront OBJ: polygons with per-corner uv and normals, split into parts by object and material.
// Source: Alias|Wavefront, "Object Files (.obj)", Advanced Visualizer Manual, appendix B1.
#include <algorithm>
#include <array>
#include <set>
#include <unordered_map>

#include "scene/model_file.h"
#include "scene/model_parts.h"
#include "scene/text_scanner.h"

namespace cg {

namespace {

constexpr std::size_t max_parts = 10'000, max_material_files = 64;

// Statements that change nothing of what is drawn, and such that draw something that is not a polygon of this file.
constexpr std::string_view ignored[] = {"s",         "mg",    "lod",   "bevel",  "c_interp", "d_interp", "shadow_obj",
                                        "trace_obj", "ctech", "stech", "usemap", "maplib",   "vp",       "cstype",
                                        "deg",       "bmat",  "step",  "parm",   "trim",     "hole",     "scrv",
                                        "sp",        "end",   "con",   "csh"};
constexpr std::string_view not_polygons[] = {"p",   "l",   "curv", "curv2", "surf", "bsp",
                                             "bzp", "cdc", "cdp",  "res",   "call"};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const std::string& where, const MtlLoader& load_mtl)
      : in_(bytes, where, {.comment = '#', .joins_lines = true}), size_(bytes.size()), load_mtl_(load_mtl) {}

  Model read() {
    while (in_.next_line()) statement(in_.word());
    check_forward_indices();
    if (parts_.empty())
      in_.fail(phrase({"the file has no face ({0} vertices)", "面がない（頂点は{0}個）"},
                      {text_of(lists_.positions.size())}),
               {"a model needs at least one line that begins with f", "f で始まる行が少なくとも 1 つ必要"});
    Model model;
    add_notes();
    model.notes = std::move(notes_);
    model.parts = make_parts(std::move(lists_), std::move(parts_), materials_);
    return model;
  }

 private:
  void statement(std::string_view key) {
    if (key == "v") return vertex();
    if (key == "f" || key == "fo") return face();  // fo is the older name
    if (key == "vn") return normal();
    if (key == "vt") return uv();
    if (key == "o" || key == "g") return object(key == "o");
    if (key == "usemtl") return use_material();
    if (key == "mtllib") return material_file();
    if (std::ranges::find(ignored, key) != std::end(ignored)) return;
    if (std::ranges::find(not_polygons, key) != std::end(not_polygons)) {
      if (left_out_++ == 0) first_left_out_ = in_.line();
      return;
    }
    in_.fail(phrase({"{0} is not a statement of OBJ", "{0}は OBJ の命令ではない"}, {in_quotes(key)}),
             {"lines begin with v, vt, vn, f, o, g, s, usemtl, mtllib or #",
              "行頭に書けるのは v, vt, vn, f, o, g, s, usemtl, mtllib, # など"});
  }

  // v x y z, then nothing, a weight w (of curves: not used), or a colour (not used).
  void vertex() {
    glm::dvec3 p;
    p.x = in_.number({"an x coordinate", "x 座標"});
    p.y = in_.number({"a y coordinate", "y 座標"});
    p.z = in_.number({"a z coordinate", "z 座標"});
    lists_.positions.push_back(p);
    if (in_.at_end()) return;
    int more = 0;
    for (; !in_.at_end() && more < 5; ++more) in_.number({"a colour or a weight", "色または重み"});
    if (more == 2 || more > 4)
      in_.fail(
          phrase({"a vertex with {0} numbers", "頂点に数が{0}個ある"}, {text_of(3 + more)}),
          {"x y z, with a weight or a colour (r g b, r g b a) behind it", "x y z の後には重みか色（r g b, r g b a）"});
    if (more >= 3) ++coloured_;
  }

  void normal() {
    glm::dvec3 n;
    n.x = in_.number({"the x of a normal", "法線の x"});
    n.y = in_.number({"the y of a normal", "法線の y"});
    n.z = in_.number({"the z of a normal", "法線の z"});
    in_.expect_end({"a normal has three numbers", "法線の数は 3 つ"});
    lists_.normals.push_back(n);
  }

  // vt u [v [w]]: the third is of solid textures and not used.
  void uv() {
    glm::dvec2 t{in_.number({"a texture coordinate u", "テクスチャ座標 u"}), 0};
    if (!in_.at_end()) t.y = in_.number({"a texture coordinate v", "テクスチャ座標 v"});
    if (!in_.at_end()) in_.number({"a texture coordinate w", "テクスチャ座標 w"});
    in_.expect_end({"a texture coordinate has one to three numbers", "テクスチャ座標の数は 1 つから 3 つ"});
    lists_.uvs.push_back(t);
  }

  void face() {
    MeshData& faces = part().faces;
    const std::size_t begin = faces.corners.size();
    for (std::string_view text = in_.word(); !text.empty(); text = in_.word()) faces.corners.push_back(corner(text));
    const std::size_t n = faces.corners.size() - begin;
    if (n < 3)
      in_.fail(phrase({"a face with {0} corners", "角が{0}個の面"}, {text_of(n)}),
               {"a face has at least three", "面の角は 3 個以上"});
    faces.first_corner.push_back(std::uint32_t(faces.corners.size()));
  }

  // v, v/vt, v//vn or v/vt/vn.
  Corner corner(std::string_view text) {
    Corner out;
    const std::array<std::uint32_t*, 3> values{&out.position, &out.uv, &out.normal};
    const char *p = text.data(), *end = p + text.size();
    for (int kind = 0; kind < 3; ++kind) {
      if (p < end && *p != '/')
        *values[kind] = index(p, end, kind, text);
      else if (kind == 0)
        bad_corner(text);
      if (p == end) return out;
      if (*p++ != '/') bad_corner(text);
    }
    bad_corner(text);
  }

  [[noreturn]] void bad_corner(std::string_view text) const {
    in_.fail(phrase({"{0} is not the corner of a face", "{0}は面の角ではない"}, {in_quotes(text)}),
             {"a corner is v, v/vt, v//vn or v/vt/vn", "角は v, v/vt, v//vn, v/vt/vn のどれか"});
  }

  std::size_t count(int kind) const {
    return kind == 0 ? lists_.positions.size() : kind == 1 ? lists_.uvs.size() : lists_.normals.size();
  }

  // The 0-based index that is written at p, which moves behind it. Positive ones may point to what comes later.
  std::uint32_t index(const char*& p, const char* end, int kind, std::string_view corner_text) {
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(p, end, value);
    if (error == std::errc::invalid_argument) bad_corner(corner_text);
    p = stop;
    const auto n = std::int64_t(count(kind));
    if (error == std::errc{} && value > 0 && value <= n) return std::uint32_t(value - 1);
    if (error == std::errc{} && value < 0 && value >= -n) return std::uint32_t(n + value);
    if (error != std::errc{} || value <= 0 || value > std::int64_t(size_))
      bad_index(kind, in_quotes(corner_text), n, in_.line());
    if (value > highest_[kind].index) highest_[kind] = {value, in_.line()};
    return std::uint32_t(value - 1);
  }

  [[noreturn]] void bad_index(int kind, const Text& found, std::int64_t n, long line) const {
    constexpr Words names[] = {{"vertices (v)", "頂点 (v)"},
                               {"texture coordinates (vt)", "テクスチャ座標 (vt)"},
                               {"normals (vn)", "法線 (vn)"}};
    throw InputError(in_.where(),
                     phrase({"a face uses {0}, but there are {1} {2}", "面が{0}を使うが、{2}は{1}個"},
                            {found, text_of(n), names[kind]}),
                     {"numbers count from 1, or from -1 backwards", "番号は 1 から、または -1 から逆に数える"}, line);
  }

  void check_forward_indices() const {
    for (int kind = 0; kind < 3; ++kind)
      if (const auto n = std::int64_t(count(kind)); highest_[kind].index > n)
        bad_index(kind, text_of(highest_[kind].index), n, highest_[kind].line);
  }

  // The groups (g) name the parts until there is an object (o).
  void object(bool is_object) {
    if (is_object || !has_objects_) object_ = in_.rest();
    has_objects_ = has_objects_ || is_object;
    current_ = no_part;
  }

  void use_material() {
    material_ = in_.rest();
    current_ = no_part;
  }

  void material_file() {
    const std::string name(in_.rest());
    if (name.empty() || !load_mtl_ || !material_files_.insert(name).second) return;
    if (material_files_.size() > max_material_files)
      in_.fail({"more than 64 material files", "マテリアルファイルが 64 個を超えている"});
    materials_.merge(load_mtl_(name, notes_));
  }

  // The part that faces belong to now, made when its first face comes.
  FacesOfPart& part() {
    if (current_ != no_part) return parts_[current_];
    const auto [found, is_new] = part_numbers_.try_emplace(object_ + '\n' + material_, parts_.size());
    if (is_new) {
      if (parts_.size() == max_parts)
        in_.fail({"more than 10000 objects and materials", "物体と素材の組が 10000 を超えている"},
                 {"join objects before export", "書き出す前に物体をまとめる"});
      parts_.push_back({object_, material_, {}});
    }
    current_ = found->second;
    return parts_[current_];
  }

  void add_notes() {
    if (left_out_ > 0)
      notes_.push_back(
          phrase({"{0} lines, points, curves or calls were left out (the first in line {1}): only faces are drawn",
                  "線・点・曲線など{0}個を省いた（最初は{1}行目）。描くのは面だけ"},
                 {text_of(left_out_), text_of(first_left_out_)}));
    if (coloured_ > 0)
      notes_.push_back(
          phrase({"the colours of {0} vertices are not used", "頂点{0}個の色は使われない"}, {text_of(coloured_)}));
    std::set<std::string> missing;
    for (const FacesOfPart& p : parts_)
      if (!p.material.empty() && !materials_.contains(p.material)) missing.insert(p.material);
    if (!missing.empty())
      notes_.push_back(phrase(
          {"{0} materials are in no material file, such as {1}", "マテリアルファイルにない素材が{0}個ある（{1}など）"},
          {text_of(missing.size()), in_quotes(*missing.begin())}));
  }

  struct Highest {
    std::int64_t index = 0;
    long line = 0;
  };
  static constexpr std::size_t no_part = std::size_t(-1);

  TextScanner in_;
  std::size_t size_;
  const MtlLoader& load_mtl_;
  MeshData lists_;  // positions, normals and uvs of the whole file
  std::vector<FacesOfPart> parts_;
  std::unordered_map<std::string, std::size_t> part_numbers_;  // by object and material
  std::size_t current_ = no_part;
  std::string object_, material_;
  bool has_objects_ = false;
  std::set<std::string> material_files_;
  Materials materials_;
  std::array<Highest, 3> highest_;  // of v, vt, vn: the largest index that was not there yet
  std::uint64_t left_out_ = 0, coloured_ = 0;
  long first_left_out_ = 0;
  std::vector<Text> notes_;
};

}  // namespace

Model read_obj(std::string_view bytes, const std::string& where, const MtlLoader& load_mtl) {
  return ObjReader(bytes, where, load_mtl).read();
}

}  // namespace cg
