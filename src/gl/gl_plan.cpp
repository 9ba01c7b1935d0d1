#include "gl/gl_plan.h"

#include <epoxy/gl.h>

#include "gl/draw_list.h"
#include "gl/fixed_extremes.h"
#include "gl/fixed_numbers.h"
#include "gl/fixed_player.h"
#include "gl/shader_source.h"
#include "gl/texture_objects.h"
#include "shading/fixed_function_scene.h"
#include "shading/plan_maker.h"

namespace cg {

namespace {

// What is drawn, and what it uses of the light model, as the shader or the fixed function is told it.
struct Counts : DrawnCounts {
  AmbientReason ambient;
  std::vector<DrawItem> items;
  std::size_t pixels = 0;
  EyeLighting<double> lighting;  // of the scene as it is given
};

Counts count(const Scene& scene, const View& view, DrawnBy by) {
  Counts n;
  n.ambient = ambient_reason(scene, by);
  n.pixels = std::size_t(std::max(view.width, 0)) * std::size_t(std::max(view.height, 0));
  n.lighting = lighting_in_eye_space<double>(scene, view_matrix(scene.camera));
  if (n.pixels == 0) return n;
  n.items = draw_list(scene, view, by);
  for (const DrawItem& item : n.items) n.add(item.surface);
  for (const Object& o : scene.objects) n.unplaced += o.visible && o.mesh && !o.mesh->triangles().empty();
  n.unplaced -= n.items.size();
  return n;
}

EyeMaterial<float> material_in(const Scene& scene, const DrawItem& item) {
  return drawn_material<float>(scene, scene.objects[std::size_t(item.object)], *item.surface);
}

// A vertex's light of a radiosity solution: in the surface, and in OpenGL's memory.
constexpr std::size_t a_lit_vertex = 2 * sizeof(glm::vec3);

void add_picture(const Counts& n, PlanMaker& p) {
  p.add({"picture", {"Picture", "画像"}, PassKind::resource, true}, n.pixels > 0,
        Words{"colour, depth and coverage of each pixel", "画素ごとの色、奥行き、被覆"},
        Words{"the picture has no pixels", "画素がない"},
        n.pixels * (sizeof(glm::vec3) + sizeof(float) + sizeof(std::uint8_t)));
  add_surfaces(n, p);
  p.add({"target", {"OpenGL's picture", "OpenGL の画像"}, PassKind::resource}, true,
        Words{"colour and depth as floats, off screen", "画面外の float の色と奥行き"}, {},
        n.pixels * (sizeof(glm::vec4) + sizeof(float)));
}

void add_uploads(const Counts& n, bool normals, Text no_normals, PlanMaker& p) {
  const std::size_t vertices = n.surface_vertices(), triangles = n.surface_triangles();
  p.add({"vertex-upload", {"Vertex buffers", "頂点バッファ"}}, true,
        counted(vertices, " positions and the indices, kept in OpenGL's memory",
                " 個の位置とインデックスを OpenGL のメモリーに置く"),
        {}, vertices * sizeof(glm::vec3) + triangles * 3 * sizeof(std::uint32_t));
  p.add({"normal-buffers", {"Normal buffers", "法線バッファ"}, PassKind::resource}, normals,
        counted(vertices, " normals, kept in OpenGL's memory", " 個の法線を OpenGL のメモリーに置く"),
        std::move(no_normals), vertices * sizeof(glm::vec3));
}

void add_read_back(const Counts& n, PlanMaker& p) {
  p.add({"read-back", {"Read back", "読み戻し"}}, true,
        Words{"colour and depth come back from OpenGL as floats", "色と奥行きを OpenGL から float で受け取る"}, {},
        n.pixels * sizeof(glm::vec4));
}

// `a_pixel` and `more`: what they hold where something is drawn, beside the frame's own layer.
void add_on_demand(const char* id, Words name, bool wanted, Text why, const Counts& n, std::size_t frame_pixel,
                   std::size_t a_pixel, std::size_t more, PlanMaker& p) {
  const std::size_t drawn = p.draws() ? n.pixels * a_pixel + more : 0;
  p.add({id, name, PassKind::pass, true}, wanted && n.pixels > 0, std::move(why), asked_for(wanted),
        n.pixels * frame_pixel + drawn);
}

// The pictures of the layers that are drawn, each once, and what holds their uv.
struct TextureCounts {
  std::size_t layers = 0, pictures = 0, picture_bytes = 0, uv_sets = 0, uv_bytes = 0;
  bool tests_alpha = false;  // where Shading::transparency asks for it
};

// `layers_of`: those of an item, one a texture unit. `copies`: each layer has a texture of its own.
template <class LayersOf>
TextureCounts count_textures(const Counts& n, bool copies, const LayersOf& layers_of) {
  TextureCounts t;
  std::vector<std::tuple<const TextureImage*, int, Stored>> pictures;
  for (const DrawItem& item : n.items)
    for (const TextureLayer* layer : layers_of(item)) {
      ++t.layers;
      t.tests_alpha = t.tests_alpha || !is_before_light(layer->target);
      const std::tuple picture(layer->texture.get(), copies ? int(layer - item.material->layers.data()) : 0,
                               stored_for(*layer));
      if (std::find(pictures.begin(), pictures.end(), picture) != pictures.end()) continue;
      pictures.push_back(picture);
      t.picture_bytes += texture_bytes(*layer->texture, stored_for(*layer));
    }
  t.pictures = pictures.size();
  for (const Surface* s : n.surfaces)
    for (const auto& set : s->uv) ++t.uv_sets, t.uv_bytes += 2 * set.size() * sizeof(glm::vec2);
  return t;
}

// Of the shaders: what changes something, given the parts of the light model that are in the plan already.
TextureCounts count_textures(const Scene& scene, const Counts& n, const Plan& plan) {
  const auto lighting = lighting_in_eye_space<float>(scene, view_matrix(scene.camera));
  return count_textures(n, false, [&](const DrawItem& item) {
    const LayerUv layers = drawn_layers(scene, item);
    const EyeMaterial<float> material = changeable(material_in(scene, item), layers.layers);
    std::vector<const TextureLayer*> out;
    for (const LayerUse& use : used_layers(layer_uses(layers), light_parts(lighting, material), plan))
      out.push_back(layers.layers[std::size_t(use.layer)]);
    return out;
  });
}

constexpr Words no_textures{"no material that is drawn has a texture", "描く素材にテクスチャがない"};

void add_texture_uploads(const TextureCounts& t, PlanMaker& p) {
  p.add({"uv", {"uv of the vertices", "頂点の uv"}, PassKind::resource}, t.uv_sets > 0,
        counted(t.uv_sets,
                t.uv_sets == 1 ? " set, in the surfaces and in OpenGL's memory"
                               : " sets, in the surfaces and in OpenGL's memory",
                " 組を面と OpenGL のメモリーに置く"),
        no_textures, t.uv_bytes);
  p.add({"texture-upload", {"Textures", "テクスチャ"}}, t.pictures > 0,
        counted(t.pictures,
                t.pictures == 1 ? " picture with its mipmaps, kept in OpenGL's memory"
                                : " pictures with their mipmaps, kept in OpenGL's memory",
                " 枚の画像とミップマップを OpenGL のメモリーに置く"),
        no_textures, t.picture_bytes);
}

void add_texture_parts(const Scene& scene, const TextureCounts& t, PlanMaker& p) {
  const Transparency transparency = scene.shading.transparency;
  if (t.layers > 0 && (transparency == Transparency::blend || transparency == Transparency::sorted_blend))
    p.note(Words{"blending is not drawn by this technique: everything is opaque",
                 "この描画方法は半透明の合成を描けないので、すべて不透明とする"});
  p.add({"layers", {"Layers of textures", "テクスチャのレイヤー"}, PassKind::part}, t.layers > 0,
        counted(t.layers, t.layers == 1 ? " layer, read where it is used" : " layers, each read where it is used",
                " 枚を、使う所で読む"),
        no_textures);
  p.add({"alpha-test", {"Alpha test", "アルファテスト"}, PassKind::part},
        t.tests_alpha && scene.shading.transparency == Transparency::test,
        Words{"pixels whose alpha is not above the threshold are holes", "アルファがしきい値以下の画素は穴になる"},
        t.layers == 0 ? no_textures
        : scene.shading.transparency == Transparency::test
            ? Words{"no texture of a colour or of opacity", "色や不透明度のテクスチャがない"}
            : Words{"switched off", "オフ"});
}

constexpr Words ids_name{"Triangle numbers", "三角形の番号"}, normals_name{"Normals", "法線"};
constexpr Words nothing_depends_on_n{"nothing depends on N", "N に依存する項がない"};
constexpr std::size_t id_pixel = 2 * sizeof(std::int32_t), normal_pixel = sizeof(glm::vec3);

// What the shaders of all objects use together.
void add_programs(const Scene& scene, Counts& n, const Plan& plan, PlanMaker& p) {
  const auto lighting = lighting_in_eye_space<float>(scene, view_matrix(scene.camera));
  for (const DrawItem& item : n.items)
    n.parts |= light_parts(lighting, changeable(material_in(scene, item), drawn_layers(scene, item).layers));
  const bool phong = scene.shading.mode == ShadingMode::phong;
  p.add({"compile", {"Compile shaders", "シェーダーのコンパイル"}}, true, Text{}, {});
  p.add({"vertex-lighting", {"Light vertices", "頂点の光源計算"}, PassKind::part}, !phong,
        scene.shading.mode == ShadingMode::flat
            ? Words{"in the vertex shader; a face takes its last vertex's colour",
                    "頂点シェーダーで計算し、面は最後の頂点の色になる"}
            : Words{"in the vertex shader; colours are interpolated", "頂点シェーダーで計算し、色を補間する"},
        Words{"shading is Phong", "フォンシェーディングなので不要"});
  p.add({"pixel-lighting", {"Light pixels", "画素の光源計算"}, PassKind::part}, phong,
        Words{"in the fragment shader, also where it is hidden later",
              "フラグメントシェーダーで計算し、後で隠れる画素も含む"},
        Words{"shading is not Phong", "フォンシェーディングでないので不要"});
  add_light_parts(scene, n, n.ambient, p, a_lit_vertex);
  add_texture_parts(scene, count_textures(scene, n, plan), p);
}

// What the shaders are made of follows from the plan so far.
void name_programs(const Scene& scene, const Counts& n, Plan& plan) {
  const auto lighting = lighting_in_eye_space<float>(scene, view_matrix(scene.camera));
  for (const DrawItem& item : n.items) {
    const bool radiosity = !item.surface->radiosity.empty();
    const LayerUv layers = drawn_layers(scene, item);
    const EyeMaterial<float> material = changeable(material_in(scene, item), layers.layers);
    std::string text = shader_features(scene.shading, plan, lighting, material, radiosity, layer_uses(layers)).text();
    if (std::find(plan.code.begin(), plan.code.end(), text) == plan.code.end()) plan.code.push_back(std::move(text));
  }
  for (Pass& pass : plan.passes)
    if (pass.id == "compile" && pass.needed)
      pass.reason = counted(plan.code.size(),
                            plan.code.size() == 1 ? " program, with what the scene uses and no more"
                                                  : " programs, with what the scene uses and no more",
                            " 個のプログラム。シーンが使うものだけを含む");
}

}  // namespace

Plan gl_plan(const Scene& scene, const View& view) {
  Counts n = count(scene, view, DrawnBy::light_model);
  Plan plan;
  plan.technique = "gl";
  PlanMaker p(plan, n.triangles > 0);
  add_picture(n, p);
  const bool one_sample = view.ids || view.normals;
  p.add({"samples", {"Several samples a pixel", "1 画素に複数の標本"}, PassKind::resource},
        view.samples > 1 && !one_sample,
        counted(std::size_t(std::max(view.samples, 1)), " colours and depths a pixel, resolved to their mean",
                " 組の色と奥行きを画素ごとに持ち、平均する"),
        view.samples > 1 ? Text(Words{"numbers and normals have no mean", "番号と法線は平均できない"})
                         : Text(Words{"one sample a pixel", "1 画素に 1 標本"}),
        n.pixels * (sizeof(glm::vec4) + sizeof(float)) * std::size_t(std::max(view.samples, 1)));
  add_programs(scene, n, plan, p);
  add_uploads(n, n.parts.normal() || view.normals, nothing_depends_on_n, p);
  add_texture_uploads(count_textures(scene, n, plan), p);
  p.add({"draw", {"Draw", "描画"}}, true,
        counted(n.triangles, " triangles: transform, light, rasterise in one go",
                " 三角形の座標変換、光源計算、ラスタライズを一度に"));
  add_read_back(n, p);
  // Its layer in OpenGL, and the pixels between OpenGL and the frame.
  add_on_demand("ids", ids_name, view.ids, asked_for(true), n, id_pixel, 2 * sizeof(glm::ivec2), 0, p);
  add_on_demand("normals", normals_name, view.normals, asked_for(true), n, normal_pixel, 2 * sizeof(glm::vec4), 0, p);
  name_programs(scene, n, plan);
  add_general_notes(scene, n, n.ambient, p);
  return plan;
}

Plan gl_fixed_plan(const Scene& scene, const View& view) {
  Counts n = count(scene, view, DrawnBy::fixed_function);
  const Scene told = as_fixed_function(with_mistaken_lights(scene));
  const auto lighting = lighting_in_eye_space<double>(told, view_matrix(told.camera));
  const bool listed = lights_as_listed(scene, n.lighting, n.items);
  for (const DrawItem& item : n.items) {
    const double unit =
        listed ? 1 : eye_unit(glm::dmat4(item.surface_to_eye), item.surface->radius, scene.shading.normal_length);
    n.parts |= light_parts(lighting_as_sent(lighting, listed, unit), material_in(told, item));
    const Object& object = scene.objects[std::size_t(item.object)];
    n.parts.emission =
        n.parts.emission || is_emission_of_nan(drawn_material<double>(scene, object, *item.surface), n.lighting);
  }
  const MeshBody body = mesh_body(gl_calls(scene));
  const bool flipped = body.normals == MeshBody::Normals::flipped;
  Plan plan;
  plan.technique = "gl-fixed";
  PlanMaker p(plan, n.triangles > 0);
  add_picture(n, p);
  const bool as_given = body.normals == MeshBody::Normals::given && !body.by_hand;
  add_uploads(n, as_given && n.parts.normal(),
              as_given ? Text(nothing_depends_on_n)
                       : Text(Words{"the mesh's normals are not sent as they are", "メッシュの法線をそのまま送らない"}),
              p);
  const TextureCounts textures =
      count_textures(n, true, [&](const DrawItem& item) { return fixed_function_layers(scene, item.object); });
  add_texture_uploads(textures, p);
  std::size_t largest = 0, largest_triangles = 0;
  for (const Surface* s : n.surfaces) {
    largest = std::max(largest, s->positions.size());
    largest_triangles = std::max(largest_triangles, s->triangle_count());
  }
  p.add({"by-hand", {"Vertices by hand", "手作業の頂点"}}, body.by_hand || flipped,
        body.by_hand ? Words{"the program's own light model colours each vertex", "自作の光源計算で頂点に色をつける"}
                     : Words{"the mistake turns each normal round", "間違いで法線を裏返す"},
        Words{"OpenGL gets the mesh as it is", "メッシュをそのまま OpenGL に渡す"}, largest * sizeof(glm::vec3));
  p.add({"vertex-lighting", {"Light vertices", "頂点の光源計算"}, PassKind::part}, !body.by_hand,
        Words{"glLight, glMaterial and glLightModel, once for each vertex",
              "glLight、glMaterial、glLightModel で頂点ごとに 1 回"},
        Words{"GL_LIGHTING is off", "GL_LIGHTING がオフ"});
  p.add({"pixel-lighting", {"Light pixels", "画素の光源計算"}, PassKind::part}, false, {},
        Words{"the fixed function lights vertices only", "固定機能は頂点だけを照らす"});
  add_light_parts(told, n, n.ambient, p, a_lit_vertex);
  add_texture_parts(scene, textures, p);
  p.add({"color-material", {"Colour material", "カラーマテリアル"}, PassKind::part},
        n.parts.radiosity || told.shading.color_material != ColorMaterial::off,
        n.parts.radiosity
            ? Words{"the emission follows glColor, one colour a vertex", "発光が頂点ごとの glColor に従う"}
            : Words{"reflectances follow glColor", "反射率が glColor に従う"},
        Words{"glColor does nothing under lighting", "光源計算中の glColor は効かない"});
  p.add({"draw", {"Draw", "描画"}}, true,
        counted(n.triangles, " triangles: transform, light, rasterise in one go",
                " 三角形の座標変換、光源計算、ラスタライズを一度に"));
  add_read_back(n, p);
  const Words again{"asked for: drawn once more without light", "求められた：光源なしでもう一度描く"};
  // The colours that numbers and normals are drawn as, and the pixels between OpenGL and the frame.
  add_on_demand("ids", ids_name, view.ids, again, n, id_pixel, sizeof(glm::vec4) + sizeof(glm::ivec2),
                numbered_bytes(largest_triangles), p);
  add_on_demand("normals", normals_name, view.normals, again, n, normal_pixel, sizeof(glm::vec4),
                largest * sizeof(glm::vec3), p);
  add_general_notes(scene, n, n.ambient, p);
  for (Text& note : fixed_function_notes(scene, n.lighting, n.items)) p.note(std::move(note));
  return plan;
}

namespace {

std::optional<Text> layers_unsupported(const Scene& scene, std::size_t object) {
  if (material_of(scene, scene.objects[object]).layers.empty()) return std::nullopt;
  const LayerUv uv = layer_uv(scene, object, drawn_field(scene, DrawnBy::fixed_function));
  for (const TextureLayer* l : uv.layers) {
    if (l->target != LayerTarget::colour)
      return Text(Words{"OpenGL's fixed function puts textures on the lit colour only, not on terms of the light model",
                        "OpenGL の固定機能のテクスチャは照らした後の色にだけ使え、照明モデルの項には使えない"});
    if (l->amount != 1 || l->scale != 1)
      return Text(Words{"OpenGL's texture environment has no amount and no scale of a texture",
                        "OpenGL のテクスチャ環境には、テクスチャの量と倍率の指定がない"});
    if (!l->perspective)
      return Text(Words{"OpenGL's texture coordinates are perspective-correct always",
                        "OpenGL のテクスチャ座標は常に透視補正される"});
  }
  if (uv.layers.size() > std::size_t(gl_texture_unit_limit))
    return Text(Words{"OpenGL's fixed function has 8 texture units: no more than 8 layers",
                      "OpenGL の固定機能のテクスチャユニットは 8 個なので、レイヤーは 8 つまで"});
  return std::nullopt;
}

}  // namespace

std::optional<Text> unsupported_by_fixed_function(const Scene& scene) {
  if (scene.shading.mode == ShadingMode::phong)
    return Text(Words{"OpenGL's fixed function has no Phong shading: it lights vertices only",
                      "OpenGL の固定機能は頂点だけを照らすので、フォンシェーディングはできない"});
  if (scene.shading.reflection == Reflection::reflection_vector)
    return Text(Words{"OpenGL's fixed function has no (R·V)^n, only (N·H)^n",
                      "OpenGL の固定機能には (R·V)^n がなく、(N·H)^n だけがある"});
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].visible)
      if (auto why = layers_unsupported(scene, i)) return why;
  return std::nullopt;
}

}  // namespace cg
