#include "tests/extremes/storm.h"

#include "params/slots.h"
#include "scene/shape.h"

namespace cg::storm {

namespace {

// std's distributions differ between libraries; this does not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double unit() { return double(engine_() >> 11) * 0x1p-53; }
  int below(int n) { return int(unit() * n); }
  bool chance(double p) { return unit() < p; }

 private:
  std::mt19937_64 engine_;
};

double random_number(const About& about, double initial, Random& random) {
  const Range slider = about.slider_range();
  double v = initial;
  switch (random.below(8)) {
    case 0:
      v = about.range.min;
      break;
    case 1:
      v = about.range.max;
      break;
    case 2:
      v = about.also.value_or(0);
      break;
    case 3:
      v = 0;
      break;
    case 4:  // any magnitude, either sign
      v = (random.chance(0.5) ? 1 : -1) * std::pow(10, random.unit() * 60 - 30);
      break;
    default:
      v = slider.min + random.unit() * (slider.max - slider.min);
  }
  return about.accepts(v) ? v : initial;
}

struct SetRandom {
  const Slot& slot;
  Random& random;

  void operator()(bool* v) const { *v = random.chance(0.5); }
  void operator()(int*) const {}
  void operator()(std::string*) const {}
  void operator()(double* v) const { *v = random_number(*slot.about, *std::get<double*>(slot.initial), random); }
  void operator()(glm::dvec3* v) const {
    const glm::dvec3 initial = *std::get<glm::dvec3*>(slot.initial);
    for (int c = 0; c < 3; ++c) (*v)[c] = random_number(*slot.about, initial[c], random);
    if (random.chance(0.3)) v->y = v->z = v->x;
  }
  void operator()(const Choice& c) const { c.set(c.object, random.below(int(c.names.size()))); }
};

// A mesh with its positions moved and scaled, and with normals of that length where it is not 1.
MeshHandle changed(const Mesh& mesh, double scale, const glm::dvec3& offset, double normal_length) {
  MeshData data = mesh.data();
  for (glm::dvec3& p : data.positions) p = p * scale + offset;
  for (glm::dvec3& n : data.normals) n *= normal_length;
  return Mesh::make(std::move(data));
}

MeshHandle sliver(double height) {
  MeshData d;
  d.positions = {{-1, 0, 0}, {1, 0, 0}, {0.3, height, 0}, {0.1, -1, 0.2}};
  const std::array<Corner, 3> a{Corner{0}, Corner{1}, Corner{2}}, b{Corner{1}, Corner{0}, Corner{3}};
  d.add_face(a.data(), a.data() + 3);
  d.add_face(b.data(), b.data() + 3);
  return Mesh::make(std::move(d));
}

}  // namespace

std::vector<MeshHandle> meshes() {
  const MeshHandle cube = make_shape(*find_shape("cube")), sphere = make_shape(*find_shape("uv-sphere"), 8);
  std::vector<MeshHandle> all{cube, sphere, make_shape(*find_shape("torus"), 8), make_shape(*find_shape("plane"), 2)};
  for (const double scale : {1e-20, 1e20, 1e-30, 1e30}) all.push_back(changed(*sphere, scale, glm::dvec3(0), 1));
  all.push_back(changed(*sphere, 1, glm::dvec3(1e6), 1));
  for (const double length : {0.0, 1e-20, 1e20, 1e-38, 1e30}) all.push_back(changed(*sphere, 1, glm::dvec3(0), length));
  for (const double height : {1e-3, 1e-7, 1e-30}) all.push_back(sliver(height));
  return all;
}

Scene random_scene(std::uint64_t seed, const std::vector<MeshHandle>& meshes) {
  Random random(seed);
  Scene scene;
  scene.lights.resize(std::size_t(random.chance(0.1) ? random.below(12) : 1 + random.below(2)));
  scene.objects.resize(std::size_t(1 + random.below(2)));
  for (Object& o : scene.objects) o.mesh = meshes[std::size_t(random.below(int(meshes.size())))];
  // Half of the states change a few parameters, so that something is seen; the other half many.
  const double share = random.chance(0.5) ? 0.05 : 0.4;
  for (const Slot& slot : slots(scene))
    if (random.chance(slot.path.find("camera") == std::string::npos ? share : share * 0.3))
      std::visit(SetRandom{slot, random}, slot.value);
  for (Object& o : scene.objects) o.visible = true;
  return scene;
}

std::string fault(const Technique& software, const Scene& scene) {
  Progress progress;
  const View view{24, 16, 1, false, true};
  const Frame f = software.render(scene, software.plan(scene, view), view, progress);
  if (f.nan_pixels > 0) return std::to_string(f.nan_pixels) + " pixels are not finite";
  for (std::size_t i = 0; i < f.colour.size(); ++i) {
    if (!is_finite(f.colour.pixels()[i])) return "a colour is not finite and was not counted";
    if (!is_finite(f.normal.pixels()[i])) return "a normal is not finite";
    const float z = f.depth.pixels()[i];
    if (!(z >= 0 && z <= 1)) return "a depth of " + std::to_string(z);
    if (f.covered.pixels()[i] != (z < 1)) return "coverage and depth disagree";
    if (!f.covered.pixels()[i] && f.colour.pixels()[i] != glm::vec3(scene.display.background)) return "background";
  }
  return {};
}

}  // namespace cg::storm
