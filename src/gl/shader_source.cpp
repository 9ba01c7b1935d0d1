#include "gl/shader_source.h"

#include <algorithm>
#include <cassert>

#include "embedded_glsl.h"

namespace cg {

bool ShaderFeatures::has(std::string_view name) const { return std::find(on.begin(), on.end(), name) != on.end(); }

std::string ShaderFeatures::text() const {
  std::string out = lights == 0 ? "no light" : std::to_string(lights) + (lights == 1 ? " light" : " lights");
  for (const std::string_view name : on) out += " " + std::string(name);
  for (const LayerUse& layer : layers) out += " [" + layer.text() + "]";
  return out;
}

namespace {

bool counts(LayerTarget target, const LightParts& parts, const Plan& plan) {
  const bool highlights = parts.specular && plan.runs("highlights");
  switch (target) {
    case LayerTarget::k_a:
      return parts.ambient || parts.light_ambient;
    case LayerTarget::k_d:
      return parts.diffuse;
    case LayerTarget::k_s:
    case LayerTarget::n:
      return highlights;
    case LayerTarget::normal:
      return plan.runs("pixel-lighting") && (parts.diffuse || highlights);
    case LayerTarget::emission:
    case LayerTarget::colour:
    case LayerTarget::opacity:
      return true;
    case LayerTarget::k_r:
    case LayerTarget::k_t:
      return false;
  }
  return false;
}

// The names of what the features' layers need; returns whether one of them turns normals.
bool name_layers(const Plan& plan, ShaderFeatures& f) {
  constexpr std::string_view blends[] = {"REPLACE", "MODULATE", "DECAL", "BLEND", "ADD"};
  bool material = false, composed = false, heights = false, maps = false, used[5] = {};
  for (const LayerUse& l : f.layers) {
    const bool normal = l.target == LayerTarget::normal;
    heights = heights || (normal && l.bump == BumpKind::height), maps = maps || (normal && l.bump != BumpKind::height);
    composed = composed || !is_before_light(l.target);
    material = material || (!normal && is_before_light(l.target));
    if (!normal) used[int(l.blend)] = true;
  }
  const auto add = [&](bool wanted, std::string_view name) {
    if (wanted) f.on.push_back(name);
  };
  add(!f.layers.empty(), "TEXTURED");
  add(material, "LAYERED_MATERIAL");
  add(heights || maps, "NORMAL_LAYERS");
  add(heights, "HEIGHTS");
  add(maps, "NORMAL_MAP");
  add(composed, "COMPOSED");
  add(heights || (material && !plan.runs("pixel-lighting")), "LEVEL_ZERO");
  for (int i = 0; i < 5; ++i) add(used[i], blends[i]);
  add(composed && plan.runs("alpha-test"), "ALPHA_TEST");
  return heights || maps;
}

}  // namespace

std::vector<LayerUse> used_layers(const std::vector<LayerUse>& layers, const LightParts& parts, const Plan& plan) {
  std::vector<LayerUse> out;
  for (const LayerUse& l : layers)
    if (counts(l.target, parts, plan)) out.push_back(l);
  return out;
}

ShaderFeatures shader_features(const Shading& shading, const Plan& plan, const EyeLighting<float>& lighting,
                               const EyeMaterial<float>& material, bool radiosity,
                               const std::vector<LayerUse>& layers) {
  const LightParts parts = light_parts(lighting, material);
  ShaderFeatures f;
  for (const EyeLight<float>& light : lighting.lights) f.lights += light_parts(light, material).lit();
  auto add = [&](bool wanted, std::string_view name) {
    if (wanted) f.on.push_back(name);
    return wanted;
  };
  const bool highlights = parts.specular && plan.runs("highlights");
  const bool normal = parts.diffuse || highlights, normalize = shading.normal_length == NormalLength::normalize;
  const bool local_viewer = highlights && plan.runs("local-viewer"), ambient = parts.ambient || parts.light_ambient;
  const bool half_vector = highlights && shading.reflection == Reflection::half_vector;
  // The terms of the light model;
  add(parts.emission, "EMISSION");
  add(parts.ambient, "AMBIENT");
  add(radiosity && plan.runs("radiosity"), "RADIOSITY");
  add(parts.light_ambient, "LIGHT_AMBIENT");
  add(parts.diffuse, "DIFFUSE");
  add(highlights, "SPECULAR");
  add(half_vector, "HALF_VECTOR");
  add(highlights && !half_vector, "REFLECTION_VECTOR");
  add(local_viewer, "LOCAL_VIEWER");
  // the lights;
  add(parts.point, "POINT");
  add(parts.point && parts.directional, "MIXED");
  const bool attenuation = add(parts.attenuation && plan.runs("attenuation"), "ATTENUATION");
  const bool spot = add(parts.spot && plan.runs("spot-cones"), "SPOT");
  // where and how often;
  const bool phong = add(plan.runs("pixel-lighting"), "PHONG");
  add(!phong && shading.mode == ShadingMode::flat, "FLAT");
  add(normal && plan.runs("two-sides"), "TWO_SIDED");
  add(plan.runs("clamp"), "CLAMP");
  add(plan.runs("ids"), "IDS");
  add(plan.runs("normals"), "NORMALS");
  if (optional(!layers.empty())) f.layers = used_layers(layers, parts, plan);
  const bool bump = optional(!f.layers.empty()) && name_layers(plan, f);
  // and what these need.
  add(ambient || parts.diffuse || highlights || parts.emission, "MATERIAL");
  add(ambient, "K_A");
  add(f.lights > 0, "LIT");
  add(normal, "NORMAL");
  add(normal && normalize, "NORMALIZE");
  add(normal || plan.runs("normals"), "VERTEX_NORMAL");
  add(parts.point || local_viewer || bump, "EYE_POSITION");
  add(normal || attenuation || spot, "DIRECTION");
  add(attenuation || spot, "SCALED");
  add((normal && normalize) || parts.point || half_vector || local_viewer || bump, "UNIT");
  return f;
}

std::vector<const char*> part_ids(const ShaderFeatures& f) {
  constexpr std::pair<const char*, const char*> parts[] = {
      {"EMISSION", "emission"},     {"AMBIENT", "ambient"},
      {"LIGHT_AMBIENT", "ambient"}, {"DIFFUSE", "diffuse"},
      {"SPECULAR", "highlights"},   {"LOCAL_VIEWER", "local-viewer"},
      {"POINT", "point-lights"},    {"ATTENUATION", "attenuation"},
      {"SPOT", "spot-cones"},       {"TWO_SIDED", "two-sides"},
      {"CLAMP", "clamp"},           {"TEXTURED", "layers"},
      {"ALPHA_TEST", "alpha-test"},
  };
  std::vector<const char*> ids{f.has("PHONG") ? "pixel-lighting" : "vertex-lighting"};
  for (const auto& [feature, id] : parts)
    if (f.has(feature)) ids.push_back(id);
  return ids;
}

std::string specialise(std::string_view source, const ShaderFeatures& features) {
  std::string out;
  std::vector<bool> kept;  // of each #ifdef around the line: whether this branch is kept
  while (!source.empty()) {
    const std::size_t end = std::min(source.find('\n'), source.size() - 1);
    const std::string_view line = source.substr(0, end + 1);
    source.remove_prefix(end + 1);
    const std::string_view text = line.substr(0, line.find_last_not_of(" \n") + 1);
    if (text.starts_with("#ifdef ")) {
      kept.push_back(features.has(text.substr(7)));
    } else if (text.starts_with("#ifndef ")) {
      kept.push_back(!features.has(text.substr(8)));
    } else if (text == "#else") {
      assert(!kept.empty());
      kept.back() = !kept.back();
    } else if (text == "#endif") {
      assert(!kept.empty());
      kept.pop_back();
    } else if (std::all_of(kept.begin(), kept.end(), [](bool k) { return k; })) {
      out += line;
    }
  }
  assert(kept.empty());
  return out;
}

ShaderSource surface_shaders(const ShaderFeatures& features) {
  std::string head = "#version 330 core\n";
  if (features.lights > 0) head += "#define LIGHTS " + std::to_string(features.lights) + "\n";
  const std::string vertex = specialise(surface_vert_glsl, features),
                    fragment = specialise(surface_frag_glsl, features);
  const std::string light = specialise(vec_glsl, features) + specialise(light_model_glsl, features);
  const bool phong = features.has("PHONG");
  if (optional(!features.layers.empty())) head += "#define LAYERS " + std::to_string(features.layers.size()) + "\n";
  // Light is computed in one of the two; the other one's text has no light model.
  ShaderFeatures unlit;  // what a vertex needs for its normal
  if (phong && features.has("NORMALIZE")) unlit.on.push_back("UNIT");
  std::string before_vertex = phong ? specialise(vec_glsl, unlit) : light;
  std::string before_fragment = phong ? light : "";
  if (optional(!features.layers.empty())) {
    const std::string layers = specialise(layers_glsl, features),
                      lookup = features.has("LEVEL_ZERO") ? specialise(texture_lookup_glsl, features) : "";
    if (!phong && features.has("LAYERED_MATERIAL")) before_vertex += layers + lookup;
    before_vertex += vertex_layers(features.layers, phong);
    if (phong || features.has("COMPOSED")) before_fragment += layers;
    if (phong && features.has("NORMAL_LAYERS")) before_fragment += lookup + specialise(bump_glsl, features);
    before_fragment += fragment_layers(features.layers, phong);
  }
  return {head + before_vertex + vertex, head + before_fragment + fragment};
}

}  // namespace cg
