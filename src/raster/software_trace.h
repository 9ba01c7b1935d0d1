// What the software pipeline holds, and which parts of the light model it runs, written down for Frame::passes.
#pragma once
#include "raster/deferred_shading.h"
#include "scene/pass_recorder.h"

namespace cg {

// The surfaces, each once; `kept`: a picture before had the same.
void record_surfaces(const Drawing& drawing, bool kept, PassRecorder& record);

// The parts of the light model that some object's light is made of.
template <class Real>
void record_parts(const Drawing& drawing, const DeferredShading<Real>& shading, PassRecorder& record);

// The layers of textures that are read, with their pictures and uv.
template <class Real>
void record_layers(const Drawing& drawing, const DeferredShading<Real>& shading, PassRecorder& record);

// The marks of the visible triangles and vertices; those of clipped triangles belong to the clipping.
template <class Real>
void record_marks(const Drawing& drawing, const DeferredShading<Real>& shading, PassRecorder& record);

// What the pixels need of the vertices.
template <class Real>
void record_vertices(const DeferredShading<Real>& shading, PassRecorder& record);

}  // namespace cg
