#include "gl/shader_source.h"

#include <algorithm>
#include <cassert>

#include "embedded_glsl.h"

namespace cg {

bool ShaderFeatures::has(std::string_view name) const { return std::find(on.begin(), on.end(), name) != on.end(); }

std::string ShaderFeatures::text() const {
  std::string out = lights == 0 ? "no light" : std::to_string(lights) + (lights == 1 ? " light" : " lights");
  for (const std::string_view name : on) out += " " + std::string(name);
  return out;
}

ShaderFeatures shader_features(const Shading& shading, const Plan& plan, const EyeLighting<float>& lighting,
                               const EyeMaterial<float>& material, bool radiosity) {
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
  // and what these need.
  add(ambient || parts.diffuse || highlights || parts.emission, "MATERIAL");
  add(ambient, "K_A");
  add(f.lights > 0, "LIT");
  add(normal, "NORMAL");
  add(normal && normalize, "NORMALIZE");
  add(normal || plan.runs("normals"), "VERTEX_NORMAL");
  add(parts.point || local_viewer, "EYE_POSITION");
  add(normal || attenuation || spot, "DIRECTION");
  add(attenuation || spot, "SCALED");
  add((normal && normalize) || parts.point || half_vector || local_viewer, "UNIT");
  return f;
}

std::vector<const char*> part_ids(const ShaderFeatures& f) {
  constexpr std::pair<const char*, const char*> parts[] = {
      {"EMISSION", "emission"},     {"AMBIENT", "ambient"},
      {"LIGHT_AMBIENT", "ambient"}, {"DIFFUSE", "diffuse"},
      {"SPECULAR", "highlights"},   {"LOCAL_VIEWER", "local-viewer"},
      {"POINT", "point-lights"},    {"ATTENUATION", "attenuation"},
      {"SPOT", "spot-cones"},       {"TWO_SIDED", "two-sides"},
      {"CLAMP", "clamp"},
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
  // Light is computed in one of the two; the other one's text has no light model.
  if (!features.has("PHONG")) return {head + light + vertex, head + fragment};
  ShaderFeatures unlit;  // what a vertex needs for its normal
  if (features.has("NORMALIZE")) unlit.on.push_back("UNIT");
  return {head + specialise(vec_glsl, unlit) + vertex, head + light + fragment};
}

}  // namespace cg
