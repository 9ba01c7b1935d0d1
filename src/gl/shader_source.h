// The shaders of one scene, specialised: what its plan leaves out is not in their text.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "gl/draw_list.h"
#include "gl/layer_source.h"

namespace cg {

// The names that #ifdef and #ifndef in src/gl/glsl and src/shading/glsl ask for.
struct ShaderFeatures {
  std::vector<std::string_view> on;  // static strings
  int lights = 0;
  std::vector<LayerUse> layers = {};  // in their order: the program's uniform `layers`, and its texture units

  bool has(std::string_view name) const;
  // All of them, as a plan shows them: "2 lights POINT NORMAL".
  std::string text() const;
  friend bool operator<(const ShaderFeatures& a, const ShaderFeatures& b) {
    if (a.lights != b.lights) return a.lights < b.lights;
    return a.on != b.on ? a.on < b.on : a.layers < b.layers;
  }
};

// Those of `layers` that change something of what `plan` draws of an object with such a (changeable) material.
std::vector<LayerUse> used_layers(const std::vector<LayerUse>& layers, const LightParts& parts, const Plan& plan);

// What the shaders need for one object of a scene: nothing that `plan` leaves out. `material`: with what layers may
// make of it (changeable()). `radiosity`: its vertices bring light of a radiosity solution.
ShaderFeatures shader_features(const Shading& shading, const Plan& plan, const EyeLighting<float>& lighting,
                               const EyeMaterial<float>& material, bool radiosity = false,
                               const std::vector<LayerUse>& layers = {});
// The ids of the plan's parts that are in such a shader.
std::vector<const char*> part_ids(const ShaderFeatures& features);

// Resolves the #ifdef, #ifndef, #else and #endif lines of `source`; what is not on is gone.
std::string specialise(std::string_view source, const ShaderFeatures& features);

struct ShaderSource {
  std::string vertex, fragment;
};
ShaderSource surface_shaders(const ShaderFeatures& features);

}  // namespace cg
