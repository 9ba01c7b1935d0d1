// A radiosity solution is the same picture in software, GLSL and the fixed function.
#include <gtest/gtest.h>

#include "params/input_error.h"
#include "tests/parity/parity_cases.h"
#include "tests/radiosity_fields.h"

namespace cg::parity {
namespace {

class RadiosityParity : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    try {
      comparison_.emplace();
    } catch (const InputError& none) {
      GTEST_SKIP() << none.what();
    }
  }

  // Every technique and precision within the limits of parity.
  void check(const Scene& scene, const std::string& what) {
    for (const Result& r : comparison_->compare(scene, what)) {
      EXPECT_LE(r.coverage_mismatch, 5u) << r.what;
      EXPECT_LE(r.max_error * 255, 2.001) << r.what;
      EXPECT_LE(double(r.over_1_255), 0.001 * double(r.covered)) << r.what;
      EXPECT_GT(r.covered, 1000u) << r.what;
      worst_ = std::max(worst_, r.max_error);
    }
  }

  Model model() const {
    const std::string name = GetParam();
    return name == "cornell-box" ? file_model(std::filesystem::path(SHADEBENCH_SOURCE_DIR) / "models/cornell-box.obj")
                                 : shape_model(name);
  }

  std::optional<Comparison> comparison_;
  double worst_ = 0;
};

glm::vec3 bright_light(const glm::dvec3& p, const glm::dvec3& n) { return 3.0f * smooth_light(p, n); }

// Objects of models are of any size: their light varies as often over each.
LightAt over(const Object& object, const LightAt& light) {
  const glm::dvec3 centre = object.mesh->centre();
  const double size = glm::length(object.mesh->high() - object.mesh->low());
  return [=](const glm::dvec3& p, const glm::dvec3& n) { return light(2.0 * (p - centre) / size, n); };
}

Scene lit(Scene scene, int times, const LightAt& light) {
  const auto field = std::make_shared<RadiosityField>();
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    field->objects.push_back(cut_field(scene, times, over(scene.objects[i], light), {i})->objects[i]);
  scene.radiosity_field = field;
  scene.shading.ambient_source = AmbientSource::radiosity;
  return scene;
}

TEST_P(RadiosityParity, WithLightsInEveryMode) {
  const std::vector<Setting> settings = all_settings();
  for (std::size_t i = 0; i < settings.size(); i += 5)
    check(lit(scene_of(model(), settings[i]), 1, smooth_light), std::string(GetParam()) + ' ' + name_of(settings[i]));
  RecordProperty("worst_of_255", std::to_string(255 * worst_));
}

TEST_P(RadiosityParity, AloneAndOverOne) {
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
    for (const bool clamp : {true, false})
      for (const int times : {0, 2}) {
        Scene scene = lit(scene_of(model(), {0, LightKind::point, mode, Reflection::half_vector}), times, bright_light);
        scene.shading.clamp = clamp;
        scene.material.emission = {0.2, 0, 0};
        const std::string name = std::string(GetParam()) + ' ' +
                                 std::string(names_of<ShadingMode>[std::size_t(mode)].id) + (clamp ? " clamped" : "") +
                                 " cut " + std::to_string(times);
        check(scene, name + ", lights");
        scene.lights.clear();
        check(scene, name);
      }
}

// One object has light of the solution, the other the constant term, and their material follows glColor.
TEST_P(RadiosityParity, BesideTheConstantTerm) {
  Scene scene = scene_of(model(), {2, LightKind::point, ShadingMode::gouraud, Reflection::half_vector});
  scene.objects.insert(scene.objects.begin(), scene.objects[0]);
  scene.objects[0].transform.translate.x += 0.3;
  scene.objects.push_back(scene.objects[0]);
  scene.objects.back().transform.translate.y += 0.3;
  scene.radiosity_field = cut_field(scene, 1, over(scene.objects[1], smooth_light), {1});
  scene.shading.ambient_source = AmbientSource::radiosity;
  for (const ColorMaterial tracked : {ColorMaterial::off, ColorMaterial::ambient_and_diffuse, ColorMaterial::specular,
                                      ColorMaterial::emission, ColorMaterial::ambient, ColorMaterial::diffuse}) {
    scene.shading.color_material = tracked;
    scene.material.color = {0.3, 0.1, 0.2};
    check(scene, std::string(GetParam()) + " beside, tracked " + std::to_string(int(tracked)));
  }
}

INSTANTIATE_TEST_SUITE_P(Models, RadiosityParity, ::testing::Values("cornell-box", "uv-sphere", "cube"));

}  // namespace
}  // namespace cg::parity
