// A mesh ready to be lit: triangles over vertices that each have one position and one normal, made by the
// scene's rule for normals. Software and OpenGL draw the same Surface, so they start from the same numbers.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mapping/corner_uv.h"
#include "math/vec.h"
#include "scene/mesh.h"
#include "scene/shading.h"

namespace cg {

struct Surface {
  // Positions are (mesh position - centre) / radius, computed in double: far offsets and extreme scales survive
  // float. Ordinary meshes need neither: centre is 0 unless the mesh lies more than 16 radii from the origin, and
  // radius is 1 unless the mesh is smaller than 2^-10 or larger than 2^10; then it is a power of two.
  glm::dvec3 centre{0};
  double radius = 1;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  // one a position; unit, but a file's own are as the file has them
  // One a position where a radiosity solution is drawn (shading/ambient_term.h), else empty. Within +-1e30.
  std::vector<glm::vec3> radiosity;
  // The sets that the layers of textures need (shading/layer_uv.h), each with one pair a position. Within +-1e30.
  std::vector<std::vector<glm::vec2>> uv;
  std::vector<std::uint32_t> indices;   // three a triangle, counter-clockwise, provoking vertex last
  std::vector<std::uint32_t> triangle;  // Mesh::triangles() index of each; degenerate ones are left out
  std::size_t bad_normals = 0;          // zero: such vertices get no diffuse and no specular term

  double made_ms = 0;  // CPU time of the thread that made it

  // Of the memory that it holds, but for radiosity and uv.
  std::size_t bytes() const {
    return (positions.capacity() + normals.capacity()) * sizeof(glm::vec3) +
           (indices.capacity() + triangle.capacity()) * sizeof(std::uint32_t);
  }
  std::size_t uv_bytes() const {
    std::size_t n = 0;
    for (const auto& set : uv) n += set.capacity() * sizeof(glm::vec2);
    return n;
  }
  std::size_t triangle_count() const { return triangle.size(); }
  // Surface to mesh coordinates: to be multiplied into the object's matrix, in double.
  glm::dmat4 to_mesh() const { return {{radius, 0, 0, 0}, {0, radius, 0, 0}, {0, 0, radius, 0}, {centre, 1}}; }
};

using SurfaceHandle = std::shared_ptr<const Surface>;

// `rule` and `crease_angle` (degrees, 180 smooths all) as in Shading; flat shading asks for NormalRule::face,
// whose vertices are not shared between faces. `file` falls back to `angle` for corners without a normal.
// `radiosity`: null, or one value a corner; `uv`: sets of one pair a corner. A vertex is split where those of its
// corners differ.
SurfaceHandle make_surface(const Mesh& mesh, NormalRule rule, double crease_angle,
                           const std::vector<glm::vec3>* radiosity = nullptr, std::span<const CornerUv> uv = {});

// The rule that the scene's shading comes to: flat shading has the faces' normals, whatever `normals` says.
inline NormalRule normal_rule(const Shading& s) { return s.mode == ShadingMode::flat ? NormalRule::face : s.normals; }

}  // namespace cg
