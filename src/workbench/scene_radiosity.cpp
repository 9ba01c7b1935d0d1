#include "workbench/scene_radiosity.h"

#include <algorithm>
#include <charconv>

#include "params/numbers.h"

namespace cg {

namespace {

Material reflection_of(const Material& material) {
  Material out;
  out.k_d = material.k_d, out.emission = material.emission;
  return out;
}

// With two digits that count.
std::string short_number(double v) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, v, std::chars_format::general, 2).ptr;
  return number_text(parse_number(std::string_view(text, end)).value_or(v));
}

}  // namespace

Scene radiosity_inputs(const Scene& scene) {
  Scene out;
  out.lights.clear();
  out.radiosity = scene.radiosity;
  for (const Object& object : scene.objects) {
    Object& o = out.objects.emplace_back();
    o.own_material = true;
    o.model = object.model, o.part = object.part, o.tessellation = object.tessellation;
    o.visible = object.visible, o.transform = object.transform, o.mesh = object.mesh;
    o.material = reflection_of(material_of(scene, object));
  }
  return out;
}

bool same_places(const Scene& a, const Scene& b) {
  const auto same = [](const Object& x, const Object& y) {
    return x.visible == y.visible && x.transform == y.transform && x.model == y.model && x.part == y.part &&
           x.tessellation == y.tessellation;
  };
  return a.objects.size() == b.objects.size() &&
         std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), same);
}

SceneRadiosity solve_scene(const Scene& scene, const SceneRadiosity& earlier, Progress& progress, int threads,
                           const MakeDrawItems& gl) {
  SceneRadiosity out;
  SolveOptions how;
  how.threads = threads;
  how.method = [&](const Patches& patches, const Radiosity& options) {
    return form_factor_method(patches, options, gl);
  };
  out.solution = solve_radiosity(scene, scene.radiosity, earlier.solution, progress, how);
  out.field = out.solution == earlier.solution ? earlier.field : drawable(scene, *out.solution);
  return out;
}

std::vector<Text> report_of(const RadiositySolution& s) {
  const auto seconds = [](double v) { return short_number(v) + " s"; };
  const RadiosityFigures& f = s.figures;
  std::vector<Text> lines = s.kept;
  const auto took = [&](double time, Words what) {
    if (time > 0)
      lines.push_back({std::string(what.en) + ": " + seconds(time), std::string(what.ja) + "：" + seconds(time)});
  };
  took(f.patches_s, {"patches", "パッチ分割"});
  took(f.form_factors_s, {"form factors", "形態係数"});
  took(f.solve_s, {"solving", "求解"});
  took(f.elements_s, {"elements", "要素"});
  lines.insert(lines.end(), s.notes.begin(), s.notes.end());
  return lines;
}

}  // namespace cg
