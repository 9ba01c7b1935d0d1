// Reads PLY, as text and as bytes in either order: polygons, with uv and normals of vertices or uv of corners.
// Source: Greg Turk, "The PLY Polygon File Format", 1994; MeshLab's `texcoord` lists.
#include <array>

#include "scene/model_file.h"
#include "scene/model_parts.h"
#include "scene/ply_body.h"

namespace cg {

namespace {

// Where the value of a vertex's property goes.
enum Role { x, y, z, nx, ny, nz, u, v, skipped };
constexpr Words role_names[] = {{"an x coordinate", "x 座標"},
                                {"a y coordinate", "y 座標"},
                                {"a z coordinate", "z 座標"},
                                {"the x of a normal", "法線の x"},
                                {"the y of a normal", "法線の y"},
                                {"the z of a normal", "法線の z"},
                                {"a texture coordinate u", "テクスチャ座標 u"},
                                {"a texture coordinate v", "テクスチャ座標 v"}};

// The names under which programs write texture coordinates.
constexpr std::array<std::array<std::string_view, 2>, 4> uv_names{
    {{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}};

bool has_scalars(const PlyElement& element, std::initializer_list<std::string_view> names) {
  for (std::string_view name : names) {
    const PlyProperty* p = element.find(name);
    if (!p || p->count_type) return false;
  }
  return true;
}

std::vector<Role> vertex_roles(const PlyElement& element, const std::string& where) {
  for (std::string_view name : {"x", "y", "z"})
    if (!has_scalars(element, {name}))
      throw InputError(where,
                       phrase({"the vertices have no property {0}", "頂点にプロパティ{0}がない"}, {in_quotes(name)}),
                       {"property float x, y and z are expected", "property float x, y, z が必要"}, element.line);
  std::vector<Role> roles(element.properties.size(), skipped);
  const auto give = [&](std::string_view name, Role role) {
    roles[std::size_t(element.find(name) - element.properties.data())] = role;
  };
  give("x", x), give("y", y), give("z", z);
  if (has_scalars(element, {"nx", "ny", "nz"})) give("nx", nx), give("ny", ny), give("nz", nz);
  for (const auto& [first, second] : uv_names) {
    if (!has_scalars(element, {first, second})) continue;
    give(first, u), give(second, v);
    break;
  }
  return roles;
}

template <class Body>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Body body, std::string where)
      : header_(header), body_(std::move(body)), where_(std::move(where)) {}

  Model read() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") vertex_count_ = element.count;
      if (element.name == "face") face_count_ = element.count;
    }
    if (face_count_ == 0)
      throw InputError(where_, {"the file has no face", "面がない"},
                       {"a model needs at least one", "面が少なくとも 1 つ必要"}, 1);
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex")
        vertices(element);
      else if (element.name == "face")
        faces(element);
      else
        skip(element);
    }
    body_.expect_end();
    give_to_corners();
    Model model = single_part(std::move(mesh_));
    model.notes = std::move(notes_);
    return model;
  }

 private:
  void vertices(const PlyElement& element) {
    const std::vector<Role> roles = vertex_roles(element, where_);
    const bool normals = std::ranges::find(roles, nx) != roles.end(), uvs = std::ranges::find(roles, u) != roles.end();
    if (element.find("red"))
      notes_.push_back(
          phrase({"the colours of {0} vertices are not used", "頂点{0}個の色は使われない"}, {text_of(element.count)}));
    mesh_.positions.reserve(element.count);
    if (normals) mesh_.normals.reserve(element.count);
    if (uvs) vertex_uvs_.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      std::array<double, 8> value{};
      body_.begin(element, i);
      for (std::size_t k = 0; k < roles.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (roles[k] == skipped)
          skip(property);
        else
          value[roles[k]] = body_.number(property.type, role_names[roles[k]]);
      }
      body_.end();
      mesh_.positions.emplace_back(value[x], value[y], value[z]);
      if (normals) mesh_.normals.emplace_back(value[nx], value[ny], value[nz]);
      if (uvs) vertex_uvs_.emplace_back(value[u], value[v]);
    }
  }

  void faces(const PlyElement& element) {
    const PlyProperty* indices = element.find("vertex_indices");
    if (!indices) indices = element.find("vertex_index");
    if (!indices || !indices->count_type || !is_integer(indices->type))
      throw InputError(
          where_, {"the faces have no list of vertex indices", "面に頂点番号のリストがない"},
          {"property list uchar int vertex_indices is expected", "property list uchar int vertex_indices が必要"},
          element.line);
    mesh_.first_corner.reserve(element.count + 1);
    mesh_.corners.reserve(3 * element.count);
    std::vector<Corner> corners;
    std::vector<double> uvs;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      corners.clear();
      uvs.clear();
      body_.begin(element, i);
      for (const PlyProperty& property : element.properties) {
        if (&property == indices)
          each_in_list(property, [&] { corners.push_back({.position = vertex_index(property)}); });
        else if (property.name == "texcoord" && property.count_type && !is_integer(property.type))
          each_in_list(property, [&] { uvs.push_back(body_.number(property.type, role_names[u])); });
        else
          skip(property);
      }
      body_.end();
      add_face(corners, uvs);
    }
  }

  std::uint32_t vertex_index(const PlyProperty& property) {
    const std::int64_t index = body_.integer(property.type, {"a vertex index", "頂点番号"});
    if (index < 0 || std::uint64_t(index) >= vertex_count_)
      body_.fail(phrase({"a face uses vertex {0}, but there are {1}", "面が頂点{0}を使うが、頂点は{1}個"},
                        {text_of(index), text_of(vertex_count_)}),
                 {"vertices count from 0", "頂点の番号は 0 から"});
    return std::uint32_t(index);
  }

  void add_face(std::vector<Corner>& corners, const std::vector<double>& uvs) {
    if (corners.size() < 3)
      body_.fail(phrase({"a face with {0} corners", "角が{0}個の面"}, {text_of(corners.size())}),
                 {"a face has at least three", "面の角は 3 個以上"});
    if (!uvs.empty() && uvs.size() != 2 * corners.size())
      body_.fail(phrase({"a texcoord list of {0} numbers for {1} corners", "角{1}個の面の texcoord に数が{0}個"},
                        {text_of(uvs.size()), text_of(corners.size())}),
                 {"two for each corner, or none", "角ごとに 2 個、またはなし"});
    for (std::size_t k = 0; 2 * k < uvs.size(); ++k) {
      corners[k].uv = std::uint32_t(mesh_.uvs.size());
      mesh_.uvs.emplace_back(uvs[2 * k], uvs[2 * k + 1]);
    }
    mesh_.add_face(corners.data(), corners.data() + corners.size());
  }

  // The vertices' normals and, where no corner has a uv of its own, their uvs become those of their corners.
  void give_to_corners() {
    const bool uvs = mesh_.uvs.empty() && !vertex_uvs_.empty();
    if (uvs) mesh_.uvs = std::move(vertex_uvs_);
    for (Corner& corner : mesh_.corners) {
      if (!mesh_.normals.empty()) corner.normal = corner.position;
      if (uvs) corner.uv = corner.position;
    }
  }

  template <class Take>
  void each_in_list(const PlyProperty& property, Take take) {
    const std::int64_t n = body_.integer(*property.count_type, {"the length of a list", "リストの長さ"});
    if (n < 0)
      body_.fail(phrase({"a list of length {0}", "長さ {0} のリスト"}, {text_of(n)}), {"0 or more", "0 以上が必要"});
    for (std::int64_t i = 0; i < n; ++i) take();
  }

  void skip(const PlyProperty& property) {
    if (property.count_type)
      each_in_list(property, [&] { body_.skip(property.type); });
    else
      body_.skip(property.type);
  }

  void skip(const PlyElement& element) {
    if (element.properties.empty() || element.count == 0) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      body_.begin(element, i);
      for (const PlyProperty& property : element.properties) skip(property);
      body_.end();
    }
    notes_.push_back(phrase({"{0} {1} were left out: only faces are drawn", "{1}{0}個を省いた。描くのは面だけ"},
                            {text_of(element.count), in_quotes(element.name)}));
  }

  const PlyHeader& header_;
  Body body_;
  std::string where_;
  std::uint64_t vertex_count_ = 0, face_count_ = 0;
  MeshData mesh_;
  std::vector<glm::dvec2> vertex_uvs_;
  std::vector<Text> notes_;
};

}  // namespace

Model read_ply(std::string_view bytes, const std::string& where) {
  TextScanner in(bytes, where, {});
  const PlyHeader header = read_ply_header(in, bytes);
  if (header.format == PlyFormat::ascii) return PlyReader(header, PlyText(in), where).read();
  return PlyReader(header, PlyBytes(bytes, header, where), where).read();
}

}  // namespace cg
