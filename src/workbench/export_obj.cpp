#include <span>

#include "params/numbers.h"
#include "scene/numbering.h"
#include "scene/text_scanner.h"
#include "scene/write_obj.h"
#include "shading/corner_normals.h"
#include "shading/surface.h"
#include "workbench/export.h"

namespace cg {

namespace {

bool is_fan(std::span<const Triangle> triangles, std::uint32_t begin, std::uint32_t end) {
  if (triangles.size() + 2 != end - begin) return false;
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    if (triangles[i].corner != std::array{begin + i, begin + i + 1, end - 1}) return false;
  return true;
}

// The mesh as it is drawn: normals by the scene's rule, faces that are fans around their last corner, none degenerate.
MeshData as_drawn(const Mesh& mesh, const Shading& shading) {
  const MeshData& from = mesh.data();
  const std::vector<glm::dvec3> normals =
      corner_normals(mesh, weld_positions(mesh), normal_rule(shading), shading.crease_angle);
  MeshData out;
  out.positions = from.positions, out.uvs = from.uvs;
  Numbering numbers(normals.size());
  const auto corner = [&](std::uint32_t c) {
    const std::uint32_t n = numbers(BitsAndIndex(normals[c]));
    if (n == out.normals.size()) out.normals.push_back(normals[c]);
    return Corner{from.corners[c].position, n, from.corners[c].uv};
  };
  std::vector<Corner> corners;
  const std::vector<Triangle>& triangles = mesh.triangles();
  for (std::size_t t = 0, end = 0; t < triangles.size(); t = end) {
    const std::uint32_t f = triangles[t].face;
    while (end < triangles.size() && triangles[end].face == f) ++end;
    const std::span<const Triangle> of_face(triangles.data() + t, end - t);
    const std::uint32_t first = from.first_corner[f], last = from.first_corner[f + 1];
    corners.clear();
    if (is_fan(of_face, first, last)) {
      for (std::uint32_t c = first; c < last; ++c) corners.push_back(corner(c));
      out.add_face(corners.data(), corners.data() + corners.size());
      continue;
    }
    for (const Triangle& triangle : of_face) {
      const Corner three[3] = {corner(triangle.corner[0]), corner(triangle.corner[1]), corner(triangle.corner[2])};
      out.add_face(three, three + 3);
    }
  }
  return out;
}

// In one word, as the file's `o` and the lines of comments need it.
std::string word_of(const std::string& name) {
  std::string word = readable(name);
  for (char& c : word)
    if (c == ' ' || c == '\\' || c == '#') c = '_';
  return word.empty() ? "object" : word;
}

std::string vector_text(const glm::dvec3& v) {
  return number_text(v.x) + ", " + number_text(v.y) + ", " + number_text(v.z);
}

std::string comment_of(const std::string& word, const Transform& t) {
  if (t == Transform{}) return "";
  return "\n" + word + " stands in its scene translated by " + vector_text(t.translate) + ", rotated by " +
         vector_text(t.rotate) + " degrees (x, then y, then z) and scaled by " + vector_text(t.scale);
}

}  // namespace

std::string export_obj(const Scene& scene) {
  std::string comment(exported_obj_begin.substr(2));  // obj_text writes the "# "
  std::vector<std::string> names;
  std::vector<MeshData> meshes;
  for (const Object& object : scene.objects) {
    if (!object.visible) continue;
    names.push_back(word_of(object.name));
    comment += comment_of(names.back(), object.transform);
    meshes.push_back(object.mesh ? as_drawn(*object.mesh, scene.shading) : MeshData{});
  }
  std::vector<ObjPart> parts;
  for (std::size_t i = 0; i < meshes.size(); ++i) parts.push_back({names[i], {}, &meshes[i]});
  return obj_text(parts, comment);
}

}  // namespace cg
