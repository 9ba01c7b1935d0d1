#include "workbench/model_library.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "params/input_error.h"
#include "params/numbers.h"
#include "workbench/data_folder.h"
#include "workbench/model_cache.h"
#include "workbench/texture_library.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

fs::path models_folder() { return data_folder() / "models"; }

std::string joined(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

InputError no_model(const std::string& name) {
  std::string ids;
  for (const Shape& shape : shapes()) ids += (ids.empty() ? "" : ", ") + std::string(shape.id);
  const std::string files = joined(bundled_models());
  return InputError(
      name, {"there is no such model", "そのようなモデルはありません"},
      {"name a file, a shape (" + ids + ")" + (files.empty() ? "" : " or a bundled model (" + files + ")"),
       "ファイル、形（" + ids + "）" + (files.empty() ? "" : "、付属のモデル（" + files + "）") +
           "のどれかを指定してください"});
}

// Where the file stands that Object::model names.
fs::path file_of(const std::string& model) {
  const fs::path path(model);
  return path.is_absolute() ? path : models_folder() / path;
}

// digits * 10^exponent as the double next to that decimal number.
double decimal(double digits, int exponent) {
  const std::string text = std::to_string(std::llround(digits)) + "e" + std::to_string(exponent);
  return parse_number(text).value_or(digits) + 0.0;  // + 0.0: no -0
}

double with_three_digits(double v) {
  if (v == 0 || !std::isfinite(v)) return v;
  const int exponent = int(std::floor(std::log10(std::abs(v)))) - 2;
  return decimal(v / std::pow(10.0, exponent), exponent);
}

// The smallest ball about the middle of the box that holds all parts; how far the parts reach from the origin.
struct Extent {
  glm::dvec3 centre{0};
  double radius = 0, reach = 0;
};

Extent extent_of(const Model& model) {
  glm::dvec3 low(0), high(0);
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const Mesh& mesh = *model.parts[i].mesh;
    low = i ? glm::min(low, mesh.low()) : mesh.low();
    high = i ? glm::max(high, mesh.high()) : mesh.high();
  }
  Extent out{low * 0.5 + high * 0.5};
  for (const ModelPart& part : model.parts) {
    const MeshData& data = part.mesh->data();
    for (const Corner& corner : data.corners) {
      const glm::dvec3& p = data.positions[corner.position];
      out.radius = std::max(out.radius, length_and_unit(p - out.centre).length);
      out.reach = std::max(out.reach, length_and_unit(p).length);
    }
  }
  return out;
}

Transform transform_of(const Model& model) {
  const Extent extent = extent_of(model);
  // A model that already fills the unit ball about the origin stays as it is.
  if (std::abs(extent.reach - 1) < 1e-3 && extent.radius > 0.9) return {};
  return fitting_transform(extent.centre, extent.radius);
}

int level_of(const Shape& shape, int tessellation, const std::string& where) {
  if (tessellation == 0 || (tessellation >= shape.min_level && tessellation <= shape.max_level)) return tessellation;
  const std::string low = std::to_string(shape.min_level), high = std::to_string(shape.max_level);
  throw InputError(where + ".tessellation",
                   {std::to_string(tessellation) + " is not possible for " + std::string(shape.id),
                    std::string(shape.id) + " に " + std::to_string(tessellation) + " は使えません"},
                   {"give 0 for its own choice, or a whole number from " + low + " to " + high,
                    "0（形に任せる）または " + low + " から " + high + " の整数を指定してください"});
}

MeshHandle mesh_of(const Object& object, const std::string& where) {
  if (object.model.empty()) {
    if (object.mesh) return object.mesh;  // made by a program, not by a name
    throw InputError(where + ".model", {"the object has no model", "モデルの指定がありません"});
  }
  if (const Shape* shape = find_shape(object.model))
    return mesh_of(*shape, level_of(*shape, object.tessellation, where));
  return mesh_in(file_of(object.model), object.part, where);
}

}  // namespace

Transform fitting_transform(const glm::dvec3& centre, double radius) {
  Transform t;
  if (radius > 0) t.scale = glm::dvec3(std::clamp(with_three_digits(1 / radius), 1e-30, 1e30));
  t.translate = -(t.scale * centre);
  for (int i = 0; i < 3; ++i) {
    double& v = t.translate[i];
    if (std::abs(v) < 1e12) v = decimal(v * 1000, -3);  // beyond there are hardly thousandths
    v = std::clamp(v, -1e30, 1e30);
  }
  return t;
}

std::vector<std::string> bundled_models() {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator i(models_folder(), error), end; !error && i != end; i.increment(error)) {
    const std::string type = i->path().extension().string();
    if (type == ".obj" || type == ".ply" || type == ".off" || type == ".stl")
      names.push_back(i->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string find_model(const std::string& name, const fs::path& folder) {
  if (find_shape(name)) return name;
  std::error_code error;
  const auto exists = [&](const fs::path& file) { return fs::exists(file, error) && !fs::is_directory(file, error); };
  const fs::path here = folder.empty() ? fs::path(name) : folder / name;
  if (!name.empty() && exists(here)) {
    const fs::path bundled = models_folder() / here.filename();
    if (fs::equivalent(here, bundled, error)) return here.filename().string();
    return fs::absolute(here, error).lexically_normal().string();
  }
  for (const std::string& bundled : bundled_models())
    if (bundled == name || bundled == name + ".obj") return bundled;
  if (fs::is_directory(here, error))
    throw InputError(name, {"is a folder", "フォルダです"},
                     {"name a model file", "モデルのファイルを指定してください"});
  throw no_model(name);
}

Scene open_model(const std::string& name, std::vector<Text>* notes) {
  Scene scene;
  if (const Shape* shape = find_shape(name)) {
    Object object;
    object.name = object.model = name;
    object.mesh = mesh_of(*shape, 0);
    scene.objects.push_back(std::move(object));
    return scene;
  }
  const fs::path file = file_of(name);
  const std::shared_ptr<const Model> model = model_in(file);
  const Transform transform = transform_of(*model);
  for (const ModelPart& part : model->parts) {
    Object object;
    object.name = part.name.empty() ? file.stem().string() : part.name;
    object.model = name;
    object.part = model->parts.size() > 1 ? part.name : "";
    object.transform = transform;
    object.own_material = part.material.has_value();
    object.material = part.material.value_or(Material{});
    object.mesh = MeshHandle(model, part.mesh.get());
    scene.objects.push_back(std::move(object));
  }
  if (notes) notes->insert(notes->end(), model->notes.begin(), model->notes.end());
  return scene;
}

void load_meshes(Scene& scene) {
  std::vector<MeshHandle> meshes;
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    meshes.push_back(mesh_of(scene.objects[i], "objects." + std::to_string(i)));
  for (std::size_t i = 0; i < meshes.size(); ++i) scene.objects[i].mesh = std::move(meshes[i]);
  load_textures(scene);
}

}  // namespace cg
