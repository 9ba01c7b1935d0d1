#include "raster/software_plan.h"

#include "raster/deferred_shading.h"
#include "shading/light_notes.h"
#include "shading/surface_cache.h"

namespace cg {

namespace {

// What the scene holds, counted for the plan.
struct Counts {
  std::size_t objects = 0, vertices = 0, triangles = 0, pixels = 0;
  std::size_t bad_normals = 0, unplaced = 0;  // unplaced: objects whose matrix is not finite in float
  bool crosses = false;                       // something reaches out of the view volume
};

// Does the box around the mesh reach out of the view volume, or nearly? Rounding must not decide, hence the margin.
bool reaches_out(const Mesh& mesh, const glm::dmat4& to_clip) {
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? mesh.high().x : mesh.low().x, corner & 2 ? mesh.high().y : mesh.low().y,
                       corner & 4 ? mesh.high().z : mesh.low().z);
    const glm::dvec4 c = to_clip * glm::dvec4(p, 1);
    const double largest = std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)});
    if (!(largest < c.w * (1 - 1e-3))) return true;
  }
  return false;
}

bool is_finite(const glm::mat4& m) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(m[c][r])) return false;
  return true;
}

Counts count(const Scene& scene, const View& view) {
  Counts n;
  n.pixels = std::size_t(std::max(view.width, 0)) * std::size_t(std::max(view.height, 0));
  if (n.pixels == 0) return n;
  const double aspect = double(view.width) / double(view.height);
  const glm::dmat4 to_clip = projection_matrix(scene.camera, aspect) * view_matrix(scene.camera);
  const glm::mat4 projection = eye_to_clip(scene, view.width, view.height);
  for (const Object& o : scene.objects) {
    if (!o.visible || !o.mesh) continue;
    const SurfaceHandle surface = surface_cache().get(o.mesh, normal_rule(scene.shading), scene.shading.crease_angle);
    ++n.objects;
    n.vertices += surface->positions.size();
    n.triangles += surface->triangle_count();
    n.bad_normals += surface->bad_normals;
    n.crosses = n.crosses || reaches_out(*o.mesh, to_clip * matrix(o.transform));
    if (!is_finite(surface_to_clip(projection, glm::mat4(surface_to_eye(scene, o, *surface))))) ++n.unplaced;
  }
  return n;
}

Pass pass(std::string id, Words name, bool needed, Text reason, std::size_t bytes) {
  return {std::move(id), name, needed, std::move(reason), needed ? bytes : 0};
}

Text counted(std::size_t n, std::string_view en, std::string_view ja) {
  return {std::to_string(n) + std::string(en), std::to_string(n) + std::string(ja)};
}

void add_geometry_passes(const Counts& n, bool draws, Plan& plan) {
  const Text nothing_to_draw{"there is nothing to draw", "描くものがない"};
  plan.passes.push_back(
      pass("transform", {"Transform", "座標変換"}, draws,
           draws ? counted(n.vertices, " vertices to window coordinates", " 頂点をウィンドウ座標へ") : nothing_to_draw,
           n.vertices * sizeof(WindowVertex)));
  const bool clips = draws && n.crosses;
  plan.passes.push_back(pass("clip", {"Clip", "クリッピング"}, clips,
                             clips ? Text{"something reaches out of the view volume", "視体積からはみ出すものがある"}
                             : draws ? Text{"everything lies inside the view volume", "すべて視体積の中にある"}
                                     : nothing_to_draw,
                             0));
  plan.passes.push_back(pass("visibility", {"Visibility (z-buffer)", "可視判定（z バッファ）"}, draws,
                             draws ? counted(n.triangles, " triangles, both faces", " 三角形の両面") : nothing_to_draw,
                             n.pixels * (sizeof(float) + sizeof(std::uint32_t))));
}

void add_lighting_passes(const Scene& scene, const Counts& n, bool draws, Plan& plan) {
  const ShadingMode mode = scene.shading.mode;
  const std::size_t vector = scene.shading.precision == Precision::double_precision ? sizeof(glm::dvec3)  //
                                                                                    : sizeof(glm::vec3);
  const std::size_t faces = scene.shading.two_sided ? 2 : 1;
  const auto in_mode = [&](ShadingMode m, Words name, Text reason) {
    const auto& names = names_of<ShadingMode>;
    const Words mode_name = names[std::size_t(mode)].label;
    (void)name;
    return !draws      ? Text{"there is nothing to draw", "描くものがない"}
           : mode == m ? reason
                       : Text{"shading is " + std::string(mode_name.en),
                              std::string(mode_name.ja) + "シェーディングなので不要"};
  };
  const Words face{"Light faces", "面の光源計算"}, vertex{"Light vertices", "頂点の光源計算"},
      pixel{"Light pixels", "画素の光源計算"};
  plan.passes.push_back(
      pass("face-lighting", face, draws && mode == ShadingMode::flat,
           in_mode(ShadingMode::flat, face,
                   {"once for each visible face, at its last vertex", "見える面ごとに 1 回、最後の頂点で"}),
           n.vertices * vector * faces));
  plan.passes.push_back(pass(
      "vertex-lighting", vertex, draws && mode == ShadingMode::gouraud,
      in_mode(ShadingMode::gouraud, vertex, {"once for each vertex of a visible face", "見える面の頂点ごとに 1 回"}),
      n.vertices * vector * faces));
  plan.passes.push_back(
      pass("pixel-lighting", pixel, draws && mode == ShadingMode::phong,
           in_mode(ShadingMode::phong, pixel, {"once for each visible pixel", "見える画素ごとに 1 回"}),
           n.vertices * vector * 2));
  const bool two = draws && scene.shading.two_sided;
  plan.passes.push_back(pass("two-sides", {"Second side", "裏面の光源計算"}, two,
                             two     ? Text{"back faces are lit with -N", "裏面は -N で照らす"}
                             : draws ? Text{"one-sided lighting", "片面の光源計算"}
                                     : Text{"there is nothing to draw", "描くものがない"},
                             0));
}

void add_notes(const Scene& scene, const Counts& n, Plan& plan) {
  if (n.unplaced > 0)
    plan.notes.push_back(counted(n.unplaced, " objects are too large or too far for the picture's numbers: left out",
                                 " 個の物体は大きすぎるか遠すぎて描けないので省く"));
  if (n.bad_normals > 0)
    plan.notes.push_back(counted(n.bad_normals, " vertices have no normal: no diffuse and no specular light there",
                                 " 頂点に法線がなく、拡散光も鏡面光も計算されない"));
  for (Text& note : light_notes(scene)) plan.notes.push_back(std::move(note));
  bool ray_traced = false;
  for (const Object& o : scene.objects) {
    const Material& m = material_of(scene, o);
    ray_traced = ray_traced || (o.visible && (m.k_r != glm::dvec3(0) || m.k_t != glm::dvec3(0)));
  }
  if (ray_traced)
    plan.notes.push_back(
        {"k_r I_r and k_t I_t need ray tracing: left out", "k_r I_r と k_t I_t はレイトレーシングが必要なので省く"});
}

}  // namespace

Plan software_plan(const Scene& scene, const View& view) {
  const Counts n = count(scene, view);
  const bool draws = n.pixels > 0 && n.triangles > 0;
  Plan plan;
  plan.technique = "software";
  add_geometry_passes(n, draws, plan);
  add_lighting_passes(scene, n, draws, plan);
  const auto on_demand = [&](std::string id, Words name, bool wanted, std::size_t bytes) {
    plan.passes.push_back(pass(std::move(id), name, draws && wanted,
                               wanted ? Text{"asked for", "求められた"} : Text{"not asked for", "求められていない"},
                               bytes));
  };
  on_demand("ids", {"Triangle and object numbers", "三角形と物体の番号"}, view.ids,
            n.pixels * 2 * sizeof(std::int32_t));
  on_demand("normals", {"Normals", "法線"}, view.normals, n.pixels * sizeof(glm::vec3));
  add_notes(scene, n, plan);
  return plan;
}

}  // namespace cg
