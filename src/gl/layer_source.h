// The part of the shaders that layers of textures make: one function a layer, and what calls them. The pieces that they
// are made of are shading/glsl/layers.glsl, texture_lookup.glsl and bump.glsl.
#pragma once
#include <compare>
#include <string>
#include <vector>

#include "shading/layer_uv.h"
#include "shading/light_model.h"

namespace cg {

// A layer as a program has it; its picture and its numbers come when it is drawn.
struct LayerUse {
  int layer = 0;  // into LayerUv::layers
  int uv = 0;     // into Surface::uv
  bool perspective = true;
  LayerTarget target = LayerTarget::colour;
  LayerBlend blend = LayerBlend::modulate;
  BumpKind bump = BumpKind::height;
  friend auto operator<=>(const LayerUse&, const LayerUse&) = default;
  // "k_d modulate uv0".
  std::string text() const;
};

std::vector<LayerUse> layer_uses(const LayerUv& layers);

// The declarations and functions of one of the two shaders. `phong`: light is computed in the fragment shader.
std::string vertex_layers(const std::vector<LayerUse>& layers, bool phong);
std::string fragment_layers(const std::vector<LayerUse>& layers, bool phong);

}  // namespace cg
