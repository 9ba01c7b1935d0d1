#include "shading/ambient_term.h"

#include <algorithm>
#include <mutex>

#include "shading/gl_calls.h"
#include "shading/surface_cache.h"

namespace cg {

namespace {

// One value a corner, each a number.
bool is_whole(const RadiosityField& field) {
  return std::all_of(field.objects.begin(), field.objects.end(), [](const ObjectRadiosity& o) {
    if (!o.mesh) return true;
    const auto finite = [](const glm::vec3& v) { return is_finite(v); };
    return o.corners.size() == o.mesh->data().corners.size() && std::all_of(o.corners.begin(), o.corners.end(), finite);
  });
}

// is_whole() of the solutions that were asked about last: a solution never changes, and its corners are many.
class WholeFields {
 public:
  bool get(const RadiosityHandle& field) {
    const std::lock_guard lock(mutex_);
    std::erase_if(known_, [](const auto& known) { return known.first.expired(); });
    for (const auto& [of, whole] : known_)
      if (of.lock() == field) return whole;
    if (known_.size() >= most) known_.erase(known_.begin());
    known_.emplace_back(field, is_whole(*field));
    return known_.back().second;
  }

 private:
  static constexpr std::size_t most = 8;
  std::mutex mutex_;
  std::vector<std::pair<std::weak_ptr<const RadiosityField>, bool>> known_;
};

bool is_whole(const RadiosityHandle& field) {
  static WholeFields known;
  return known.get(field);
}

bool is_of(const RadiosityField& field, const std::vector<Object>& objects) {
  const auto same = [](const ObjectRadiosity& f, const Object& o) {
    return !f.mesh || !f.of || o.mesh == f.of || o.mesh == f.mesh;
  };
  return field.objects.size() == objects.size() &&
         std::equal(field.objects.begin(), field.objects.end(), objects.begin(), same);
}

// The mistakes that the fixed function makes with colours leave no room for one more a vertex.
bool mistaken(const Scene& scene, DrawnBy by) {
  return by == DrawnBy::fixed_function && (lights_by_hand(scene.mistakes) || scene.mistakes.no_color_material);
}

}  // namespace

const RadiosityField* drawn_field(const Scene& scene, DrawnBy by) {
  if (scene.shading.ambient_source == AmbientSource::constant || !scene.radiosity_field) return nullptr;
  const bool drawn =
      !mistaken(scene, by) && is_of(*scene.radiosity_field, scene.objects) && is_whole(scene.radiosity_field);
  return drawn ? scene.radiosity_field.get() : nullptr;
}

AmbientReason ambient_reason(const Scene& scene, DrawnBy by) {
  if (scene.shading.ambient_source == AmbientSource::constant)
    return {false, Words{"the ambient term is constant", "環境光項は一定"}};
  const auto constant = [](Words why) {
    return AmbientReason{
        false,
        {std::string(why.en) + ": the constant ambient term is drawn", std::string(why.ja) + "：一定の環境光で描く"}};
  };
  const RadiosityHandle& field = scene.radiosity_field;
  if (!field) return constant({"no radiosity solution yet", "ラジオシティの解がまだない"});
  if (!is_of(*field, scene.objects))
    return constant({"the radiosity solution is of other shapes", "ラジオシティの解は今の形のものでない"});
  if (!is_whole(field))
    return constant({"the radiosity solution has numbers that are not finite", "ラジオシティの解に有限でない数がある"});
  if (mistaken(scene, by))
    return constant({"this mistake leaves no colour a vertex for radiosity", "この間違いでは頂点ごとの色を使えない"});
  const Text place =
      Words{"the light of other surfaces, in place of I_a k_a", "他の面からの光を I_a k_a の代わりにする"};
  if (field->summary.en.empty()) return {true, place};
  return {true, {place.en + ": " + field->summary.en, place.ja + "：" + field->summary.ja}};
}

MeshHandle drawn_mesh(const Scene& scene, std::size_t object, const RadiosityField* field) {
  return field && field->objects[object].mesh ? field->objects[object].mesh : scene.objects[object].mesh;
}

SurfaceHandle drawn_surface(const Scene& scene, std::size_t object, const RadiosityField* field) {
  const NormalRule rule = normal_rule(scene.shading);
  std::vector<UvSet> uv;
  if constexpr (!only_plain) uv = layer_uv(scene, object, field).sets;
  if (optional(field && field->objects[object].mesh))
    return surface_cache().get(scene.radiosity_field, object, rule, scene.shading.crease_angle, std::move(uv));
  return surface_cache().get(scene.objects[object].mesh, rule, scene.shading.crease_angle, std::move(uv));
}

Scene with_drawn_meshes(Scene scene) {
  if (const RadiosityField* field = drawn_field(scene))
    for (std::size_t i = 0; i < scene.objects.size(); ++i) scene.objects[i].mesh = drawn_mesh(scene, i, field);
  return scene;
}

}  // namespace cg
