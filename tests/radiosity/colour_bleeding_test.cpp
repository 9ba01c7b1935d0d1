// The light of the Cornell box by hemicubes, patches and Gauss and Seidel's iteration, beside particles that are traced
// from the light and reflected from where they meet a surface: no form factors, no system, no light that is even over
// a patch. (shadebench radiosity --against monte-carlo compares with form factors by rays, for any scene.)
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "math/transform.h"
#include "radiosity/item_scene.h"
#include "radiosity/patch_tree.h"
#include "radiosity/solution.h"
#include "scene/cornell_box.h"

namespace cg {
namespace {

using Means = std::map<std::string, glm::dvec3>;  // of B over pi, by object

Scene cornell_box() {
  Scene scene;
  for (const BundledPart& part : cornell_parts()) {
    Object o;
    o.name = part.name;
    o.mesh = Mesh::make(part.mesh);
    o.own_material = true;
    for (const BundledMaterial& m : cornell_materials())
      if (m.name == part.material) o.material.k_d = m.reflectance, o.material.emission = m.emission;
    scene.objects.push_back(std::move(o));
  }
  return scene;
}

// The mean over each object of what its patches have.
template <class Value>
Means means_of(const Scene& scene, const std::vector<Patch>& patches, const Value& value) {
  Means sum;
  std::map<std::string, double> area;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const std::string& name = scene.objects[patches[i].object].name;
    sum[name] += patches[i].area * value(i);
    area[name] += patches[i].area;
  }
  for (auto& [name, s] : sum) s /= area[name];
  return sum;
}

// Particles of the light, as the emission of each patch has them.
class Particles {
 public:
  explicit Particles(const Patches& patches)
      : patches_(patches.patches),
        polygons_(item_polygons(patches)),
        scene_(polygons_),
        tree_(polygons_),
        received_(patches_.size()) {
    for (const Patch& p : patches_) {
      scene_.find_above(p.centre, p.normal, above_.emplace_back());
      power_.push_back(p.area * (p.emission.x + p.emission.y + p.emission.z));
    }
  }

  void shoot(int count) {
    std::discrete_distribution<std::size_t> any(power_.begin(), power_.end());
    double total = 0;
    for (const double p : power_) total += p;
    for (int i = 0; i < count; ++i) {
      std::size_t at = any(random_);
      const Patch& p = patches_[at];
      const auto& c = p.corner;  // a parallelogram
      const glm::dvec3 from = c[0] + uniform() * (c[1] - c[0]) + uniform() * (c[3] - c[0]);
      follow(at, from, p.emission / (p.emission.x + p.emission.y + p.emission.z) * (total / count));
    }
  }
  // B over pi of a patch.
  glm::dvec3 radiosity(std::size_t i) const {
    const Patch& p = patches_[i];
    return p.emission + p.reflectance * received_[i] / p.area;
  }

 private:
  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }

  // Until it is absorbed, or leaves the box.
  void follow(std::size_t at, glm::dvec3 from, glm::dvec3 power) {
    for (;;) {
      const double r = uniform(), turn = 2 * pi * uniform();
      const glm::dvec3 n = patches_[at].normal;
      const glm::dvec3 u = unit(glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
      const glm::dvec3 d =
          std::sqrt(r) * (std::cos(turn) * u + std::sin(turn) * glm::cross(n, u)) + std::sqrt(1 - r) * n;
      const std::uint32_t met = tree_.first_met(from, d, above_[at].above);
      if (met >= from_behind) return;
      const Patch& p = patches_[met];
      from += d * (glm::dot(p.centre - from, p.normal) / glm::dot(d, p.normal));
      received_[met] += power;
      const double survives = std::max({p.reflectance.x, p.reflectance.y, p.reflectance.z});
      if (uniform() >= survives) return;
      power *= p.reflectance / survives;
      at = met;
    }
  }

  const std::vector<Patch>& patches_;
  std::vector<ItemPolygon> polygons_;
  ItemScene scene_;
  PatchTree tree_;
  std::vector<Horizon> above_;
  std::vector<double> power_;
  std::vector<glm::dvec3> received_;
  std::mt19937_64 random_{1};
};

TEST(ColourBleeding, AgreesWithParticles) {
  const Scene scene = cornell_box();
  Radiosity options;
  options.patch_size = 0.045;
  Progress progress;
  SolveOptions how;
  how.threads = 2;
  const SolutionHandle s = solve_radiosity(scene, options, nullptr, progress, how);
  Particles particles(*s->patches);
  particles.shoot(500000);
  const Means ours = means_of(scene, s->patches->patches, [&](std::size_t i) { return s->radiosity[i]; });
  const Means theirs = means_of(scene, s->patches->patches, [&](std::size_t i) { return particles.radiosity(i); });
  std::printf("%zu patches, 500000 particles: difference of means, R G B\n", s->radiosity.size());
  ASSERT_EQ(ours.size(), 8u);
  for (const auto& [name, b] : ours) {
    const glm::dvec3 off = b / theirs.at(name) - 1.0;
    std::printf("  %-12s %+.2f %% %+.2f %% %+.2f %%\n", name.c_str(), 100 * off.x, 100 * off.y, 100 * off.z);
    for (int c = 0; c < 3; ++c) EXPECT_LT(std::abs(off[c]), 0.02) << name;
  }
  // The tall block stands by the red wall.
  const auto redness = [&](const char* name) { return ours.at(name).x / ours.at(name).y; };
  EXPECT_GT(redness("tall-block"), 1.05 * redness("short-block"));
}

}  // namespace
}  // namespace cg
