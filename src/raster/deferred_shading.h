// Light for what the visibility buffer found: of the vertices only those of visible triangles are lit.
// This work is based on: Christopher Burns and Warren Hunt, The Visibility Buffer, 2013.
#pragma once
#include "raster/visibility.h"
#include "shading/eye_normal.h"
#include "shading/layers.h"
#include "shading/light_batch.h"

namespace cg {

// A vertex of a visible triangle, ready for the pixels. Gouraud and flat shading need its colours, Phong shading
// its point and normal in eye space, as far as its light does. The other lists hold no memory.
template <class Real>
struct ShadedVertices {
  std::vector<Vec3<Real>> front, back;              // the colours of the two faces; `back` only where two sides are lit
  std::vector<Vec3<Real>> P, N;                     // in eye space; N is unit where the scene normalises
  std::vector<std::uint8_t> front_seen, back_seen;  // 1: of a front face, of a back face; the latter as `back`
};

// A layer of textures that an object is drawn with.
template <class Real>
struct ShadedLayer {
  const TextureLayer* layer;
  std::size_t set;  // of Surface::uv
  TextureTransform<Real> transform;
  const Image<glm::u8vec4>*
      plain;  // its picture where eight texels can be read at once (raster/texel_lanes.h), or null
};

// What of an object the light model needs.
template <class Real>
struct ObjectShading {
  LightBatch<Real> light;  // where layers change the material: what it may become
  NormalTransform<Real> normals;
  EyeMaterial<Real> material;
  // In the order in which they are applied: what is given to the light, what is made of its colour, and, where alpha is
  // tested, what makes alpha.
  std::vector<ShadedLayer<Real>> before_light, after_light, opacity;
  ShadedVertices<Real> vertices;
};

template <class Real>
struct DeferredShading {
  ShadingMode mode;
  EyeLighting<Real> lighting;
  bool uses_position, uses_normal;           // whether the light on some object depends on P, on N
  bool uses_layers;                          // whether some object has layers of textures
  bool uses_radiosity;                       // whether some object's vertices bring light of a radiosity solution
  std::vector<ObjectShading<Real>> objects;  // as in Drawing
  std::vector<std::uint8_t> seen;            // 1 for each triangle that a pixel shows, by Drawing's numbers
};

// Marks the vertices that the visible triangles need: all three, or with flat shading the provoking one.
template <class Real>
void mark_visible_vertices(const Drawing& drawing, const VisibilityBuffer& visibility, Workers& workers,
                           DeferredShading<Real>& shading);

// Brings the marked vertices to eye space, as far as the light needs it, and, but for Phong shading, lights them.
template <class Real>
void shade_vertices(const Drawing& drawing, Workers& workers, DeferredShading<Real>& shading);

}  // namespace cg
