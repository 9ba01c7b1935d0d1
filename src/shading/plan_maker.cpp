#include "shading/plan_maker.h"

#include <algorithm>

#include "shading/layer_uv.h"
#include "shading/light_notes.h"

namespace cg {

void DrawnCounts::add(const SurfaceHandle& surface) {
  ++objects;
  vertices += surface->positions.size();
  triangles += surface->triangle_count();
  bad_normals += surface->bad_normals;
  if (std::find(surfaces.begin(), surfaces.end(), surface.get()) != surfaces.end()) return;
  surfaces.push_back(surface.get());
  lit_vertices += surface->radiosity.size();
  parts.radiosity = parts.radiosity || !surface->radiosity.empty();
}

std::size_t DrawnCounts::surface_vertices() const {
  std::size_t n = 0;
  for (const Surface* s : surfaces) n += s->positions.size();
  return n;
}

std::size_t DrawnCounts::surface_triangles() const {
  std::size_t n = 0;
  for (const Surface* s : surfaces) n += s->triangle_count();
  return n;
}

Pass& PlanMaker::add(const Line& line, bool needed, Text why, Text why_not, std::size_t bytes) {
  const Text empty = Words{"there is nothing to draw", "描くものがない"};
  const bool possible = draws_ || line.always;
  needed = needed && possible;
  Text reason = needed ? std::move(why) : possible ? std::move(why_not) : empty;
  plan_.passes.push_back({line.id, line.name, needed, std::move(reason), needed ? bytes : 0, false, line.kind});
  return plan_.passes.back();
}

void PlanMaker::note(Text text) {
  std::vector<Text>& notes = plan_.notes;
  if (std::find(notes.begin(), notes.end(), text) == notes.end()) notes.push_back(std::move(text));
}

Text counted(std::size_t n, std::string_view en, std::string_view ja) {
  return {std::to_string(n) + std::string(en), std::to_string(n) + std::string(ja)};
}

Text asked_for(bool wanted) {
  return wanted ? Text(Words{"asked for", "求められた"}) : Text(Words{"not asked for", "求められていない"});
}

void add_surfaces(const DrawnCounts& n, PlanMaker& p) {
  // Positions, normals; three indices a triangle, and the triangle's number in its mesh.
  const std::size_t bytes =
      n.surface_vertices() * 2 * sizeof(glm::vec3) + n.surface_triangles() * 4 * sizeof(std::uint32_t);
  p.add({"surfaces", {"Surfaces with normals", "法線つきの面"}, PassKind::resource}, true,
        Words{"made from the meshes once for each rule for normals", "メッシュから法線の決め方ごとに 1 回作る"}, {},
        bytes);
}

void add_light_parts(const Scene& scene, const DrawnCounts& n, const AmbientReason& ambient, PlanMaker& p,
                     std::size_t a_lit_vertex) {
  const Shading& s = scene.shading;
  const LightParts& parts = n.parts;
  const auto part = [&](const char* id, Words name, bool needed, Words why, Words why_not) {
    p.add({id, name, PassKind::part}, needed, why, why_not);
  };
  part("emission", {"Emission", "発光"}, parts.emission, {"a material emits light", "発光する素材がある"},
       {"no material emits light", "発光する素材がない"});
  part("ambient", {"Ambient term", "環境光の項"}, parts.ambient || parts.light_ambient,
       {"k_a and an ambient light are not 0", "k_a と環境光が 0 でない"},
       parts.radiosity ? Words{"the radiosity solution stands in for it", "ラジオシティの解が代わりになる"}
                       : Words{"k_a or the ambient lights are 0", "k_a か環境光が 0"});
  const Text no_part = Words{"no object that is drawn takes part in the solution", "解に加わる物体が描かれていない"};
  p.add({"radiosity", {"Radiosity of the vertices", "頂点のラジオシティ"}, PassKind::part}, parts.radiosity,
        ambient.text, ambient.drawn ? no_part : ambient.text, n.lit_vertices * a_lit_vertex);
  part("diffuse", {"Diffuse term", "拡散反射の項"}, parts.diffuse,
       {"a material and a light have a diffuse colour", "拡散反射のある素材と光源がある"},
       {"k_d or the lights' diffuse colours are 0", "k_d か光源の拡散光成分が 0"});
  part("highlights", {"Highlights", "ハイライト"}, parts.specular,
       {"a material and a light have a specular colour", "鏡面反射のある素材と光源がある"},
       {"k_s or the lights' specular colours are 0", "k_s か光源の鏡面光成分が 0"});
  part("local-viewer", {"Local viewer", "視点の位置"}, s.local_viewer && parts.specular,
       {"V points from each point to the eye", "V は各点から視点へ向く"},
       s.local_viewer ? Words{"only highlights use V", "V を使うのはハイライトだけ"}
                      : Words{"V is the same for all points", "V はどの点でも同じ"});
  part("point-lights", {"Point lights", "点光源"}, parts.point, {"L differs from point to point", "L が点ごとに異なる"},
       {"L is the same for all points", "L はどの点でも同じ"});
  part("attenuation", {"Attenuation", "減衰"}, parts.attenuation,
       {"a light fades with the distance", "距離で弱まる光源がある"},
       {"no light fades with the distance", "距離で弱まる光源がない"});
  part("spot-cones", {"Spot cones", "スポットの円錐"}, parts.spot, {"a light has a cone", "円錐を持つ光源がある"},
       {"no light has a cone", "円錐を持つ光源がない"});
  part("two-sides", {"Second side", "裏面の光源計算"}, s.two_sided && parts.normal(),
       {"back faces are lit with -N", "裏面は -N で照らす"},
       s.two_sided ? Words{"nothing depends on N", "N に依存する項がない"}
                   : Words{"one-sided lighting", "片面の光源計算"});
  part("clamp", {"Clamp to 0..1", "0..1 に制限"}, s.clamp,
       s.mode == ShadingMode::phong ? Words{"each pixel's colour is limited", "画素の色を制限する"}
                                    : Words{"each vertex's colour is limited", "頂点の色を制限する"},
       {"switched off", "オフ"});
}

std::vector<const char*> part_ids(const LightParts& parts, bool local_viewer, bool two_sided, bool clamp) {
  std::vector<const char*> ids;
  const auto add = [&](bool used, const char* id) {
    if (used) ids.push_back(id);
  };
  add(parts.emission, "emission");
  add(parts.ambient || parts.light_ambient, "ambient");
  add(parts.diffuse, "diffuse");
  add(parts.specular, "highlights");
  add(local_viewer, "local-viewer");
  add(parts.point, "point-lights");
  add(parts.attenuation, "attenuation");
  add(parts.spot, "spot-cones");
  add(two_sided, "two-sides");
  add(clamp, "clamp");
  return ids;
}

void add_general_notes(const Scene& scene, const DrawnCounts& n, const AmbientReason& ambient, PlanMaker& p) {
  if (scene.shading.ambient_source == AmbientSource::radiosity && !ambient.drawn) p.note(ambient.text);
  if (n.unplaced > 0)
    p.note(counted(n.unplaced, " objects are too large or too far for the picture's numbers: left out",
                   " 個の物体は大きすぎるか遠すぎて描けないので省く"));
  if (n.bad_normals > 0)
    p.note(counted(n.bad_normals, " vertices have no normal: no diffuse and no specular light there",
                   " 頂点に法線がなく、拡散光も鏡面光も計算されない"));
  for (Text& note : light_notes(scene)) p.note(std::move(note));
  bool ray_traced = false;
  for (const Object& o : scene.objects) {
    const Material& m = material_of(scene, o);
    ray_traced = ray_traced || (o.visible && (m.k_r != glm::dvec3(0) || m.k_t != glm::dvec3(0)));
  }
  if (ray_traced) p.note(needs_rays_note);
  for (Text& note : layer_notes(scene, drawn_field(scene))) p.note(std::move(note));
}

}  // namespace cg
