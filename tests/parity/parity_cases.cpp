#include "tests/parity/parity_cases.h"

#include <algorithm>

#include "gl/techniques.h"
#include "image/image_file.h"
#include "raster/software.h"
#include "scene/model_file.h"
#include "scene/shape.h"

namespace cg::parity {

namespace {

Object object_of(MeshHandle mesh, const Transform& fit) {
  Object o;
  o.mesh = std::move(mesh);
  o.transform = fit;
  return o;
}

void add_folder(const std::filesystem::path& folder, std::vector<Model>& models) {
  if (!std::filesystem::is_directory(folder)) return;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".obj") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) models.push_back(file_model(file));
}

Light light_of(LightKind kind) {
  Light light;
  light.kind = kind;
  light.position = {3, 4, 5};
  light.ambient = {0.05, 0.05, 0.1};
  light.diffuse = {1, 0.95, 0.9};
  if (kind == LightKind::directional) return light;
  light.k_0 = 0.3, light.k_1 = 0.1, light.k_2 = 0.02;
  if (kind == LightKind::spot) {
    light.position = {1.5, 2, 2.5};
    light.direction = {-1.5, -2, -2.4};
    light.cutoff = 14;
    light.exponent = 12;
  }
  return light;
}

// Pixels with a channel that differs by more.
std::size_t beyond(const Difference& d, float error) {
  const auto& pixels = d.error.pixels();
  return std::size_t(std::count_if(pixels.begin(), pixels.end(), [&](const glm::vec3& e) {
    return std::max({std::abs(e.r), std::abs(e.g), std::abs(e.b)}) > error;
  }));
}

}  // namespace

Model shape_model(const std::string& id) { return {id, {object_of(make_shape(*find_shape(id)), {})}}; }

Model file_model(const std::filesystem::path& file) {
  Model out{file.stem().string(), {}};
  const cg::Model model = read_model(file);
  glm::dvec3 low(1e300), high(-1e300);
  for (const ModelPart& part : model.parts)
    low = glm::min(low, part.mesh->low()), high = glm::max(high, part.mesh->high());
  const double radius = std::max(glm::length(high - low) / 2, 1e-300);
  Transform fit;
  fit.scale = glm::dvec3(1 / radius);
  fit.translate = -(low + high) / (2 * radius);
  for (const ModelPart& part : model.parts) {
    Object o = object_of(part.mesh, fit);
    if (part.material) o.own_material = true, o.material = *part.material;
    out.objects.push_back(o);
  }
  return out;
}

std::vector<Model> all_models() {
  std::vector<Model> models;
  for (const Shape& shape : shapes()) models.push_back(shape_model(std::string(shape.id)));
  const std::filesystem::path source = SHADEBENCH_SOURCE_DIR;
  add_folder(source / "models", models);
  add_folder(source / ".." / "shared" / "data" / "models", models);
  return models;
}

std::vector<Setting> all_settings() {
  std::vector<Setting> settings;
  for (int camera = 0; camera < 3; ++camera)
    for (const LightKind light : {LightKind::directional, LightKind::point, LightKind::spot})
      for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
        for (const Reflection reflection : {Reflection::half_vector, Reflection::reflection_vector})
          settings.push_back({camera, light, mode, reflection});
  return settings;
}

std::string name_of(const Setting& s) {
  std::string name = "camera" + std::to_string(s.camera);
  name += ' ' + std::string(names_of<LightKind>[std::size_t(s.light)].id);
  name += ' ' + std::string(names_of<ShadingMode>[std::size_t(s.mode)].id);
  name += ' ' + std::string(names_of<Reflection>[std::size_t(s.reflection)].id);
  return name;
}

Scene scene_of(const Model& model, const Setting& setting) {
  Scene scene;
  scene.objects = model.objects;
  scene.material.k_d = {0.7, 0.5, 0.3};
  scene.lights = {light_of(setting.light)};
  scene.shading.mode = setting.mode;
  scene.shading.reflection = setting.reflection;
  if (setting.camera == 1) {
    scene.camera.position = {0.7, 0.5, 1.1};
    scene.shading.local_viewer = true;
  } else if (setting.camera == 2) {
    scene.camera.position = {-2, 1.7, 2.2};
    scene.camera.projection = Projection::orthographic;
    scene.shading.two_sided = true;
    for (Object& o : scene.objects) {
      o.transform.scale.x *= -1;
      o.transform.translate.x *= -1;
    }
  }
  return scene;
}

Comparison::Comparison() : software_(software_technique()), gl_(gl_techniques()) {
  for (Technique& t : gl_) {
    find_availability(t);
    if (t.unavailable) throw InputError(t.id, *t.unavailable, Words{"", ""});
  }
}

Frame Comparison::draw(const Technique& technique, const Scene& scene) const {
  Progress progress;
  const View view{size, size};
  return technique.render(scene, technique.plan(scene, view), view, progress);
}

std::vector<std::size_t> Comparison::cone_edge(const Scene& scene) const {
  std::vector<std::size_t> pixels;
  Scene narrow = scene, wide = scene;
  bool spot = false;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    if (scene.lights[i].kind != LightKind::spot || scene.lights[i].cutoff > 89) continue;
    spot = true;
    narrow.lights[i].cutoff -= 1e-4;
    wide.lights[i].cutoff += 1e-4;
  }
  if (!spot) return pixels;
  const Frame a = draw(software_, narrow), b = draw(software_, wide);
  for (std::size_t i = 0; i < a.colour.size(); ++i)
    if (glm::distance(a.colour.pixels()[i], b.colour.pixels()[i]) > 1.0f / 255) pixels.push_back(i);
  return pixels;
}

std::vector<Result> Comparison::compare(const Scene& scene, const std::string& what,
                                        const std::filesystem::path& pictures) {
  std::vector<Result> results;
  const std::vector<std::size_t> left_out = cone_edge(scene);
  for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
    Scene in_precision = scene;
    in_precision.shading.precision = precision;
    const Frame ours = draw(software_, in_precision);
    for (const Technique& technique : gl_) {
      if (technique.unsupported(scene)) continue;
      Frame theirs = draw(technique, scene);
      for (const std::size_t i : left_out) theirs.colour.pixels()[i] = ours.colour.pixels()[i];
      const Difference d = difference(theirs.colour, ours.colour, theirs.covered, ours.covered, scene.display);
      Result r{what + ' ' + technique.id + ' ' + std::string(names_of<Precision>[std::size_t(precision)].id),
               d.coverage_mismatch,
               d.covered,
               d.over_1_255,
               d.max_error,
               left_out.size(),
               beyond(d, 3.0f / 255)};
      if (!r.passes() && !pictures.empty()) {
        std::string name = r.what;
        std::replace(name.begin(), name.end(), ' ', '_');
        std::filesystem::create_directories(pictures);
        write_image(pictures / (name + ".png"), absolute_picture(d, 32));
      }
      results.push_back(std::move(r));
    }
  }
  return results;
}

}  // namespace cg::parity
