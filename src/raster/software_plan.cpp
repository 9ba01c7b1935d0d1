#include "raster/software_plan.h"

#include "raster/deferred_shading.h"
#include "shading/layer_uv.h"
#include "shading/plan_maker.h"

namespace cg {

namespace {

struct Counts : DrawnCounts {
  AmbientReason ambient;
  std::size_t pixels = 0;
  bool crosses = false;  // something reaches out of the view volume
  std::size_t layers = 0, picture_bytes = 0;
  std::vector<const TextureImage*> pictures;  // each once
  bool bumps = false;                         // some object's light depends on a picture's normals
  bool tests_alpha = false;

  void add(const Scene& scene, std::size_t object, const RadiosityField* field, const LayerUv& uv);
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

void Counts::add(const Scene& scene, std::size_t object, const RadiosityField* field, const LayerUv& uv) {
  tests_alpha = tests_alpha || cg::tests_alpha(scene, object, field);
  for (const TextureLayer* layer : uv.layers) {
    ++layers;
    if (std::find(pictures.begin(), pictures.end(), layer->texture.get()) != pictures.end()) continue;
    pictures.push_back(layer->texture.get());
    picture_bytes += layer->texture->bytes();
  }
}

template <class Real>
Counts count(const Scene& scene, const View& view) {
  Counts n;
  n.ambient = ambient_reason(scene);
  n.pixels = std::size_t(std::max(view.width, 0)) * std::size_t(std::max(view.height, 0));
  if (n.pixels == 0) return n;
  const double aspect = double(view.width) / double(view.height);
  const glm::dmat4 world_to_eye = view_matrix(scene.camera);
  const glm::dmat4 to_clip = projection_matrix(scene.camera, aspect) * world_to_eye;
  const glm::mat4 projection = eye_to_clip(scene, view.width, view.height);
  const auto lighting = lighting_in_eye_space<Real>(scene, world_to_eye);
  const RadiosityField* field = drawn_field(scene);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& o = scene.objects[i];
    if (!o.visible || !o.mesh) continue;
    const SurfaceHandle surface = drawn_surface(scene, i, field);
    if (surface->triangle_count() == 0) continue;
    const glm::mat4 to_eye(surface_to_eye(scene, o, *surface));
    if (!can_be_placed(to_eye, surface_to_clip(projection, to_eye))) {
      ++n.unplaced;
      continue;
    }
    n.DrawnCounts::add(surface);
    const LayerUv uv = layer_uv(scene, i, field);
    n.add(scene, i, field, uv);
    const LightParts parts = light_parts(lighting, changeable(drawn_material<Real>(scene, o, *surface), uv.layers));
    n.parts |= parts;
    for (const TextureLayer* layer : uv.layers)
      n.bumps = n.bumps || (layer->target == LayerTarget::normal && parts.normal());
    n.crosses = n.crosses || reaches_out(*drawn_mesh(scene, i, field), to_clip * matrix(o.transform));
  }
  return n;
}

void add_geometry_passes(const View& view, const Counts& n, PlanMaker& p) {
  p.add({"transform", {"Transform", "座標変換"}}, true,
        counted(n.vertices, " vertices to window coordinates", " 頂点をウィンドウ座標へ"), {},
        n.vertices * sizeof(WindowVertex));
  Pass& clip = p.add({"clip", {"Clip", "クリッピング"}}, n.crosses,
                     Words{"something reaches out of the view volume", "視体積からはみ出すものがある"},
                     Words{"everything lies inside the view volume", "すべて視体積の中にある"});
  clip.bytes_open = clip.needed;
  p.add({"visibility", {"Visibility (z-buffer)", "可視判定（z バッファ）"}}, true,
        counted(n.triangles, " triangles, both faces", " 三角形の両面"), {},
        VisibilityBuffer::bytes(view.width, view.height));
  const bool apart = draws_triangles_apart(n.triangles, view.width, view.height, view.threads);
  Pass& bands = p.add({"bands", {"Threads' shares", "スレッドの分担"}, PassKind::resource}, view.threads > 1,
                      apart ? Words{"each thread draws triangles of its own into a picture of its own",
                                    "スレッドごとに別の三角形を別の画像に描き、最後に重ねる"}
                            : Words{"each thread draws rows of its own", "スレッドごとに別の行を描く"},
                      Words{"one thread draws everything", "1 つのスレッドがすべてを描く"},
                      apart ? std::size_t(view.threads - 1) * VisibilityBuffer::bytes(view.width, view.height) : 0);
  bands.bytes_open = bands.needed && !apart;
}

void add_lighting_passes(const Scene& scene, const Counts& n, PlanMaker& p) {
  const Shading& s = scene.shading;
  const std::size_t vector = s.precision == Precision::double_precision ? sizeof(glm::dvec3) : sizeof(glm::vec3);
  const Words mode = names_of<ShadingMode>[std::size_t(s.mode)].label;
  const Text other{"shading is " + std::string(mode.en), std::string(mode.ja) + "シェーディングなので不要"};
  const bool flat = s.mode == ShadingMode::flat, gouraud = s.mode == ShadingMode::gouraud,
             phong = s.mode == ShadingMode::phong;
  p.add({"mark-visible", {"Mark what is visible", "見える頂点の印づけ"}}, true,
        Words{"only vertices of visible faces are lit", "見える面の頂点だけを照らす"}, {}, n.triangles + n.vertices);
  p.add({"face-lighting", {"Light faces", "面の光源計算"}}, flat,
        Words{"once for each visible face, at its last vertex", "見える面ごとに 1 回、最後の頂点で"}, other,
        n.vertices * vector);
  p.add({"vertex-lighting", {"Light vertices", "頂点の光源計算"}}, gouraud,
        Words{"once for each vertex of a visible face", "見える面の頂点ごとに 1 回"}, other, n.vertices * vector);
  p.add({"interpolation", {"Fill with colour", "色の塗りつぶし"}}, !phong,
        flat ? Words{"each face has one colour", "面ごとに 1 色"}
             : Words{"the vertices' colours, interpolated", "頂点の色を補間する"},
        other);
  const bool position = n.parts.position(s.local_viewer) || n.bumps, normal = n.parts.normal();
  p.add({"vertex-to-eye", {"To eye space", "視点座標へ"}}, phong && (position || normal),
        position && normal ? Words{"the light depends on P and N", "光源計算が P と N に依存する"}
        : normal ? Words{"the light depends on N, not on P", "光源計算は N に依存し、P には依存しない"}
                 : Words{"the light depends on P, not on N", "光源計算は P に依存し、N には依存しない"},
        phong ? Text(Words{"the light depends neither on P nor on N", "光源計算が P にも N にも依存しない"}) : other,
        n.vertices * vector * (std::size_t(position) + std::size_t(normal)));
  p.add({"pixel-lighting", {"Light pixels", "画素の光源計算"}}, phong,
        Words{"once for each visible pixel", "見える画素ごとに 1 回"}, other);
}

void add_layers(const Scene& scene, const Counts& n, PlanMaker& p) {
  constexpr Words none{"no material that is drawn has a texture", "描く素材にテクスチャがない"};
  std::size_t uv_bytes = 0;
  for (const Surface* s : n.surfaces) uv_bytes += s->uv_bytes();
  p.add({"uv", {"uv of the vertices", "頂点の uv"}, PassKind::resource}, n.layers > 0,
        Words{"where each vertex lies in the pictures", "各頂点が画像のどこに当たるか"}, none, uv_bytes);
  p.add({"textures", {"Textures", "テクスチャ"}, PassKind::resource}, n.layers > 0,
        counted(n.pictures.size(), " pictures with their mipmaps", " 枚の画像とミップマップ"), none, n.picture_bytes);
  p.add({"layers", {"Layers of textures", "テクスチャのレイヤー"}, PassKind::part}, n.layers > 0,
        counted(n.layers, " layers, each read where it is used", " 枚のレイヤーを、使う所で読む"), none);
  p.add({"alpha-test", {"Alpha test", "アルファテスト"}}, n.tests_alpha,
        Words{"pixels whose alpha is not above the threshold are holes", "アルファがしきい値以下の画素は穴になる"},
        n.layers == 0 ? none
        : scene.shading.transparency == Transparency::test
            ? Words{"no texture of a colour or of opacity", "色や不透明度のテクスチャがない"}
            : Words{"switched off", "オフ"});
}

void add_layer_notes(const Scene& scene, const Counts& n, PlanMaker& p) {
  const Transparency t = scene.shading.transparency;
  if (n.layers > 0 && (t == Transparency::blend || t == Transparency::sorted_blend))
    p.note(Words{"blending is not drawn by this technique: everything is opaque",
                 "この描画方法は半透明の合成を描けないので、すべて不透明とする"});
}

// The other side's colours and marks stand beside the front's.
void add_second_side(const Scene& scene, const Counts& n, Plan& plan) {
  const std::size_t vector =
      scene.shading.precision == Precision::double_precision ? sizeof(glm::dvec3) : sizeof(glm::vec3);
  for (Pass& pass : plan.passes)
    if (pass.id == "two-sides" && pass.needed)
      pass.bytes = n.vertices * (1 + (scene.shading.mode == ShadingMode::phong ? 0 : vector));
}

}  // namespace

Plan software_plan(const Scene& scene, const View& view) {
  const Counts n =
      scene.shading.precision == Precision::double_precision ? count<double>(scene, view) : count<float>(scene, view);
  Plan plan;
  plan.technique = "software";
  PlanMaker p(plan, n.pixels > 0 && n.triangles > 0);
  p.add({"picture", {"Picture", "画像"}, PassKind::resource, true}, n.pixels > 0,
        Words{"colour, depth and coverage of each pixel", "画素ごとの色、奥行き、被覆"},
        Words{"the picture has no pixels", "画素がない"},
        n.pixels * (sizeof(glm::vec3) + sizeof(float) + sizeof(std::uint8_t)));
  add_surfaces(n, p);
  add_geometry_passes(view, n, p);
  add_lighting_passes(scene, n, p);
  add_light_parts(scene, n, n.ambient, p);
  add_second_side(scene, n, plan);
  add_layers(scene, n, p);
  const auto on_demand = [&](const char* id, Words name, bool wanted, std::size_t bytes) {
    p.add({id, name, PassKind::pass, true}, wanted && n.pixels > 0, asked_for(true), asked_for(wanted), bytes);
  };
  on_demand("ids", {"Triangle numbers", "三角形の番号"}, view.ids, n.pixels * 2 * sizeof(std::int32_t));
  on_demand("normals", {"Normals", "法線"}, view.normals, n.pixels * sizeof(glm::vec3));
  add_general_notes(scene, n, n.ambient, p);
  add_layer_notes(scene, n, p);
  return plan;
}

}  // namespace cg
