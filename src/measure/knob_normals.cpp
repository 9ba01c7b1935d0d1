// Rules for the normals of vertices, over the tessellation, against the normal of the curved surface.
#include <algorithm>
#include <cmath>

#include "measure/knob_list.h"
#include "measure/ladder_parts.h"
#include "measure/tessellations.h"
#include "scene/cpu_clock.h"
#include "shading/corner_normals.h"

namespace cg {

namespace {

constexpr NormalRule rules[] = {NormalRule::mean, NormalRule::area, NormalRule::angle};

Ladder ladder(const TradeRequest& request) {
  const View view = view_of(request, 512);
  const Tessellations meshes = tessellations_of(request.scene);
  Ladder out;
  for (std::size_t r = 0; r < std::size(rules); ++r)
    for (auto t = meshes.ladder.rbegin(); t != meshes.ladder.rend(); ++t) {
      Setting s;
      s.id = std::string(names_of<NormalRule>[std::size_t(rules[r])].id) + "-" + std::to_string(t->level);
      s.label = {std::to_string(t->level), std::to_string(t->level)};
      s.series = r;
      s.x = t->h;
      s.scene = t->scene;
      s.scene.shading.normals = rules[r];
      s.technique = technique_of(request, "software");
      s.view = view;
      out.settings.push_back(std::move(s));
    }
  // The exact normals come with the shape: nothing is drawn.
  Setting exact = reference_of(request.scene, View{});
  exact.view.width = exact.view.height = 0;
  out.references.push_back(std::move(exact));
  return out;
}

// What a setting costs is the computation of its normals; they are not in a frame.
Frame compute_normals(const Setting& setting, std::span<const Technique>, Progress&) {
  Frame frame;
  const double begin = thread_cpu_ms();
  for (const Object& object : setting.scene.objects)
    if (object.visible && object.mesh && setting.view.width > 0)
      corner_normals(*object.mesh, weld_positions(*object.mesh), setting.scene.shading.normals,
                     setting.scene.shading.crease_angle);
  frame.cpu_ms = thread_cpu_ms() - begin;
  return frame;
}

// The angle between two unit vectors, exact also where it is tiny.
double angle(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(length_and_unit(glm::cross(a, b)).length, glm::dot(a, b));
}

// Angles at all corners that have both normals. Where a surface has an edge of its own, or a pole, the corners of the
// mesh have no common normal and are left out: there the shape's normals at one point differ.
Errors angle_errors(const Setting& setting, const Frame&, const Setting&, const Frame&) {
  Errors out;
  double squares = 0;
  for (const Object& object : setting.scene.objects) {
    if (!object.visible || !object.mesh || !object.mesh->has_normals()) continue;
    const Shading& shading = setting.scene.shading;
    const std::vector<std::uint32_t> point = weld_positions(*object.mesh);
    const auto normals = corner_normals(*object.mesh, point, shading.normals, shading.crease_angle);
    const auto exact = corner_normals(*object.mesh, point, NormalRule::file, shading.crease_angle);
    const MeshData& data = object.mesh->data();
    std::vector<glm::dvec3> first(point.size(), glm::dvec3(0));
    std::vector<std::uint8_t> smooth(point.size(), 1);
    for (std::size_t c = 0; c < data.corners.size(); ++c) {
      const std::uint32_t p = point[data.corners[c].position];
      if (exact[c] == glm::dvec3(0)) smooth[p] = 0;
      if (first[p] == glm::dvec3(0)) first[p] = exact[c];
      if (angle(unit(first[p]), unit(exact[c])) > 1e-6) smooth[p] = 0;
    }
    for (std::size_t c = 0; c < data.corners.size(); ++c) {
      if (!smooth[point[data.corners[c].position]] || normals[c] == glm::dvec3(0)) continue;
      const double off = angle(normals[c], unit(exact[c]));
      squares += off * off;
      out.max = std::max(out.max, off);
      ++out.samples;
    }
  }
  if (out.samples) out.rmse = std::sqrt(squares / double(out.samples));
  return out;
}

constexpr Words why = {
    "Around a vertex whose neighbours lie symmetrically the errors of first order cancel, whatever the weights.",
    "隣の頂点が対称に並ぶ頂点では、重みによらず一次の誤差が打ち消し合う。"};
constexpr Words otherwise = {
    "At seams, borders and poles (the teapot's patches) the neighbours are not symmetric: h^1 at a share h of the "
    "vertices makes h^(3/2).",
    "継ぎ目、縁、極（ティーポットのパッチなど）では隣が対称でない。割合 h の頂点で h^1 となり、全体で h^(3/2) "
    "になる。"};
constexpr std::string_view source =
    "Dereck Meek and Desmond Walton, On surface normal and Gaussian curvature approximations given data sampled from a "
    "smooth surface, 2000; Nelson Max, Weights for Computing Vertex Normals from Facet Normals, 1999";

}  // namespace

Knob normals_knob() {
  Knob k;
  k.id = "normals";
  k.name = {"Rule for vertex normals", "頂点の法線の決め方"};
  k.help = {"The mean of the faces' normals, or weighted by area or by angle: how far from the curved surface's?",
            "面の法線の平均、面積の重み、角度の重み。曲面の法線からどれだけずれるか。"};
  k.parameter = "shading.normals";
  k.abscissa = {"h", {"edge of an average triangle", "三角形の平均の辺長"}, "m"};
  k.labels = {"level of tessellation", "細分割のレベル"};
  k.reference = {"the normal of the curved surface", "曲面そのものの法線"};
  k.error = {"RMS of the angle to the exact normal, over all corners", "正確な法線との角度の RMS（全頂点）"};
  k.error_unit = "rad";
  k.series = {{"mean", {"Mean of the faces", "面の平均"}},
              {"area", {"Weighted by area", "面積で重み付け"}},
              {"angle", {"Weighted by angle", "角度で重み付け"}}};
  for (std::size_t r = 0; r < std::size(rules); ++r)
    k.predictions.push_back(
        {.series = r, .order = 2, .law = "h^2", .why = why, .otherwise = otherwise, .source = source});
  k.bend_low = {"there the few vertices without symmetric neighbours (seams, where the order is h^1) dominate.",
                "隣が対称でないわずかな頂点（継ぎ目、そこでは h^1）の誤差が支配する。"};
  k.bend_high = {"there the surface bends by a large angle from one face to the next.",
                 "隣り合う面の角度が大きすぎる。"};
  k.ladder = ladder;
  k.draw = compute_normals;
  k.errors = angle_errors;
  return k;
}

}  // namespace cg
