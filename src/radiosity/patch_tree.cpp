#include "radiosity/patch_tree.h"

namespace cg {

namespace {

using Floats = Lanes<float>;
using Ints = Lanes<std::int32_t>;

// What is rounded in an edge's number and in a corner (compare item_raster.cpp): an edge leaves in what is nearer.
constexpr float rounding = 1.0f / (1 << 20), corner_rounding = 1.0f / (1 << 22);
constexpr float box_margin = 1e-6f, behind_at = 4e-6f;

void size_of(const Floats (&v)[3], Floats& out) {
  const auto size = [](const Floats& a, Floats& s) { s = Floats(Ints(a) & 0x7fffffff); };
  Floats x, y, z;
  size(v[0], x), size(v[1], y), size(v[2], z);
  out = x + y + z;
}

}  // namespace

PatchTree::PatchTree(std::span<const ItemPolygon> polygons) : polygons_(polygons), to_unit_(polygons) {
  std::vector<glm::vec3> centres;
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < polygons.size(); ++i) {
    const ItemPolygon p = to_unit_(polygons[i]);
    centres.push_back(glm::vec3((p[0] + p[1] + p[2] + p[3]) * 0.25));
    if (unit(area_vector(p)) != glm::dvec3(0)) order.push_back(i);
  }
  if (order.empty()) return;
  Box box;
  root_ = build(order.data(), order.data() + order.size(), centres, box);
}

// Eight parts of about equal counts, whole leaves each: halves of halves of halves, each cut across its longest side.
std::uint32_t PatchTree::build(std::uint32_t* begin, std::uint32_t* end, const std::vector<glm::vec3>& centres,
                               Box& box) {
  if (end - begin <= lanes) return make_leaf(begin, end, box);
  std::array<std::uint32_t*, lanes + 1> border;
  border.front() = begin, border.back() = end;
  for (std::size_t step = lanes; step > 1; step /= 2)
    for (std::size_t i = 0; i < lanes; i += step) {
      std::uint32_t *from = border[i], *to = border[i + step];
      glm::vec3 low(4), high(-4);
      for (const std::uint32_t* p = from; p != to; ++p)
        low = glm::min(low, centres[*p]), high = glm::max(high, centres[*p]);
      const glm::vec3 size = high - low;
      const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
      std::uint32_t* middle = from + ((to - from) / 2 + lanes - 1) / lanes * lanes;
      middle = std::min(middle, to);
      std::nth_element(from, middle, to,
                       [&](std::uint32_t a, std::uint32_t b) { return centres[a][axis] < centres[b][axis]; });
      border[i + step / 2] = middle;
    }
  const std::size_t place = nodes_.size();
  nodes_.emplace_back();
  Node node;
  box = {glm::vec3(4), glm::vec3(-4)};
  for (std::size_t i = 0; i < lanes; ++i) {
    Box part{glm::vec3(4), glm::vec3(-4)};
    node.child[i] = border[i] == border[i + 1] ? no_child : build(border[i], border[i + 1], centres, part);
    for (int k = 0; k < 3; ++k) node.low[k][int(i)] = part.low[k], node.high[k][int(i)] = part.high[k];
    box = {glm::min(box.low, part.low), glm::max(box.high, part.high)};
  }
  nodes_[place] = node;
  return std::uint32_t(place);
}

std::uint32_t PatchTree::make_leaf(const std::uint32_t* begin, const std::uint32_t* end, Box& box) {
  Leaf leaf{};
  leaf.patch.fill(no_item);
  box = {glm::vec3(4), glm::vec3(-4)};
  for (int lane = 0; begin + lane != end; ++lane) {
    leaf.patch[std::size_t(lane)] = begin[lane];
    const ItemPolygon p = to_unit_(polygons_[begin[lane]]);
    for (std::size_t c = 0; c < 4; ++c) {
      for (int k = 0; k < 3; ++k) leaf.corner[c][k][lane] = float(p[c][k]);
      box = {glm::min(box.low, glm::vec3(p[c]) - box_margin), glm::max(box.high, glm::vec3(p[c]) + box_margin)};
    }
    const glm::dvec3 n = unit(area_vector(p));
    for (int k = 0; k < 3; ++k) leaf.normal[k][lane] = float(n[k]);
  }
  leaves_.push_back(leaf);
  return std::uint32_t(leaves_.size() - 1) | leaf_bit;
}

void PatchTree::meet(const Leaf& leaf, const Ray& ray, const std::vector<std::uint16_t>& wanted, Hit& nearest) const {
  const glm::vec3& d = ray.direction;
  Floats at[4][3];
  for (int c = 0; c < 4; ++c)
    for (int k = 0; k < 3; ++k) at[c][k] = leaf.corner[c][k] - ray.origin[k];
  const Floats against = leaf.normal[0] * d.x + leaf.normal[1] * d.y + leaf.normal[2] * d.z;
  const Floats side = against < 0.0f ? Floats{} + 1.0f : Floats{} - 1.0f;
  Ints outside = against == 0.0f;
  for (int c = 0; c < 4; ++c) {
    const Floats(&a)[3] = at[c], (&b)[3] = at[(c + 1) % 4];
    const Floats e[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    Floats size_e, size_a;
    size_of(e, size_e), size_of(a, size_a);
    const Floats inside =
        (e[1] * a[2] - e[2] * a[1]) * d.x + (e[2] * a[0] - e[0] * a[2]) * d.y + (e[0] * a[1] - e[1] * a[0]) * d.z;
    outside |= inside * side + size_e * (size_a * rounding + corner_rounding) < 0.0f;
  }
  const Floats distance = (leaf.normal[0] * at[0][0] + leaf.normal[1] * at[0][1] + leaf.normal[2] * at[0][2]) / against;
  // A ray from a patch's border does not meet the back of the neighbour that the border rounds it behind.
  outside |= ~((distance > (against < 0.0f ? Floats{} : Floats{} + behind_at)) & (distance < nearest.distance));
  for (LaneBytes met = ~lane_bytes(outside) & one_in_each_lane; met != 0; met &= met - 1) {
    const int lane = first_lane(met);
    const std::uint32_t patch = leaf.patch[std::size_t(lane)];
    if (patch == no_item || (wanted[patch / 16] >> patch % 16 & 1) == 0) continue;
    if (distance[lane] < nearest.distance) nearest = {distance[lane], patch | (against[lane] < 0 ? 0 : from_behind)};
  }
}

std::uint32_t PatchTree::first_met(const glm::dvec3& origin, const glm::dvec3& direction,
                                   const std::vector<std::uint16_t>& wanted) const {
  const glm::vec3 d(direction);
  const auto inverse = [](float v) { return 1 / (std::abs(v) > 1e-20f ? v : std::copysign(1e-20f, v)); };
  const Ray ray{glm::vec3(to_unit_(origin)), d, {inverse(d.x), inverse(d.y), inverse(d.z)}};
  Hit nearest{std::numeric_limits<float>::max(), no_item};
  struct Waiting {
    std::uint32_t child;
    float distance;
  };
  std::array<Waiting, 128> stack;  // seven more a level than it takes away, and 2^32 patches are 10 levels
  std::size_t count = 0;
  if (root_ != no_child) stack[count++] = {root_, 0};
  while (count > 0) {
    const Waiting next = stack[--count];
    if (next.distance > nearest.distance) continue;
    if (next.child & leaf_bit) {
      meet(leaves_[next.child & ~leaf_bit], ray, wanted, nearest);
      continue;
    }
    const Node& node = nodes_[next.child];
    Floats enter{}, leave = Floats{} + nearest.distance;
    for (int k = 0; k < 3; ++k) {
      const bool forward = ray.inverse[k] > 0;
      const Floats first = ((forward ? node.low : node.high)[k] - ray.origin[k]) * ray.inverse[k];
      const Floats second = ((forward ? node.high : node.low)[k] - ray.origin[k]) * ray.inverse[k];
      enter = first > enter ? first : enter;
      leave = second < leave ? second : leave;
    }
    const std::size_t before = count;
    for (LaneBytes met = lane_bytes(enter <= leave * (1 + 1e-6f)) & one_in_each_lane; met != 0; met &= met - 1) {
      const int lane = first_lane(met);
      const Waiting w{node.child[std::size_t(lane)], enter[lane]};
      if (w.child == no_child) continue;
      std::size_t place = count++;  // the nearest comes last and is looked at first
      for (; place > before && stack[place - 1].distance < w.distance; --place) stack[place] = stack[place - 1];
      stack[place] = w;
    }
  }
  return nearest.item;
}

}  // namespace cg
