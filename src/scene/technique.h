// A way to draw a scene, as a value: software, OpenGL and, later, rays stand side by side in one list.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "scene/frame.h"
#include "scene/plan.h"
#include "scene/scene.h"

namespace cg {

struct Technique {
  std::string id;  // gl-fixed, gl, software, whitted, path, photon
  Words name;
  // Why it cannot work here at all (no legacy context), if that is known. OpenGL finds out when it first draws:
  // from then on `unsupported` says it for every scene.
  std::optional<Text> unavailable;
  // Why it cannot draw this scene (the fixed function has no Phong shading), if so.
  std::function<std::optional<Text>(const Scene&)> unsupported;
  std::function<Plan(const Scene&, const View&)> plan;
  // Renderer and version, as its driver calls them; "" where not known. Null: the processor. May make the context.
  std::function<std::string()> device;
  // The largest View::samples that it offers, at least 1. Null: it has no multisampling. May make the context.
  std::function<int()> most_samples;
  // Draws. May be called from any thread, one call at a time; throws Cancelled, or InputError where the scene
  // is not supported. Every object's mesh is loaded.
  std::function<Frame(const Scene&, const Plan&, const View&, Progress&)> render;
};

}  // namespace cg
