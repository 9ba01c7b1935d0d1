#include "workbench/import_lights_in_world.h"

#include <algorithm>

#include "scene/text_scanner.h"

namespace cg {

namespace {

bool begins_with(const MatrixCalls& calls, const MatrixCalls& view) {
  return calls.size() >= view.size() && std::equal(view.begin(), view.end(), calls.begin());
}

// The lights' own numbers in world coordinates. A light given under the view keeps its numbers; one given before the
// view keeps them too where all are, for then it is the mistake of the scene; else it is carried over.
class LightPlacer {
 public:
  LightPlacer(Scene& scene, const GlState& state, const MatrixCalls& view, Complaints& complaints)
      : scene_(scene), s_(state), view_(view), complaints_(complaints) {}

  void run() {
    std::size_t n = 8;
    while (n > 0 && !s_.lights[n - 1].touched) --n;
    scene_.lights.clear();
    decide_mistakes(n);
    for (std::size_t i = 0; i < n; ++i) scene_.lights.push_back(light(i));
  }

 private:
  void complain(long line, std::size_t i, const Words& text) {
    const std::string name = "GL_LIGHT" + std::to_string(i);
    complaints_.add(line, phrase(text, {{name, name}}));
  }

  bool has_view() const { return !view_.empty() && s_.projection_view.empty(); }
  bool before_view(const MatrixCalls& calls) const { return has_view() && !begins_with(calls, view_); }

  void decide_mistakes(std::size_t n) {
    bool all_before = true, all_flat = true, any = false, any_round = false;
    for (std::size_t i = 0; i < n; ++i) {
      const GlLightState& l = s_.lights[i];
      if (!l.touched || l.position_line == 0) continue;
      any = true;
      all_before = all_before && before_view(l.position_matrix);
      const bool round = l.coned || l.fading || l.position.w != 0;
      any_round = any_round || round;
      all_flat = all_flat && (l.position.w == 0 || !round);
    }
    before_ = any && all_before;
    flat_ = any_round && all_flat;
    scene_.mistakes.light_before_view = before_;
    scene_.mistakes.directional_w = flat_;
  }

  // v (with w) from the coordinates of `calls` to the world's.
  glm::dvec4 in_world(const MatrixCalls& calls, const glm::dvec4& v) const {
    if (!s_.projection_view.empty()) return product(calls) * v;
    if (begins_with(calls, view_)) return product(std::span(calls).subspan(view_.size())) * v;
    const glm::dvec4 eye = product(calls) * v;
    return before_ ? eye : glm::inverse(product(view_)) * eye;
  }
  bool keeps_numbers(const MatrixCalls& calls) const {
    return calls == view_ || (calls.empty() && (before_ || !s_.projection_view.empty()));
  }
  glm::dvec3 placed(const MatrixCalls& calls, const glm::dvec3& v, double w) const {
    if (keeps_numbers(calls)) return v;
    return short_numbers(glm::dvec3(in_world(calls, {v, w})));
  }

  Light light(std::size_t i) {
    const GlLightState& l = s_.lights[i];
    Light out;
    out.enabled = l.enabled;
    out.ambient = l.ambient, out.diffuse = l.diffuse, out.specular = l.specular;
    if (l.touched && !l.enabled && !l.disabled)
      complain(l.line, i, {"{0} is set but never enabled", "{0} を設定しているが、有効にしていない"});
    set_kind(out, l, i);
    set_position(out, l, i);
    out.k_0 = l.k_0, out.k_1 = l.k_1, out.k_2 = l.k_2;
    if (!l.coned) return out;
    out.cutoff = l.cutoff, out.exponent = l.exponent;
    out.direction = l.direction_line > 0
                        ? placed(l.direction_matrix, l.direction, 0)
                        : short_numbers(glm::dvec3(glm::inverse(product(view_)) * glm::dvec4(l.direction, 0)));
    return out;
  }

  void set_kind(Light& out, const GlLightState& l, std::size_t i) {
    const bool round = l.coned || l.fading;
    out.kind = l.coned ? LightKind::spot : LightKind::point;
    if (l.position.w != 0) {
      out.w = l.position.w;
      return;
    }
    if (!round) out.kind = LightKind::directional;
    if (l.position_line == 0) return;
    if (!round) {
      complain(l.position_line, i,
               {"w = 0: {0} is directional, its position is where the light comes from",
                "w = 0：{0} は平行光源で、位置は光の来る方向になる"});
      return;
    }
    out.w = flat_ ? 1 : 0;
    complain(l.position_line, i,
             {"w = 0: {0} is directional, and its attenuation or cone has no place to begin",
              "w = 0：{0} は平行光源になり、減衰や円錐の起点がない"});
  }

  void set_position(Light& out, const GlLightState& l, std::size_t i) {
    if (l.position_line == 0) {
      out.position = short_numbers(glm::dvec3(glm::inverse(product(view_)) * l.position));
      if (l.enabled && !l.position_left_out)
        complain(l.line, i, {"{0} has no position: it shines along the view", "{0} の位置がない：視線の方向に照らす"});
      return;
    }
    out.position = placed(l.position_matrix, glm::dvec3(l.position), l.position.w);
    if (before_view(l.position_matrix))
      complain(l.position_line, i,
               {"{0} is placed before gluLookAt: it turns with the camera",
                "{0} を gluLookAt より前に置いている：光源がカメラと一緒に回る"});
  }

  Scene& scene_;
  const GlState& s_;
  const MatrixCalls& view_;
  Complaints& complaints_;
  bool before_ = false, flat_ = false;
};

}  // namespace

MatrixCalls view_of(const GlState& s) {
  if (!s.projection_view.empty()) return s.projection_view;
  const auto view_in = [](const MatrixCalls& calls) {
    return MatrixCalls(calls.begin(), calls.begin() + std::ptrdiff_t(view_length(calls)));
  };
  for (const GlDraw& draw : s.drawn)
    if (auto view = view_in(draw.modelview); !view.empty()) return view;
  if (auto view = view_in(s.modelview); !view.empty()) return view;
  // No gluLookAt: glTranslate( 0, 0, -5 ) and the like serve as one.
  const MatrixCalls& drawn = s.drawn.empty() ? s.modelview : s.drawn[0].modelview;
  for (const GlLightState& l : s.lights)
    if (l.position_line > 0 && begins_with(drawn, l.position_matrix)) {
      Camera camera;
      if (set_view(camera, l.position_matrix)) return l.position_matrix;
    }
  return {};
}

void place_lights(Scene& scene, const GlState& state, const MatrixCalls& view, Complaints& complaints) {
  LightPlacer(scene, state, view, complaints).run();
}

}  // namespace cg
