// Automatic mapping, after Bier and Sloan, Two-Part Texture Mappings, IEEE Computer Graphics and Applications 6 (1986):
// the texture lies on a simple surface, and each point of the object takes the nearest place of it.
#include "mapping/projection.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "scene/polygon.h"

namespace cg {

namespace {

// Far more than a texture can tell apart, and small enough that sums and products stay finite.
constexpr double farthest = 1e12;

double limited(double v) { return v >= -farthest && v <= farthest ? v : v > 0 ? farthest : v < 0 ? -farthest : 0; }
glm::dvec3 limited(const glm::dvec3& v) { return {limited(v.x), limited(v.y), limited(v.z)}; }

double ratio(double a, double b) { return b != 0 ? a / b : 0; }

// S^-1 R^T T^-1; a scale of 0 has no inverse and gives 0.
class IntoProjector {
 public:
  explicit IntoProjector(const Transform& t) : t_(t) {
    Transform turn;
    turn.rotate = t.rotate;
    to_local_ = glm::transpose(glm::dmat3(matrix(turn)));
  }
  glm::dvec3 operator()(const glm::dvec3& p) const {
    const glm::dvec3 q = to_local_ * (p - t_.translate);
    return limited({ratio(q.x, t_.scale.x), ratio(q.y, t_.scale.y), ratio(q.z, t_.scale.z)});
  }

 private:
  Transform t_;
  glm::dmat3 to_local_;
};

struct Around {
  double u;  // 0..1
  bool pole;
};

Around around_y(const glm::dvec3& p) {
  const double radius = std::hypot(p.x, p.z);
  if (!(radius > 1e-9 * std::abs(p.y))) return {0, true};
  const double u = std::atan2(-p.z, p.x) / (2 * pi);
  return {u < 0 ? u + 1 : u, false};
}

double polar_v(const glm::dvec3& p) { return std::atan2(std::hypot(p.x, p.z), -p.y) / pi; }

// u of a face's corners, whichever side of the seam they are on: each less than half a turn from the one before it, the
// least in 0..1.
void unroll(std::span<const glm::dvec3> local, std::span<glm::dvec2> uv) {
  const std::size_t n = local.size();
  std::vector<bool> pole(n);
  double last = 0, least = farthest;
  bool any = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Around a = around_y(local[i]);
    pole[i] = a.pole;
    if (a.pole) continue;
    last = any ? a.u + std::round(last - a.u) : a.u;
    any = true;
    uv[i].x = last, least = std::min(least, last);
  }
  constexpr double rounding = 1e-9;  // a corner on the seam may come out on either side of it
  const double turns = any ? std::floor(least + rounding) : 0;
  for (std::size_t i = 0; i < n; ++i)
    if (!pole[i]) uv[i].x = std::max(0.0, uv[i].x - turns);
  for (std::size_t i = 0; i < n; ++i) {
    if (!pole[i]) continue;
    double sum = 0;
    int count = 0;
    for (const std::size_t step : {std::size_t(1), n - 1})  // the nearest corner that is not at a pole, either way
      for (std::size_t j = (i + step) % n; j != i; j = (j + step) % n)
        if (!pole[j]) {
          sum += uv[j].x, ++count;
          break;
        }
    uv[i].x = count > 0 ? sum / count : 0;
  }
}

void box_uv(std::span<const glm::dvec3> local, std::span<glm::dvec2> uv) {
  const glm::dvec3 normal = polygon_normal(local), size = glm::abs(normal);
  // Of equal components, z before y before x, as cube maps are looked up.
  const int axis = size.z >= size.y && size.z >= size.x ? 2 : size.y >= size.x ? 1 : 0;
  const double side = normal[axis] < 0 ? -1 : 1;
  glm::dvec3 direction(0), up(0);
  direction[axis] = side;
  (axis == 1 ? up.z : up.y) = axis == 1 ? -side : 1;
  const glm::dvec3 right = glm::cross(up, direction);
  for (std::size_t i = 0; i < local.size(); ++i)
    uv[i] = {0.5 * (glm::dot(right, local[i]) + 1), 0.5 * (glm::dot(up, local[i]) + 1)};
}

glm::dvec2 seen_uv(const glm::dmat4& clip, const glm::dvec3& p) {
  const glm::dvec4 c = clip * glm::dvec4(limited(p), 1);
  const double w = std::max(c.w, 1e-9 * (std::abs(c.x) + std::abs(c.y)) + 1e-30);
  const auto coordinate = [&](double x) { return c.w > 0 ? 0.5 * (limited(x / w) + 1) : x < 0 ? 0.0 : 1.0; };
  return {coordinate(c.x), coordinate(c.y)};
}

void map_face(const Projector& projector, std::span<const glm::dvec3> local, std::span<glm::dvec2> uv) {
  const auto planar_v = [](double y) { return 0.5 * (y + 1); };
  switch (projector.shape) {
    case ProjectionShape::planar:
      for (std::size_t i = 0; i < local.size(); ++i) uv[i] = {0.5 * (local[i].x + 1), planar_v(local[i].y)};
      break;
    case ProjectionShape::cylindrical:
      for (std::size_t i = 0; i < local.size(); ++i) uv[i].y = planar_v(local[i].y);
      unroll(local, uv);
      break;
    case ProjectionShape::spherical:
      for (std::size_t i = 0; i < local.size(); ++i) uv[i].y = polar_v(local[i]);
      unroll(local, uv);
      break;
    case ProjectionShape::box:
      box_uv(local, uv);
      break;
    case ProjectionShape::view:
      break;
  }
}

}  // namespace

CornerUv projected_uv(const MeshData& data, const Projector& projector) {
  CornerUv uv(data.corners.size(), glm::dvec2(0));
  const IntoProjector into(projector.place);
  const glm::dmat4 clip = projection_matrix(projector.view, projector.aspect) * view_matrix(projector.view);
  std::vector<glm::dvec3> local;
  for (std::size_t f = 0; f < data.face_count(); ++f) {
    const std::uint32_t begin = data.first_corner[f], end = data.first_corner[f + 1];
    if (projector.shape == ProjectionShape::view) {
      for (std::uint32_t c = begin; c < end; ++c) uv[c] = seen_uv(clip, data.positions[data.corners[c].position]);
      continue;
    }
    local.clear();
    for (std::uint32_t c = begin; c < end; ++c) local.push_back(into(data.positions[data.corners[c].position]));
    if (!local.empty()) map_face(projector, local, {uv.data() + begin, end - begin});
  }
  for (glm::dvec2& p : uv) p = {limited(p.x * projector.repeat_u), limited(p.y * projector.repeat_v)};
  return uv;
}

Projector fitting_projector(ProjectionShape shape, const Mesh& mesh) {
  constexpr double largest = 1e30;  // of a transform's parameters
  Projector out;
  out.shape = shape;
  const auto within = [&](double v) { return std::clamp(v, -largest, largest); };
  const glm::dvec3 c = mesh.centre(), half = mesh.high() * 0.5 - mesh.low() * 0.5;
  out.place.translate = {within(c.x), within(c.y), within(c.z)};
  const double size = std::max({half.x, half.y, half.z, 1e-30});
  // What is flat has no extent to divide by.
  const auto extent = [&](double h) { return within(h > 1e-9 * size ? h : size); };
  switch (shape) {
    case ProjectionShape::planar:
      if (half.y < half.x && half.y <= half.z) {
        out.place.rotate = {-90, 0, 0};
        out.place.scale = {extent(half.x), extent(half.z), extent(half.y)};
      } else if (half.x < half.z) {
        out.place.rotate = {0, 90, 0};
        out.place.scale = {extent(half.z), extent(half.y), extent(half.x)};
      } else {
        out.place.scale = {extent(half.x), extent(half.y), extent(half.z)};
      }
      break;
    case ProjectionShape::cylindrical:
      out.place.scale = {within(size), extent(half.y), within(size)};
      break;
    default:
      out.place.scale = glm::dvec3(within(size));
  }
  return out;
}

}  // namespace cg
