#include <algorithm>
#include <bit>
#include <glm/common.hpp>
#include <type_traits>

#include "image/display.h"
#include "params/file.h"
#include "params/slots.h"
#include "radiosity/elements.h"
#include "radiosity/solution_file.h"
#include "radiosity/solution_format.h"

namespace cg {

namespace solution_format {

std::string layout(std::uint64_t vertices, std::uint64_t faces, std::uint64_t patches) {
  const auto rgb = [](const char* type, const std::string& name) {
    std::string out;
    for (const char* channel : {"red", "green", "blue"})
      out += std::string("property ") + type + " " + name + channel + "\n";
    return out;
  };
  return "element vertex " + std::to_string(vertices) + "\nproperty float x\nproperty float y\nproperty float z\n" +
         rgb("float", "radiosity_") + rgb("uchar", "") + "element face " + std::to_string(faces) +
         "\nproperty list uchar uint vertex_indices\nproperty uint patch\nproperty uchar level\n" +
         rgb("double", "radiosity_") + "element patch " + std::to_string(patches) +
         "\nproperty uint object\nproperty uint face\nproperty double area\n" + rgb("double", "reflectance_") +
         rgb("double", "emission_") + rgb("double", "radiosity_");
}

std::string hexadecimal(std::uint64_t v) {
  std::string out(digits, '0');
  for (std::size_t i = digits; i-- > 0; v >>= 4) out[i] = "0123456789abcdef"[v & 15];
  return out;
}

// FNV-1a (Fowler, Noll and Vo).
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : bytes) hash = (hash ^ std::uint8_t(c)) * 0x100000001b3u;
  return hash;
}

}  // namespace solution_format

namespace {

template <class T>
void put(std::string& out, T value) {
  using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t,
                                  std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint8_t>>;
  const Bits bits = std::bit_cast<Bits>(value);
  for (std::size_t i = 0; i < sizeof(T); ++i) out += char(std::uint8_t(std::uint64_t(bits) >> (8 * i)));
}

template <class Real>
void put(std::string& out, const Vec3<Real>& v) {
  for (int i = 0; i < 3; ++i) put(out, v[i]);
}

void put_vertices(std::string& out, const RadiositySolution& solution, const Outlines& outlines) {
  const Patches& patches = *solution.patches;
  std::vector<glm::dvec3> reflected = solution.element_radiosity, emission(patches.vertices.size(), glm::dvec3(0));
  for (std::size_t e = 0; e < reflected.size(); ++e) {
    const Element& element = patches.elements[e];
    reflected[e] -= patches.patches[element.patch].emission;
    for (int i = 0; i < element.corners; ++i)
      emission[element.vertex[std::size_t(i)]] = patches.patches[element.patch].emission;
  }
  const std::vector<glm::dvec3> values = vertex_values(patches, outlines, reflected);
  double brightest = 0;
  for (const glm::dvec3& v : values) brightest = std::max({brightest, v.x, v.y, v.z});
  for (std::size_t v = 0; v < values.size(); ++v) {
    const glm::vec3 light(glm::max(values[v], glm::dvec3(0)) + emission[v]);
    put(out, glm::vec3(patches.vertices[v].position));
    put(out, light);
    for (int i = 0; i < 3; ++i)
      put(out, to_8bit(srgb_from_linear(brightest > 0 ? float(light[i] / brightest) : light[i])));
  }
}

void put_faces(std::string& out, const RadiositySolution& solution, const Outlines& outlines) {
  for (std::size_t e = 0; e < solution.patches->elements.size(); ++e) {
    const Element& element = solution.patches->elements[e];
    // A list's length is a byte: an outline of more corners leaves out those in its edges.
    const std::uint32_t first = outlines.first[e], corners = outlines.first[e + 1] - first;
    const bool whole = corners < 256;
    put(out, std::uint8_t(whole ? corners : std::uint32_t(element.corners)));
    for (std::uint32_t i = 0; i < (whole ? corners : std::uint32_t(element.corners)); ++i)
      put(out, whole ? outlines.vertex[first + i] : element.vertex[i]);
    put(out, element.patch);
    put(out, std::uint8_t(element.level));
    put(out, solution.element_radiosity[e]);
  }
}

void put_patches(std::string& out, const RadiositySolution& solution) {
  for (std::size_t p = 0; p < solution.patches->patches.size(); ++p) {
    const Patch& patch = solution.patches->patches[p];
    put(out, patch.object), put(out, patch.face), put(out, patch.area);
    put(out, patch.reflectance), put(out, patch.emission), put(out, solution.radiosity[p]);
  }
}

std::string figures_text(const RadiosityFigures& f) {
  Tree out;
  out.at("residual") = f.residual;
  out.at("error_bound") = f.error_bound;
  out.at("sweeps") = f.sweeps;
  out.at("steps") = f.steps;
  return to_json(out, 0);
}

}  // namespace

std::string solution_bytes(const RadiositySolution& solution) {
  namespace format = solution_format;
  const Patches& patches = *solution.patches;
  const Outlines outlines = outlines_of(patches);
  Radiosity options = solution.options;
  std::string out = "ply\nformat binary_little_endian 1.0\n";
  out += format::title;
  out.append(format::geometry_key).append(format::hexadecimal(solution.geometry)).append("\n");
  out.append(format::parameters_key).append(to_json(values_of(slots(options)), 0)).append("\n");
  out.append(format::figures_key).append(figures_text(solution.figures)).append("\n");
  out.append(format::size_key);
  const std::size_t size_at = out.size();
  out.append(format::digits, '0').append("\n").append(format::checksum_key);
  const std::size_t checksum_at = out.size();
  out.append(format::digits, '0').append("\n");
  out += format::layout(patches.vertices.size(), patches.elements.size(), patches.patches.size());
  out += format::end;
  put_vertices(out, solution, outlines);
  put_faces(out, solution, outlines);
  put_patches(out, solution);
  out.replace(size_at, format::digits, format::hexadecimal(out.size()));
  out.replace(checksum_at, format::digits, format::hexadecimal(format::checksum(out)));
  return out;
}

void save_solution(const RadiositySolution& solution, const std::filesystem::path& file) {
  save_file(file, solution_bytes(solution));
}

}  // namespace cg
