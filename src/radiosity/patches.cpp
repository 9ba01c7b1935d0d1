#include "radiosity/patches.h"

#include <algorithm>
#include <bit>
#include <charconv>

#include "params/input_error.h"
#include "params/numbers.h"
#include "radiosity/faces.h"
#include "radiosity/vertex_numbers.h"
#include "scene/polygon.h"

namespace cg {

namespace {

constexpr std::size_t most_patches = std::size_t(1) << 22;

// How many parts of at most `size` a length is cut in: a whole number of sizes, but for rounding, gives that number.
double parts_of(double length, double size) { return std::max(1.0, std::ceil(length / size * (1 - 1e-9))); }

// The parts along a quad's first and second side; of a triangle, a power of two along each side.
struct Cut {
  double right = 1, up = 1;
};

Cut cut_of(const SurfaceFace& face, double size) {
  const auto p = positions_of(face);
  const auto side = [&](std::size_t i, std::size_t j) { return glm::distance(p[i], p[j]); };
  if (face.corners == 4)
    return {parts_of(std::max(side(0, 1), side(3, 2)), size), parts_of(std::max(side(0, 3), side(1, 2)), size)};
  const double parts = parts_of(std::max({side(0, 1), side(1, 2), side(2, 0)}), size);
  const double power = std::exp2(std::ceil(std::log2(parts)));
  return {power, power};
}

// One digit, rounded up.
std::string one_digit(double v) {
  const double unit = std::pow(10, std::floor(std::log10(v)));
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, std::ceil(v / unit) * unit, std::chars_format::general, 1);
  return {text, end.ptr};
}

// Throws InputError where there are too many.
std::size_t count_of(const std::vector<SurfaceFace>& faces, double size) {
  double count = 0;
  for (const SurfaceFace& face : faces) {
    const Cut cut = cut_of(face, size);
    count += cut.right * cut.up;
  }
  if (count <= double(most_patches)) return std::size_t(count);
  const std::string about = std::to_string(static_cast<long long>(std::min(count, 1e18)));
  const std::string most = std::to_string(most_patches);
  if (faces.size() > most_patches / 2)
    throw InputError("radiosity",
                     {std::to_string(faces.size()) + " faces", "面が " + std::to_string(faces.size()) + " 個ある"},
                     {"at most " + most + " patches are possible", "パッチの上限は " + most + " 個"});
  const std::string enough =
      one_digit(size * std::sqrt(4 * count / double(most_patches)));  // half the size: four times
  throw InputError(
      "radiosity.patch_size",
      {number_text(size) + " m makes " + about + " patches of this scene",
       number_text(size) + " m ではパッチが " + about + " 個になる"},
      {"at most " + most + " are possible: try " + enough, "上限は " + most + " 個: " + enough + " なら収まる"});
}

void check_reflectance(const Object& object, std::size_t index, const Material& material) {
  constexpr std::array<Words, 3> channels{{{"red", "赤"}, {"green", "緑"}, {"blue", "青"}}};
  for (int c = 0; c < 3; ++c) {
    if (material.k_d[c] >= 0 && material.k_d[c] <= 1) continue;
    const Words& channel = channels[std::size_t(c)];
    const std::string value = number_text(material.k_d[c]), path = ".material.k_d";
    throw InputError(object.own_material ? "objects." + std::to_string(index) + path : path.substr(1),
                     {object.name + " reflects " + value + " of the " + std::string(channel.en) + " light",
                      object.name + ": " + std::string(channel.ja) + "の反射率が " + value},
                     {"radiosity needs a reflectance from 0 to 1: above it light would grow without end",
                      "ラジオシティの反射率は 0 から 1。1 を超えると光が際限なく増える"});
  }
}

// Sets the area and the centre of mass, from the corners and the normal.
void measure(Patch& p) {
  const glm::dvec3 a = p.corner[1] - p.corner[0], b = p.corner[2] - p.corner[0];
  const glm::dvec3 c = p.corners == 4 ? p.corner[3] - p.corner[0] : b;
  const double first = 0.5 * glm::dot(p.normal, glm::cross(a, b)), second = 0.5 * glm::dot(p.normal, glm::cross(b, c));
  p.area = positive(first + second);
  const double share = p.area > 0 ? second / (first + second) : 0;
  p.centre = p.corner[0] + ((1 - share) * (a + b) + share * (b + c)) / 3.0;
}

// Cuts faces and adds the pieces.
class Cutter {
 public:
  Cutter(const Scene& scene, double size, Patches& out)
      : scene_(scene), size_(size), out_(out), number_(out.vertices) {}

  void add(const SurfaceFace& face, const Progress& progress) {
    face_ = &face;
    const Cut cut = cut_of(face, size_);
    const long right = long(cut.right), up = long(cut.up);
    below_ = row(0, right, up);
    for (long j = 0; j < up; ++j) {
      if (progress.cancelled) throw Cancelled{};
      above_ = row(j + 1, right, up);
      if (face.corners == 4)
        for (std::size_t i = 0; i < std::size_t(right); ++i)
          add_patch({below_[i], below_[i + 1], above_[i + 1], above_[i]}, 4);
      else
        add_triangles(std::size_t(right - j));
      std::swap(below_, above_);
    }
  }

 private:
  // The vertices of row j: of a quad right + 1, of a triangle one less in each row.
  std::vector<std::uint32_t> row(long j, long right, long up) {
    const auto& c = face_->corner;
    const bool quad = face_->corners == 4;
    const ElementVertex first = between(c[0], quad ? c[3] : c[2], j, up), last = between(c[1], c[2], j, up);
    const long n = quad ? right : right - j;
    std::vector<std::uint32_t> out;
    for (long i = 0; i <= n; ++i) out.push_back(number_(n == 0 ? first : between(first, last, i, n)));
    return out;
  }

  void add_triangles(std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
      add_patch({below_[i], below_[i + 1], above_[i], 0}, 3);
      if (i + 1 < n) add_patch({below_[i + 1], above_[i + 1], above_[i], 0}, 3);
    }
  }

  void add_patch(const std::array<std::uint32_t, 4>& vertex, int corners) {
    const Material& material = material_of(scene_, scene_.objects[face_->object]);
    Patch p{.corners = corners,
            .normal = face_->normal,
            .reflectance = material.k_d,
            .emission = material.emission,
            .object = face_->object,
            .face = face_->face};
    for (std::size_t i = 0; i < std::size_t(corners); ++i) p.corner[i] = out_.vertices[vertex[i]].position;
    measure(p);
    out_.elements.push_back({vertex, corners, std::uint32_t(out_.patches.size()), 0, p.area});
    out_.first_element.push_back(std::uint32_t(out_.elements.size()));
    out_.patches.push_back(p);
  }

  const Scene& scene_;
  double size_;
  Patches& out_;
  VertexNumbers number_;
  const SurfaceFace* face_ = nullptr;
  std::vector<std::uint32_t> below_, above_;
};

}  // namespace

Patches make_patches(const Scene& scene, const Radiosity& options, Progress& progress) {
  for (std::size_t o = 0; o < scene.objects.size(); ++o)
    if (scene.objects[o].visible && scene.objects[o].mesh)
      check_reflectance(scene.objects[o], o, material_of(scene, scene.objects[o]));
  const SurfaceFaces faces = faces_of(scene, progress);
  Patches out;
  out.patches.reserve(count_of(faces.faces, options.patch_size));
  out.elements.reserve(out.patches.capacity());
  out.degenerate = faces.degenerate;
  out.closed = enclosed(faces.faces, progress);
  Cutter cutter(scene, options.patch_size, out);
  for (std::size_t f = 0; f < faces.faces.size(); ++f) {
    cutter.add(faces.faces[f], progress);
    progress.fraction = float(f + 1) / float(faces.faces.size());
  }
  return out;
}

std::size_t count_patches(const Scene& scene, const Radiosity& options, Progress& progress) {
  return count_of(faces_of(scene, progress).faces, options.patch_size);
}

Patch element_as_patch(const Patches& patches, std::uint32_t element) {
  const Element& e = patches.elements[element];
  Patch p = patches.patches[e.patch];
  if (e.level == 0) return p;
  p.corners = e.corners;
  for (std::size_t i = 0; i < std::size_t(e.corners); ++i) p.corner[i] = patches.vertices[e.vertex[i]].position;
  measure(p);
  return p;
}

namespace {

class Hash {
 public:
  void add(std::uint64_t bits) {
    value_ = (value_ ^ bits) * 0x9e3779b97f4a7c15u;
    value_ ^= value_ >> 29;
  }
  void add(double v) { add(std::bit_cast<std::uint64_t>(v + 0.0)); }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace

std::uint64_t geometry_key(const Scene& scene, const Radiosity& options) {
  Hash hash;
  hash.add(options.patch_size);
  hash.add(std::uint64_t(options.adaptive_levels));
  if (options.adaptive_levels > 0) hash.add(options.gradient);
  for (std::size_t o = 0; o < scene.objects.size(); ++o) {
    const Object& object = scene.objects[o];
    if (!object.visible || !object.mesh) continue;
    hash.add(std::uint64_t(o));
    const glm::dmat4 m = matrix(object.transform);
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 3; ++k) hash.add(m[i][k]);
    const MeshData& data = object.mesh->data();
    for (const glm::dvec3& p : data.positions)
      for (int k = 0; k < 3; ++k) hash.add(p[k]);
    for (const glm::dvec3& n : data.normals)
      for (int k = 0; k < 3; ++k) hash.add(n[k]);
    for (const Corner& c : data.corners) hash.add(std::uint64_t(c.position) << 32 | c.normal);
    for (const std::uint32_t first : data.first_corner) hash.add(std::uint64_t(first));
  }
  return hash.value();
}

}  // namespace cg
