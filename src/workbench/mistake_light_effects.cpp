// The mistakes with lights: where they stand, how long L is, and where a highlight may be.
#include <cmath>

#include "workbench/mistake_scene.h"

namespace cg {

namespace {

std::string in_brackets(const glm::dvec3& v) {
  return "(" + short_number(v.x) + ", " + short_number(v.y) + ", " + short_number(v.z) + ")";
}

// Towards the light at a world point: unit for a directional light, else as long as the way.
glm::dvec3 towards(const EyeLight<double>& light, const glm::dvec3& point) {
  return light.directional ? light.position : light.position - point;
}

double attenuation(const EyeLight<double>& light, double r) {
  const double d = light.k_0 + r * (light.k_1 + r * light.k_2);
  return light.directional || !(d > 0) ? 1 : 1 / d;
}

}  // namespace

MistakeEffect light_before_view_effect(const MistakeScene& s) {
  const glm::dmat4 to_world = glm::inverse(s.view);
  const glm::dvec3 target = s.scene.camera.target;
  MistakeEffect e;
  double moved = 0;
  std::string light, meant, drawn;
  for (const EyeLight<double>& l : s.world_lights.lights) {
    const glm::dvec3 at(to_world * glm::dvec4(l.position, l.directional ? 0 : 1));
    const double angle =
        l.directional ? angle_between(at, l.position) : angle_between(at - target, l.position - target);
    moved = std::max(moved, glm::length(at - l.position));
    if (!light.empty() && angle <= e.value) continue;
    e.value = angle, light = std::to_string(l.index), meant = in_brackets(l.position), drawn = in_brackets(at);
  }
  e.shows = moved > 1e-3;
  const std::string angle = short_number(e.value) + "°";
  e.text = e.shows ? Text("Light " + light + " shines from " + drawn + " instead of " + meant +
                              ": seen from the target it has turned by " + angle +
                              ". Orbit by 30° and it turns by 30° with the camera.",
                          "光源 " + light + " は " + meant + " でなく " + drawn + " から照らし、注視点から見て " +
                              angle + " 回っている。視点を 30° 回すと光源も一緒に 30° 回る。")
                   : Text(Words{"Eye and world coordinates are the same here: move the camera to see it.",
                                "ここでは視点座標とワールド座標が同じ。カメラを動かせば見える。"});
  return e;
}

MistakeEffect directional_w_effect(const MistakeScene& s) {
  MistakeEffect e;
  std::string light;
  double fade = 1;
  bool some = false;
  for (const EyeLight<double>& l : s.world_lights.lights) {
    if (l.directional) continue;
    some = true;
    const glm::dvec3 drawn = s.scene.lights[std::size_t(l.index)].position;
    const double share = attenuation(l, glm::length(l.position - s.objects[0].middle));
    if (std::abs(std::log(share)) > std::abs(std::log(fade))) fade = share;
    for (const MistakeObject& o : s.objects)
      for (const glm::dvec3& corner : o.box) {
        const double angle = angle_between(drawn, l.position - corner);
        if (light.empty() || angle > e.value) e.value = angle, light = std::to_string(l.index);
      }
  }
  e.shows = some && (e.value > 0.1 || std::abs(fade - 1) > 1e-3);
  if (!some) {
    e.text = Words{"Every light here is directional already: set one to point or spot to see it.",
                   "ここの光源はすべて平行光源。点光源かスポットにすれば見える。"};
    return e;
  }
  const std::string angle = short_number(e.value) + "°", f = short_number(fade);
  e.text = {"All rays are parallel: on the objects L of light " + light + " is off by up to " + angle + ".",
            "光線がすべて平行になり、物体上で光源 " + light + " の L は最大 " + angle + " ずれる。"};
  if (!e.shows)
    e.text = {"The light is so far away that L is off by only " + angle + ": bring it nearer to see it.",
              "光源が遠いので L のずれは " + angle + " だけ。近づければ見える。"};
  else if (fade != 1)
    e.text = {e.text.en + " It does not fade either: the attenuation is 1 instead of " + f + ".",
              e.text.ja + "減衰もせず、" + f + " のはずが 1 になる。"};
  return e;
}

MistakeEffect long_light_vector_effect(const MistakeScene& s) {
  MistakeEffect e;
  std::string light;
  for (const EyeLight<double>& l : s.world_lights.lights) {
    const glm::dvec3 L =
        l.directional ? s.scene.lights[std::size_t(l.index)].position : towards(l, s.objects[0].middle);
    const double length = length_and_unit(L).length;
    if (!light.empty() && std::abs(std::log(length)) <= std::abs(std::log(e.value))) continue;
    e.value = length, light = std::to_string(l.index);
  }
  e.shows = std::abs(e.value - 1) > 1e-3;
  const std::string n = short_number(e.value);
  e.text = e.shows ? Text("L of light " + light + " is " + n + " long in the middle of the object: N·L is " + n +
                              " times the cosine.",
                          "物体の中心で光源 " + light + " の L の長さは " + n + "。N·L は余弦の " + n + " 倍になる。")
                   : Text("L of light " + light + " is 1 long anyway: move the light to see it.",
                          "光源 " + light + " の L の長さはちょうど 1。光源を動かせば見える。");
  return e;
}

MistakeEffect no_gate_effect(const MistakeScene& s) {
  MistakeEffect e;
  std::size_t away = 0;
  for (const MistakeObject& o : s.objects) {
    const Object& object = s.scene.objects[std::size_t(o.index)];
    const auto m = eye_material<double>(material_of(s.scene, object), s.scene.shading.color_material);
    for (const EyeLight<double>& l : s.eye_lights.lights)
      for (std::size_t i = 0; i < o.P.size(); ++i) {
        const glm::dvec3 V = towards_viewer(s.eye_lights.local_viewer, o.P[i]);
        const auto f = light_factors(l, Reflection::half_vector, m.n, o.P[i], o.N[i], V);
        if (glm::dot(o.N[i], f.L) > 0 || !(glm::dot(o.N[i], o.P[i]) < 0)) continue;
        const glm::dvec3 H = unit(f.L + V);
        const double lobe = lobe_power(o.N[i], H, positive(glm::dot(o.N[i], H)), m.n);
        const glm::dvec3 term = f.attenuation * f.spot * lobe * l.specular * m.k_s;
        e.value = std::max({e.value, term.x, term.y, term.z});
        away += lobe > 0.01;
      }
  }
  e.shows = e.value > 0.5 / 255;
  const std::string n = short_number(e.value), count = std::to_string(away);
  e.text = e.shows ? Text("On the side turned away from the light (N·L ≤ 0) the highlight still reaches " + n +
                              ", at " + count + " vertices.",
                          "光源に背を向けた側（N·L ≤ 0）でも、" + count + " 個の頂点で鏡面項が最大 " + n + " になる。")
                   : Text(Words{"No highlight reaches the side turned away from the light here: lower n, raise k_s, or "
                                "move the light behind the object to see it.",
                                "ここでは光源に背を向けた側にハイライトが届かない。n を下げるか、k_s "
                                "を上げるか、光源を物体の後ろへ動かせば見える。"});
  return e;
}

}  // namespace cg
