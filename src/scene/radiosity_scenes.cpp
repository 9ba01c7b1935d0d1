#include "scene/radiosity_scenes.h"

#include <algorithm>
#include <array>

#include "math/vec.h"
#include "scene/polygon.h"
#include "scene/shape_makers.h"

namespace cg {

namespace {

using Polygon = std::vector<glm::dvec3>;

// The rectangle corner, corner + u, corner + u + v, corner + v; its front is where u x v points.
Polygon rectangle(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
  return {corner, corner + u, corner + u + v, corner + v};
}

// Faces in one list of positions, each with its normal.
MeshData mesh_of(const std::vector<Polygon>& polygons) {
  MeshData mesh;
  for (const Polygon& polygon : polygons) {
    const glm::dvec3 normal = polygon_normal(polygon);
    auto n = std::find(mesh.normals.begin(), mesh.normals.end(), normal);
    const std::uint32_t normal_index = std::uint32_t(n - mesh.normals.begin());
    if (n == mesh.normals.end()) mesh.normals.push_back(normal);
    std::vector<Corner> face;
    for (const glm::dvec3& p : polygon) {
      const auto found = std::find(mesh.positions.begin(), mesh.positions.end(), p);
      face.push_back({std::uint32_t(found - mesh.positions.begin()), normal_index, no_index});
      if (found == mesh.positions.end()) mesh.positions.push_back(p);
    }
    mesh.add_face(face.data(), face.data() + face.size());
  }
  return mesh;
}

enum Wall { floor_wall, ceiling_wall, back_wall, front_wall, left_wall, right_wall };

// The walls of a room between two corners, seen from inside: back is at the smaller z, left at the smaller x.
std::array<Polygon, 6> walls(const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 d = high - low, x(d.x, 0, 0), y(0, d.y, 0), z(0, 0, d.z);
  return {rectangle(low, z, x),     rectangle(low + y, x, z), rectangle(low, x, y),
          rectangle(low + z, y, x), rectangle(low, y, z),     rectangle(low + x, z, y)};
}

// A box seen from outside.
void add_box(std::vector<Polygon>& out, const glm::dvec3& low, const glm::dvec3& high) {
  for (Polygon wall : walls(low, high)) {
    std::reverse(wall.begin(), wall.end());
    out.push_back(wall);
  }
}

BundledMaterial grey(const char* name, double reflectance, double emission = 0) {
  return {name, glm::dvec3(reflectance), glm::dvec3(emission)};
}

BundledScene parallel_squares() {
  return {"parallel-squares",
          "two unit squares, 1 m apart, the lower one a light",
          {{"lower", "light", mesh_of({rectangle({-0.5, -0.5, -0.5}, {0, 0, 1}, {1, 0, 0})})},
           {"upper", "grey", mesh_of({rectangle({-0.5, 0.5, -0.5}, {1, 0, 0}, {0, 0, 1})})}},
          {grey("light", 0.5, 1), grey("grey", 0.5)},
          {1.6, 0.9, 2.2}};
}

BundledScene perpendicular_squares() {
  return {"perpendicular-squares",
          "two unit squares with a common edge, the standing one a light",
          {{"floor", "grey", mesh_of({rectangle({-0.5, 0, -0.5}, {0, 0, 1}, {1, 0, 0})})},
           {"wall", "light", mesh_of({rectangle({-0.5, 0, -0.5}, {1, 0, 0}, {0, 1, 0})})}},
          {grey("light", 0.5, 1), grey("grey", 0.5)},
          {1.2, 1.2, 2.2}};
}

BundledScene closed_cube() {
  const auto w = walls(glm::dvec3(-0.5), glm::dvec3(0.5));
  BundledScene scene{"closed-cube",
                     "a cube of 1 m seen from inside, its floor a light",
                     {},
                     {grey("light", 0.5, 1), grey("grey", 0.5)},
                     {0, 0, 0.56},
                     {0, -0.05, -0.5},
                     80};
  constexpr std::array names{"floor", "ceiling", "back", "front", "left", "right"};
  for (std::size_t i = 0; i < w.size(); ++i)
    scene.parts.push_back({names[i], i == floor_wall ? "light" : "grey", mesh_of({w[i]})});
  return scene;
}

// The faces of a sphere whose middle is below the equator, or above it, turned inside out.
MeshData inside_of_sphere(const MeshData& sphere, bool lower) {
  MeshData out;
  std::vector<std::uint32_t> number(sphere.positions.size(), no_index);
  for (std::size_t f = 0; f < sphere.face_count(); ++f) {
    double height = 0;
    std::vector<Corner> face;
    for (std::uint32_t c = sphere.first_corner[f + 1]; c-- > sphere.first_corner[f];) {
      const std::uint32_t p = sphere.corners[c].position;
      height += sphere.positions[p].y;
      face.push_back({p, p, no_index});
    }
    if ((height < 0) != lower) continue;
    for (Corner& c : face) {
      std::uint32_t& n = number[c.position];
      if (n == no_index) {
        n = std::uint32_t(out.positions.size());
        out.positions.push_back(sphere.positions[c.position]);
        out.normals.push_back(-sphere.positions[c.position]);
      }
      c = {n, n, no_index};
    }
    out.add_face(face.data(), face.data() + face.size());
  }
  return out;
}

BundledScene sphere_interior() {
  const MeshData sphere = make_uv_sphere(48);
  return {"sphere-interior",
          "a sphere of 1 m seen from inside, its lower half a light",
          {{"lower", "light", inside_of_sphere(sphere, true)}, {"upper", "grey", inside_of_sphere(sphere, false)}},
          {grey("light", 0.5, 1), grey("grey", 0.5)},
          {0, 0.3, 0.85},
          {0, -0.1, -1},
          90};
}

// The wall with the window is cut from its corners to the window's, so that no edge ends inside another.
BundledScene furnished_room() {
  const glm::dvec3 low(-2.5, 0, -2), high(2.5, 2.7, 2);
  const auto w = walls(low, high);
  const double sill = 0.9, lintel = 2.3, from = -1.3, to = 0.7, x = -2.5;  // the window in the left wall
  const Polygon outer = w[left_wall], window = rectangle({x, sill, from}, {0, lintel - sill, 0}, {0, 0, to - from});
  std::vector<Polygon> around;
  for (std::size_t i = 0; i < 4; ++i) around.push_back({outer[i], outer[(i + 1) % 4], window[(i + 1) % 4], window[i]});
  std::vector<Polygon> table, chair, shelf, bed;
  add_box(table, {-0.7, 0.7, -0.5}, {0.7, 0.75, 0.3});
  for (const double tx : {-0.65, 0.59})
    for (const double tz : {-0.45, 0.19}) add_box(table, {tx, 0, tz}, {tx + 0.06, 0.7, tz + 0.06});
  add_box(chair, {-0.22, 0.42, 0.45}, {0.22, 0.47, 0.9});
  add_box(chair, {-0.22, 0.47, 0.86}, {0.22, 0.95, 0.9});
  for (const double tx : {-0.22, 0.18})
    for (const double tz : {0.45, 0.86}) add_box(chair, {tx, 0, tz}, {tx + 0.04, 0.42, tz + 0.04});
  add_box(shelf, {1.2, 0, -1.95}, {2.3, 1.9, -1.55});
  add_box(bed, {1.3, 0, -0.4}, {2.45, 0.45, 1.7});
  const std::vector<BundledMaterial> materials{
      {"plaster", {0.8, 0.79, 0.76}, glm::dvec3(0)}, {"boards", {0.45, 0.28, 0.15}, glm::dvec3(0)},
      {"blue", {0.12, 0.25, 0.55}, glm::dvec3(0)},   {"wood", {0.6, 0.42, 0.24}, glm::dvec3(0)},
      {"red", {0.6, 0.1, 0.08}, glm::dvec3(0)},      {"sky", {0.1, 0.1, 0.1}, {6, 7, 8}}};
  return {"furnished-room",
          "a room of 5 m x 2.7 m x 4 m with a window, a table, a chair, a shelf and a bed",
          {{"floor", "boards", mesh_of({w[floor_wall]})},
           {"ceiling", "plaster", mesh_of({w[ceiling_wall]})},
           {"back-wall", "plaster", mesh_of({w[back_wall]})},
           {"front-wall", "plaster", mesh_of({w[front_wall]})},
           {"right-wall", "blue", mesh_of({w[right_wall]})},
           {"window-wall", "plaster", mesh_of(around)},
           {"window", "sky", mesh_of({window})},
           {"table", "wood", mesh_of(table)},
           {"chair", "wood", mesh_of(chair)},
           {"shelf", "wood", mesh_of(shelf)},
           {"bed", "red", mesh_of(bed)}},
          materials,
          {0.62, 0.12, 0.53},
          {-0.45, -0.12, -0.3},
          65};
}

// Walls of 16 strips each, as long as the corridor: a patch is many times longer than it is wide.
BundledScene corridor() {
  constexpr int strips = 16;
  const glm::dvec3 low(-0.5, -0.5, -8), high(0.5, 0.5, 8);
  const auto w = walls(low, high);
  const auto cut = [&](Wall wall) {
    std::vector<Polygon> out;
    const Polygon& p = w[std::size_t(wall)];
    // Across the corridor, from the wall's side that is as long as it to the other.
    const bool first_is_long = glm::distance(p[0], p[1]) > glm::distance(p[1], p[2]);
    const glm::dvec3 along = first_is_long ? p[1] - p[0] : p[3] - p[0],
                     across = first_is_long ? p[3] - p[0] : p[1] - p[0];
    for (int i = 0; i < strips; ++i) {
      const glm::dvec3 corner = p[0] + across * (double(i) / strips), width = across / double(strips);
      out.push_back(first_is_long ? rectangle(corner, along, width) : rectangle(corner, width, along));
    }
    return mesh_of(out);
  };
  return {"corridor",
          "a corridor of 1 m x 1 m x 16 m in long thin strips, the wall at its end a light",
          {{"floor", "grey", cut(floor_wall)},
           {"ceiling", "grey", cut(ceiling_wall)},
           {"left", "red", cut(left_wall)},
           {"right", "green", cut(right_wall)},
           {"near-end", "grey", mesh_of({w[front_wall]})},
           {"far-end", "light", mesh_of({w[back_wall]})}},
          {grey("grey", 0.7),
           {"red", {0.7, 0.2, 0.2}, glm::dvec3(0)},
           {"green", {0.2, 0.6, 0.25}, glm::dvec3(0)},
           grey("light", 0.5, 10)},
          {0.02, 0.01, 0.97},
          {0, 0, -1},
          60,
          0.2};
}

}  // namespace

std::vector<BundledScene> radiosity_scenes() {
  return {parallel_squares(), perpendicular_squares(), closed_cube(), sphere_interior(), furnished_room(), corridor()};
}

}  // namespace cg
