#include "workbench/score.h"

#include <algorithm>
#include <cmath>

#include "image/display.h"
#include "params/slots.h"
#include "workbench/isolate.h"
#include "workbench/technique_list.h"

namespace cg {

namespace {

constexpr std::size_t kinds = names_of<HintKind>.size();

struct Shown {
  ColourImage colour;  // after the display transform
  Image<std::uint8_t> covered;
  glm::vec3 background;
};

class Pictures {
 public:
  Pictures(const Technique& technique, Progress& progress, int threads)
      : technique_(technique), progress_(progress), view_{score_size, score_size, threads} {}

  Shown draw(const Scene& scene) {
    require(technique_, scene);
    if (progress_.cancelled) throw Cancelled{};
    Progress one;  // each picture runs from 0 to 1; `progress_` counts pictures
    Frame frame = technique_.render(scene, technique_.plan(scene, view_), view_, one);
    progress_.fraction = std::min(1.0f, progress_.fraction + step);
    return {displayed(scene.display, frame.colour), std::move(frame.covered),
            displayed(scene.display, glm::vec3(scene.display.background))};
  }

  double rmse(const Scene& a, const Scene& b) { return rmse(draw(a), draw(b)); }

  static double rmse(const Shown& a, const Shown& b) {
    const bool everywhere = a.background != b.background;
    const auto &pa = a.colour.pixels(), &pb = b.colour.pixels();
    double sum = 0;
    std::size_t n = 0;
    for (std::size_t i = 0; i < pa.size(); ++i) {
      if (!everywhere && !a.covered.pixels()[i] && !b.covered.pixels()[i]) continue;
      const glm::dvec3 d = glm::dvec3(pa[i]) - glm::dvec3(pb[i]);
      sum += glm::dot(d, d);
      ++n;
    }
    return n ? std::sqrt(sum / (3.0 * double(n))) : 0;
  }

 private:
  static constexpr float step = 1.0f / float(2 + 2 * kinds);
  const Technique& technique_;
  Progress& progress_;
  const View view_;
};

// Every object with a material of its own, so that both scenes say it at the same paths.
Scene with_own_materials(Scene scene) {
  for (Object& object : scene.objects) object.material = material_of(scene, object), object.own_material = true;
  return scene;
}

// Of a parameter of objects (of their materials), lights, camera, shading, display; nothing where no picture shows it.
std::optional<HintKind> kind_of(const Slot& slot) {
  switch (slot.about->quantity) {
    case Quantity::ambient:
      return HintKind::ambient;
    case Quantity::diffuse:
      return HintKind::diffuse;
    case Quantity::specular:
      return HintKind::specular;
    case Quantity::emission:
      return HintKind::emission;
    case Quantity::reflection:
    case Quantity::transmission:
      return std::nullopt;
    case Quantity::none:
      break;
  }
  const auto in = [&](std::string_view prefix) { return slot.path.starts_with(prefix); };
  if (in("objects.")) return slot.path.ends_with(".material.color") ? HintKind::diffuse : HintKind::object;
  if (in("lights.")) return HintKind::light;
  if (in("camera.")) return HintKind::camera;
  if (in("shading.")) return slot.path == "shading.color_material" ? HintKind::diffuse : HintKind::shading;
  if (in("display.")) return HintKind::display;
  return std::nullopt;  // the scene's material, which no object has here; mistakes
}

// The lists get the length of the student's with the kind that they belong to.
template <class Item>
void carry_length(std::vector<Item>& to, const std::vector<Item>& from, bool this_kind) {
  if (!this_kind) return;
  for (std::size_t i = to.size(); i < from.size(); ++i) to.push_back(from[i]);
  to.resize(from.size());
}

// The target with the student's parameters of one kind.
Scene carried(const Scene& student, const Scene& target, HintKind kind) {
  Scene from = student, to = target;
  carry_length(to.lights, from.lights, kind == HintKind::light);
  carry_length(to.objects, from.objects, kind == HintKind::object);
  from.lights.resize(std::min(from.lights.size(), to.lights.size()));
  from.objects.resize(std::min(from.objects.size(), to.objects.size()));
  const Slots source = slots(from), place = slots(to);
  for (const Slot& slot : source) {
    if (kind_of(slot) != kind) continue;
    const auto at = std::find_if(place.begin(), place.end(), [&](const Slot& s) { return s.path == slot.path; });
    if (at != place.end()) assign(*at, slot_tree(slot));
  }
  if (kind == HintKind::object)
    for (std::size_t i = 0; i < from.objects.size(); ++i) to.objects[i].mesh = from.objects[i].mesh;
  return to;
}

std::optional<Quantity> term_of(HintKind kind) {
  switch (kind) {
    case HintKind::ambient:
      return Quantity::ambient;
    case HintKind::diffuse:
      return Quantity::diffuse;
    case HintKind::specular:
      return Quantity::specular;
    case HintKind::emission:
      return Quantity::emission;
    default:
      return std::nullopt;
  }
}

}  // namespace

double score_of_rmse(double rmse) { return 100 * std::max(0.0, 1 - rmse / score_zero); }

Score score(const Scene& student, const Scene& target, const Technique& technique, Progress& progress, int threads) {
  const Scene a = with_own_materials(student), b = with_own_materials(target);
  Pictures pictures(technique, progress, threads);
  Score out;
  out.rmse = pictures.rmse(a, b);
  out.value = score_of_rmse(out.rmse);
  double furthest = 0;
  for (std::size_t i = 0; i < kinds; ++i) {
    const HintKind kind = HintKind(i);
    const Scene one = carried(a, b, kind);
    if (one == b) continue;
    const auto term = term_of(kind);
    // What follows glColor may be another term in the two.
    const bool alone = term && a.shading.color_material == b.shading.color_material;
    out.off[i] = alone ? pictures.rmse(isolated(one, *term), isolated(b, *term)) : pictures.rmse(one, b);
    if (out.off[i] > furthest) furthest = out.off[i], out.hint = kind;
  }
  progress.fraction = 1;
  return out;
}

Text hint_text(HintKind kind) {
  switch (kind) {
    case HintKind::ambient:
      return Words{"The ambient term is furthest off: look at k_a and I_a",
                   "最も違うのは環境光の項：k_a と I_a を見直すこと"};
    case HintKind::diffuse:
      return Words{"The diffuse term is furthest off: look at k_d and the lights' diffuse colours",
                   "最も違うのは拡散反射の項：k_d と光源の拡散光成分を見直すこと"};
    case HintKind::specular:
      return Words{"The highlight is furthest off: look at k_s, n and the lights' specular colours",
                   "最も違うのはハイライト：k_s、n、光源の鏡面光成分を見直すこと"};
    case HintKind::emission:
      return Words{"The emission is furthest off", "最も違うのは自己発光"};
    case HintKind::light:
      return Words{"The lights are furthest off: look at their number, position, kind and attenuation",
                   "最も違うのは光源：数、位置、種類、減衰を見直すこと"};
    case HintKind::object:
      return Words{"The objects are furthest off: look at the model and its transform",
                   "最も違うのは物体：モデルと変換を見直すこと"};
    case HintKind::camera:
      return Words{"The camera is furthest off: look at the eye, the target and the field of view",
                   "最も違うのはカメラ：視点、注視点、画角を見直すこと"};
    case HintKind::shading:
      return Words{"The shading is furthest off: look at its mode and the normals",
                   "最も違うのはシェーディング：方式と法線を見直すこと"};
    case HintKind::display:
      return Words{"The display is furthest off: look at the background and the display transform",
                   "最も違うのは表示：背景色と表示変換を見直すこと"};
  }
  return {};
}

}  // namespace cg
