#include "workbench/mistake_quiz.h"

#include <algorithm>
#include <cassert>

#include "math/vec.h"
#include "params/slots.h"

namespace cg {
namespace {

bool scaled(const Object& o) { return o.transform.scale != glm::dvec3(1); }

// Behind the object, so that the faces at its rim are turned away from it.
void light_from_behind(Scene& scene) {
  const Camera& c = scene.camera;
  const glm::dvec3 to_eye = c.position - c.target;
  const double distance = glm::length(to_eye);
  if (scene.lights.empty()) scene.lights.emplace_back();
  Light& light = scene.lights[0];
  if (!(distance > 0) || distance > 1e6) return;
  const glm::dvec3 side = glm::cross(c.up, to_eye / distance);
  light.kind = LightKind::point;
  light.position = c.target + 2.0 * distance * (side + c.up - to_eye / distance);
}

// A copy behind the only object that there is, drawn after it: of one alone that is convex, nothing hidden is drawn
// last.
void let_depth_show(Scene& scene) {
  const auto visible = [](const Object& o) { return o.visible; };
  const auto first = std::find_if(scene.objects.begin(), scene.objects.end(), visible);
  if (std::count_if(scene.objects.begin(), scene.objects.end(), visible) != 1) return;
  const glm::dvec3 away = scene.camera.target - scene.camera.position;
  const double distance = glm::length(away);
  if (!(distance > 0) || distance > 1e6) return;
  Object behind = *first;
  behind.transform.translate += 0.3 * away + 0.1 * glm::cross(away, scene.camera.up);
  scene.objects.push_back(std::move(behind));
}

void let_gate_show(Scene& scene) {
  for (Material* m : {&scene.material}) m->n = std::min(m->n, 8.0), m->k_s = glm::max(m->k_s, glm::dvec3(0.5));
  for (Object& o : scene.objects)
    if (o.own_material)
      o.material.n = std::min(o.material.n, 8.0), o.material.k_s = glm::max(o.material.k_s, glm::dvec3(0.5));
  light_from_behind(scene);
}

void let_color_show(Scene& scene) {
  if (scene.shading.color_material != ColorMaterial::off) return;
  scene.shading.color_material = ColorMaterial::ambient_and_diffuse;
  constexpr glm::dvec3 red{0.9, 0.3, 0.1};
  scene.material.color = red;
  for (Object& o : scene.objects)
    if (o.own_material) o.material.color = red;
}

const bool* member(const Slots& all, std::string_view mistake) {
  for (const Slot& slot : all)
    if (slot.path == mistake) return *std::get_if<bool*>(&slot.value);
  return nullptr;
}

// A counter turned into a number that looks random: Sebastiano Vigna's splitmix64.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

}  // namespace

void let_it_show(Scene& scene, std::string_view mistake) {
  if (mistake == "no_normalize") {
    if (scene.shading.normal_length == NormalLength::off) scene.shading.normal_length = NormalLength::normalize;
    if (std::none_of(scene.objects.begin(), scene.objects.end(), scaled))
      for (Object& o : scene.objects) o.transform.scale = glm::dvec3(0.5);
  } else if (mistake == "no_color_material") {
    let_color_show(scene);
  } else if (mistake == "no_depth_test") {
    let_depth_show(scene);
  } else if (mistake == "no_gate") {
    let_gate_show(scene);
  } else if (mistake == "directional_w" || mistake == "long_light_vector" || mistake == "light_before_view") {
    const auto stands = [](const Light& l) { return l.enabled && l.kind != LightKind::directional && l.w != 0; };
    if (std::any_of(scene.lights.begin(), scene.lights.end(), stands)) return;
    if (scene.lights.empty()) scene.lights.emplace_back();
    scene.lights[0].kind = LightKind::point;
    scene.lights[0].enabled = true, scene.lights[0].w = 1;
  }
}

bool has_mistake(const Scene& scene, std::string_view mistake) {
  Mistakes copy = scene.mistakes;
  const bool* on = member(slots(copy), mistake);
  assert(on);
  return *on;
}

void set_mistake(Scene& scene, std::string_view mistake, bool on) {
  const Slots all = slots(scene.mistakes);
  assign(find_slot(all, mistake), on);
}

MistakeQuiz::MistakeQuiz(const Scene& scene, std::uint64_t seed) : before_(scene), seed_(seed) {}

// Ronald Fisher and Frank Yates, as a deck of cards.
void MistakeQuiz::shuffle() {
  Mistakes names;
  for (const Slot& slot : slots(names)) deck_.push_back(slot.about->name);
  for (std::size_t i = deck_.size() - 1; i > 0; --i)
    std::swap(deck_[i], deck_[std::size_t(mixed(seed_ ^ mixed(drawn_++)) % (i + 1))]);
  if (deck_.back() == mistake_) std::swap(deck_.front(), deck_.back());
}

Scene MistakeQuiz::next() {
  if (deck_.empty()) shuffle();
  mistake_ = deck_.back();
  deck_.pop_back();
  answered_.reset();
  ++asked_;
  Scene scene = before_;
  scene.mistakes = {};
  let_it_show(scene, mistake_);
  set_mistake(scene, mistake_, true);
  const Listing text = listing(scene);
  missing_ = std::any_of(text.lines.begin(), text.lines.end(),
                         [](const ListingLine& line) { return line.guilty && line.comment; });
  return scene;
}

bool MistakeQuiz::take(bool right) {
  if (answered_) return *answered_;
  answered_ = right;
  right_ += right;
  return right;
}

}  // namespace cg
