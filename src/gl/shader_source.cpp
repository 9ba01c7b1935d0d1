#include "gl/shader_source.h"

#include <algorithm>
#include <cassert>

#include "embedded_glsl.h"

namespace cg {

bool ShaderFeatures::has(std::string_view name) const { return std::find(on.begin(), on.end(), name) != on.end(); }

ShaderFeatures shader_features(const Shading& shading, const Plan& plan, const EyeLighting<double>& lighting,
                               const EyeMaterial<double>& material) {
  const UsedTerms used = used_terms(lighting, material);
  ShaderFeatures f;
  f.lights = int(lighting.lights.size());
  auto add = [&](bool wanted, std::string_view name) {
    if (wanted) f.on.push_back(name);
  };
  const bool highlights = used.specular && plan.runs("highlights");
  const bool normal = used.diffuse || highlights;
  add(f.lights > 0, "LIT");
  add(normal, "NORMAL");
  add(normal && shading.normal_length == NormalLength::normalize, "NORMALIZE");
  add(highlights, "SPECULAR");
  add(highlights && shading.reflection == Reflection::half_vector, "HALF_VECTOR");
  add(highlights && shading.reflection == Reflection::reflection_vector, "REFLECTION_VECTOR");
  const bool local_viewer = highlights && plan.runs("local-viewer");
  add(local_viewer, "LOCAL_VIEWER");
  add(used.point, "POINT");
  add(used.point && used.directional, "MIXED");
  add(used.point || local_viewer, "EYE_POSITION");
  add(used.attenuation && plan.runs("attenuation"), "ATTENUATION");
  add(used.spot && plan.runs("spot-cones"), "SPOT");
  add(normal && plan.runs("two-sides"), "TWO_SIDED");
  add(plan.runs("clamp"), "CLAMP");
  add(plan.runs("pixel-lighting"), "PHONG");
  add(shading.mode == ShadingMode::flat, "FLAT");
  add(plan.runs("ids"), "IDS");
  add(plan.runs("normals"), "NORMALS");
  add(normal || plan.runs("normals"), "VERTEX_NORMAL");
  return f;
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
  const std::string vec = specialise(vec_glsl, features), light = specialise(light_model_glsl, features);
  const std::string vertex = specialise(surface_vert_glsl, features),
                    fragment = specialise(surface_frag_glsl, features);
  // Light is computed in one of the two; the other one's text has no light model.
  if (features.has("PHONG")) return {head + vec + vertex, head + vec + light + fragment};
  return {head + vec + light + vertex, head + fragment};
}

}  // namespace cg
