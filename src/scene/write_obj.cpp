#include "scene/write_obj.h"

#include "params/numbers.h"

namespace cg {

namespace {

void add_line(std::string& out, std::string_view keyword, std::string_view rest) {
  out.append(keyword).append(" ").append(rest).append("\n");
}

template <class List>
void add_vectors(std::string& out, std::string_view keyword, const List& list) {
  for (const auto& v : list) {
    out += keyword;
    for (int i = 0; i < v.length(); ++i) out.append(" ").append(number_text(v[i] + 0.0));  // -0 becomes 0
    out += '\n';
  }
}

// OBJ counts from 1 through all parts.
struct Offsets {
  std::size_t position = 1, normal = 1, uv = 1;
};

void add_corner(std::string& out, const Corner& c, const Offsets& from) {
  out.append(" ").append(std::to_string(from.position + c.position));
  if (c.uv == no_index && c.normal == no_index) return;
  out += '/';
  if (c.uv != no_index) out += std::to_string(from.uv + c.uv);
  if (c.normal != no_index) out.append("/").append(std::to_string(from.normal + c.normal));
}

}  // namespace

std::string obj_text(std::span<const ObjPart> parts, std::string_view comment, std::string_view mtllib) {
  std::string out;
  for (std::size_t begin = 0; begin < comment.size();) {
    const std::size_t end = std::min(comment.find('\n', begin), comment.size());
    add_line(out, "#", comment.substr(begin, end - begin));
    begin = end + 1;
  }
  if (!mtllib.empty()) add_line(out, "mtllib", mtllib);
  Offsets from;
  for (const ObjPart& part : parts) {
    const MeshData& data = *part.mesh;
    if (!part.name.empty()) add_line(out, "o", part.name);
    add_vectors(out, "v", data.positions);
    add_vectors(out, "vt", data.uvs);
    add_vectors(out, "vn", data.normals);
    if (!part.material.empty()) add_line(out, "usemtl", part.material);
    for (std::size_t f = 0; f < data.face_count(); ++f) {
      out += 'f';
      for (std::uint32_t c = data.first_corner[f]; c < data.first_corner[f + 1]; ++c)
        add_corner(out, data.corners[c], from);
      out += '\n';
    }
    from.position += data.positions.size(), from.normal += data.normals.size(), from.uv += data.uvs.size();
  }
  return out;
}

}  // namespace cg
