#include "measure/ladder_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include "params/input_error.h"
#include "workbench/technique_list.h"

namespace cg {

View view_of(const TradeRequest& request, int own) {
  View view;
  view.width = request.width > 0 ? request.width : own;
  view.height = request.height > 0 ? request.height : own;
  view.threads = request.threads;
  return view;
}

std::string technique_of(const TradeRequest& request, std::string_view own) {
  const std::string id(request.technique.empty() ? own : std::string_view(request.technique));
  require(find_technique(request.techniques, id), request.scene);
  return id;
}

Setting reference_of(Scene scene, View view) {
  Setting out;
  out.id = "reference";
  out.label = Words{"reference", "基準"};
  out.scene = std::move(scene);
  out.scene.shading.precision = Precision::double_precision;
  out.technique = "software";
  out.view = view;
  out.view.threads = int(std::max(1u, std::thread::hardware_concurrency()));
  return out;
}

void oversample(Setting& setting, const View& picture, int factor, Resampling filter) {
  setting.view = {picture.width * factor, picture.height * factor, setting.view.threads};
  setting.resampling = filter;
  setting.factor = factor;
}

double eye_depth(double d, const Camera& c) {
  if (c.projection == Projection::orthographic) return c.near_plane + d * (c.far_plane - c.near_plane);
  return c.near_plane * c.far_plane / (c.far_plane - d * (c.far_plane - c.near_plane));
}

double nearest_depth(const Scene& scene) {
  const glm::dmat4 to_eye = view_matrix(scene.camera);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Object& object : scene.objects) {
    if (!object.visible || !object.mesh) continue;
    const glm::dvec3 low = object.mesh->low(), high = object.mesh->high();
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec4 p(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z, 1);
      nearest = std::min(nearest, -(to_eye * matrix(object.transform) * p).z);
    }
  }
  if (scene.camera.projection != Projection::perspective || !(nearest > 0) || !std::isfinite(nearest))
    throw InputError(
        "SCENE", {"nothing stands wholly before an eye with perspective", "透視投影の視点の前に物体全体がない"},
        {"a shape with the usual camera works: teapot, torus-knot", "teapot や torus-knot を既定のカメラで使うとよい"});
  return nearest;
}

}  // namespace cg
