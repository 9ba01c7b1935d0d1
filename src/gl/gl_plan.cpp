#include "gl/gl_plan.h"

#include <epoxy/gl.h>

#include "gl/draw_list.h"
#include "gl/fixed_extremes.h"
#include "shading/light_notes.h"

namespace cg {

namespace {

// What the scene holds, and what it uses.
struct Counts {
  std::vector<DrawItem> items;
  std::size_t vertices = 0, triangles = 0, pixels = 0, bad_normals = 0, unplaced = 0;
  EyeLighting<double> lighting;
  UsedTerms used;
  bool draws = false;
};

Counts count(const Scene& scene, const View& view) {
  Counts n;
  n.pixels = std::size_t(std::max(view.width, 0)) * std::size_t(std::max(view.height, 0));
  n.lighting = lighting_in_eye_space<double>(scene, view_matrix(scene.camera));
  if (n.pixels == 0) return n;
  n.items = draw_list(scene, view);
  for (const DrawItem& item : n.items) {
    n.vertices += item.surface->positions.size();
    n.triangles += item.surface->triangle_count();
    n.bad_normals += item.surface->bad_normals;
  }
  n.used = used_terms(scene);
  n.draws = n.triangles > 0;
  return n;
}

Text counted(std::size_t n, const char* en, const char* ja) { return {std::to_string(n) + en, std::to_string(n) + ja}; }

class PlanMaker {
 public:
  PlanMaker(const Counts& n, Plan& plan) : n_(n), plan_(plan) {}
  // `why` where it runs, `why_not` where it does not; nothing runs where there is nothing to draw.
  void pass(const char* id, Words name, bool needed, Text why, Text why_not, std::size_t bytes = 0) {
    needed = needed && n_.draws;
    const Text empty = Words{"there is nothing to draw", "描くものがない"};
    plan_.passes.push_back({id, name, needed,
                            needed     ? std::move(why)
                            : n_.draws ? std::move(why_not)
                                       : empty,
                            needed ? bytes : 0});
  }
  void note(Text text) {
    std::vector<Text>& notes = plan_.notes;
    if (std::find(notes.begin(), notes.end(), text) == notes.end()) notes.push_back(std::move(text));
  }

 private:
  const Counts& n_;
  Plan& plan_;
};

void upload_pass(const Counts& n, PlanMaker& p) {
  const std::size_t bytes = n.vertices * 2 * sizeof(glm::vec3) + n.triangles * 3 * sizeof(std::uint32_t);
  p.pass("vertex-upload", {"Vertex buffers", "頂点バッファ"}, true,
         counted(n.vertices, " vertices, kept in OpenGL's memory", " 頂点を OpenGL のメモリーに置く"), {}, bytes);
}

// The parts of the light model that a scene may do without.
void term_passes(const Scene& scene, const Counts& n, PlanMaker& p) {
  const Shading& s = scene.shading;
  p.pass("highlights", {"Highlights", "ハイライト"}, n.used.specular,
         Words{"a material and a light have a specular colour", "鏡面反射のある素材と光源がある"},
         Words{"k_s or the lights' specular colours are 0", "k_s か光源の鏡面光成分が 0"});
  p.pass("local-viewer", {"Local viewer", "視点の位置"}, s.local_viewer && n.used.specular,
         Words{"V points from each point to the eye", "V は各点から視点へ向く"},
         s.local_viewer ? Text(Words{"only highlights use V", "V を使うのはハイライトだけ"})
                        : Text(Words{"V is the same for all points", "V はどの点でも同じ"}));
  p.pass("attenuation", {"Attenuation", "減衰"}, n.used.attenuation,
         Words{"a light fades with the distance", "距離で弱まる光源がある"},
         Words{"no light fades with the distance", "距離で弱まる光源がない"});
  p.pass("spot-cones", {"Spot cones", "スポットの円錐"}, n.used.spot,
         Words{"a light has a cone", "円錐を持つ光源がある"}, Words{"no light has a cone", "円錐を持つ光源がない"});
  p.pass("two-sides", {"Second side", "裏面の光源計算"}, s.two_sided && n.used.normal(),
         Words{"back faces are lit with -N", "裏面は -N で照らす"},
         s.two_sided ? Text(Words{"nothing depends on N", "N に依存する項がない"})
                     : Text(Words{"one-sided lighting", "片面の光源計算"}));
  p.pass("clamp", {"Clamp to 0..1", "0..1 に制限"}, s.clamp,
         s.mode == ShadingMode::phong ? Text(Words{"each pixel's colour is limited", "画素の色を制限する"})
                                      : Text(Words{"each vertex's colour is limited", "頂点の色を制限する"}),
         Words{"switched off", "オフ"});
}

Text asked(bool wanted) {
  return wanted ? Text(Words{"asked for", "求められた"}) : Text(Words{"not asked for", "求められていない"});
}

void output_passes(const Counts& n, const View& view, bool fixed, PlanMaker& p) {
  const std::size_t id_bytes = fixed ? sizeof(glm::vec4) : sizeof(glm::ivec2);
  p.pass("ids", {"Triangle and object numbers", "三角形と物体の番号"}, view.ids,
         fixed ? Text(Words{"asked for: drawn once more without light", "求められた：光源なしでもう一度描く"})
               : asked(true),
         asked(false), n.pixels * id_bytes);
  p.pass("normals", {"Normals", "法線"}, view.normals,
         fixed ? Text(Words{"asked for: drawn once more without light", "求められた：光源なしでもう一度描く"})
               : asked(true),
         asked(false), n.pixels * sizeof(glm::vec4));
  p.pass("read-back", {"Read back", "読み戻し"}, true,
         Words{"colour and depth come back from OpenGL as floats", "色と奥行きを OpenGL から float で受け取る"}, {},
         n.pixels * (sizeof(glm::vec4) + sizeof(float)));
}

void general_notes(const Scene& scene, const Counts& n, PlanMaker& p) {
  std::size_t loaded = 0;
  bool ray_traced = false;
  for (const Object& o : scene.objects) {
    if (!o.visible) continue;
    const Material& m = material_of(scene, o);
    ray_traced = ray_traced || m.k_r != glm::dvec3(0) || m.k_t != glm::dvec3(0);
    loaded += o.mesh && !o.mesh->triangles().empty();
  }
  if (n.draws && loaded > n.items.size())
    p.note(counted(loaded - n.items.size(), " objects are too large or too far for the picture's numbers: left out",
                   " 個の物体は大きすぎるか遠すぎて描けないので省く"));
  if (n.bad_normals > 0)
    p.note(counted(n.bad_normals, " vertices have no normal: no diffuse and no specular light there",
                   " 頂点に法線がなく、拡散光も鏡面光も計算されない"));
  for (Text& note : light_notes(scene)) p.note(std::move(note));
  if (ray_traced) p.note(needs_rays_note);
}

}  // namespace

Plan gl_plan(const Scene& scene, const View& view) {
  const Counts n = count(scene, view);
  const bool phong = scene.shading.mode == ShadingMode::phong;
  Plan plan;
  plan.technique = "gl";
  PlanMaker p(n, plan);
  upload_pass(n, p);
  p.pass("vertex-lighting", {"Light vertices", "頂点の光源計算"}, !phong,
         scene.shading.mode == ShadingMode::flat
             ? Text(Words{"in the vertex shader; a face takes its last vertex's colour",
                          "頂点シェーダーで計算し、面は最後の頂点の色になる"})
             : Text(Words{"in the vertex shader; colours are interpolated", "頂点シェーダーで計算し、色を補間する"}),
         Words{"shading is Phong", "フォンシェーディングなので不要"});
  p.pass("pixel-lighting", {"Light pixels", "画素の光源計算"}, phong,
         Words{"in the fragment shader, also where it is hidden later",
               "フラグメントシェーダーで計算し、後で隠れる画素も含む"},
         Words{"shading is not Phong", "フォンシェーディングでないので不要"});
  term_passes(scene, n, p);
  output_passes(n, view, false, p);
  general_notes(scene, n, p);
  return plan;
}

Plan gl_fixed_plan(const Scene& scene, const View& view) {
  const Counts n = count(scene, view);
  Plan plan;
  plan.technique = "gl-fixed";
  PlanMaker p(n, plan);
  upload_pass(n, p);
  p.pass("vertex-lighting", {"Light vertices", "頂点の光源計算"}, true,
         Words{"glLight, glMaterial and glLightModel, once for each vertex",
               "glLight、glMaterial、glLightModel で頂点ごとに 1 回"},
         {});
  p.pass("pixel-lighting", {"Light pixels", "画素の光源計算"}, false, {},
         Words{"the fixed function lights vertices only", "固定機能は頂点だけを照らす"});
  term_passes(scene, n, p);
  p.pass("color-material", {"Colour material", "カラーマテリアル"}, scene.shading.color_material != ColorMaterial::off,
         Words{"reflectances follow glColor", "反射率が glColor に従う"},
         Words{"glColor does nothing under lighting", "光源計算中の glColor は効かない"});
  output_passes(n, view, true, p);
  general_notes(scene, n, p);
  for (Text& note : fixed_function_notes(scene, n.lighting, n.items)) p.note(std::move(note));
  return plan;
}

std::optional<Text> unsupported_by_fixed_function(const Scene& scene) {
  if (scene.shading.mode == ShadingMode::phong)
    return Text(Words{"OpenGL's fixed function has no Phong shading: it lights vertices only",
                      "OpenGL の固定機能は頂点だけを照らすので、フォンシェーディングはできない"});
  if (scene.shading.reflection == Reflection::reflection_vector)
    return Text(Words{"OpenGL's fixed function has no (R·V)^n, only (N·H)^n",
                      "OpenGL の固定機能には (R·V)^n がなく、(N·H)^n だけがある"});
  return std::nullopt;
}

}  // namespace cg
