// A scene with a random value of every parameter that its description accepts.
#pragma once
#include <cmath>
#include <random>

#include "params/slots.h"
#include "scene/scene.h"

namespace cg {

// Within the range; where it spans magnitudes, of any of them.
inline double random_number(std::mt19937_64& random, const About& about) {
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const auto [low, high] = about.range;
  switch (random() % 6) {
    case 0:
      return low;
    case 1:
      return high;
    case 2:
      return about.also.value_or(high);
    case 3: {
      const double v = std::copysign(std::pow(10.0, uniform(-30, 30)), uniform(-1, 1));
      return about.accepts(v) ? v : about.range.min;
    }
    case 4:
      return about.accepts(-0.0) ? -0.0 : high;
    default:
      return low + (high - low) * uniform(0, 1);
  }
}

inline void randomize(std::mt19937_64& random, const Slot& slot) {
  const About& about = *slot.about;
  if (auto* const* b = std::get_if<bool*>(&slot.value)) **b = random() % 2;
  if (auto* const* i = std::get_if<int*>(&slot.value)) **i = int(random_number(random, about));
  if (auto* const* d = std::get_if<double*>(&slot.value)) **d = random_number(random, about);
  if (auto* const* v = std::get_if<glm::dvec3*>(&slot.value))
    for (int i = 0; i < 3; ++i) (**v)[i] = random_number(random, about);
  if (auto* const* s = std::get_if<std::string*>(&slot.value))
    **s = "名 \"" + std::to_string(random() % 100) + "\"\\\n";
  if (const auto* c = std::get_if<Choice>(&slot.value)) c->set(c->object, int(random() % c->names.size()));
}

// Of shapes only; meshes are not loaded.
inline Scene random_scene(std::mt19937_64& random) {
  Scene scene;
  scene.objects.resize(random() % 4);
  scene.lights.resize(random() % 10);
  for (const Slot& slot : slots(scene)) randomize(random, slot);
  const char* shapes[] = {"teapot", "cube", "torus", "plane"};
  for (Object& object : scene.objects) object.model = shapes[random() % 4], object.tessellation = 0;
  return scene;
}

}  // namespace cg
