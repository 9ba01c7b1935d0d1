#include "workbench/import_scene.h"

#include <algorithm>
#include <cmath>

#include "params/input_error.h"
#include "params/slots.h"
#include "scene/text_scanner.h"
#include "workbench/import_constants.h"
#include "workbench/import_lights_in_world.h"

namespace cg {

namespace {

class Converter {
 public:
  Converter(const GlState& state, bool whole, Complaints& complaints)
      : s_(state), whole_(whole), complaints_(complaints), view_(view_of(state)) {}

  Scene run() {
    scene_.objects.clear();
    camera();
    objects();
    materials();
    shading();
    place_lights(scene_, s_, view_, complaints_);
    check_ranges();
    return std::move(scene_);
  }

 private:
  void complain(long line, const Words& text, std::initializer_list<Text> values = {}) {
    complaints_.add(line, phrase(text, values));
  }

  // ---- camera ----

  void camera() {
    const long line = view_.empty() ? 0 : view_.back().line;
    if (!set_view(scene_.camera, view_))
      complain(line,
               {"the view also scales: the camera is left out", "視野変換に拡大縮小がある：カメラは読み込まない"});
    if (!s_.any_call) return;
    lens();
    for (const GlDraw& draw : s_.drawn) {
      const std::size_t n = view_length(draw.modelview);
      if (s_.projection_view.empty() && n > 0 && !std::ranges::equal(std::span(draw.modelview).first(n), view_))
        complain(draw.line, {"this is drawn with another view: the first one is taken",
                             "ここは別の視野変換で描いている：最初のものを使う"});
    }
  }

  void lens() {
    const GlState::Projection& p = s_.lens;
    Camera& c = scene_.camera;
    if (p.line == 0) {
      if (whole_)
        complain(0, {"there is no gluPerspective, glFrustum or glOrtho: the usual lens is taken",
                     "gluPerspective、glFrustum、glOrtho がない：既定の投影を使う"});
      return;
    }
    c.projection = p.orthographic ? Projection::orthographic : Projection::perspective;
    if (!p.orthographic) c.fov = p.fov;
    if (p.orthographic) c.height = p.height;
    c.near_plane = p.near_plane, c.far_plane = p.far_plane;
    if (!p.orthographic || p.near_plane > 0) return;
    // An orthographic picture is the same from farther back.
    const double back = 0.1 - p.near_plane;
    const glm::dvec3 away = unit(c.position - c.target) * back;
    c.position = short_numbers(c.position + away), c.target = short_numbers(c.target + away);
    c.near_plane = 0.1, c.far_plane = p.far_plane + back;
    complain(p.line, {"the near plane is behind the eye: the eye moves back instead",
                      "前方クリップ面が視点より後ろにある：代わりに視点を下げる"});
  }

  // ---- objects ----

  // The calls behind the view.
  std::span<const MatrixCall> behind_view(const MatrixCalls& calls) const {
    const std::span<const MatrixCall> all(calls);
    if (!s_.projection_view.empty()) return all;
    const std::size_t n = view_length(calls);
    const bool begins = calls.size() >= view_.size() && std::ranges::equal(all.first(view_.size()), view_);
    return all.subspan(n > 0 ? n : begins ? view_.size() : 0);
  }

  void objects() {
    std::vector<GlDraw> drawn = s_.drawn;
    if (drawn.empty()) drawn.push_back(begin_draw(s_, 0));
    for (const GlDraw& draw : drawn) {
      Object object;
      object.model = object.name = draw.model, object.tessellation = draw.tessellation;
      MatrixCalls calls(behind_view(draw.modelview).begin(), behind_view(draw.modelview).end());
      scales_ = scales_ || has_scale(calls);
      calls.insert(calls.end(), draw.fit.begin(), draw.fit.end());
      if (const auto t = transform_of(calls))
        object.transform = *t;
      else
        complain(draw.line, {"this object is sheared or flat: its transform is left out",
                             "この物体は斜めに歪むか平らになる：変換は読み込まない"});
      scene_.objects.push_back(std::move(object));
    }
  }

  static bool has_scale(std::span<const MatrixCall> calls) {
    return std::any_of(calls.begin(), calls.end(), [](const MatrixCall& c) {
      return c.kind == MatrixCall::matrix ||
             (c.kind == MatrixCall::scale &&
              std::any_of(c.numbers.begin(), c.numbers.end(), [](double v) { return std::abs(v) != 1; }));
    });
  }

  // ---- materials ----

  static ColorMaterial tracked(int token) {
    switch (token) {
      case gl_constant::ambient_and_diffuse:
        return ColorMaterial::ambient_and_diffuse;
      case gl_constant::ambient:
        return ColorMaterial::ambient;
      case gl_constant::diffuse:
        return ColorMaterial::diffuse;
      case gl_constant::specular:
        return ColorMaterial::specular;
      case gl_constant::emission:
        return ColorMaterial::emission;
      default:
        return ColorMaterial::off;
    }
  }

  // What the colour takes the place of, written in.
  static void write_color(Material& m, ColorMaterial tracked) {
    const bool both = tracked == ColorMaterial::ambient_and_diffuse;
    if (both || tracked == ColorMaterial::ambient) m.k_a = m.color;
    if (both || tracked == ColorMaterial::diffuse) m.k_d = m.color;
    if (tracked == ColorMaterial::specular) m.k_s = m.color;
    if (tracked == ColorMaterial::emission) m.emission = m.color;
  }

  Material material_of_state(const GlMaterialState& g) const {
    Material m;
    m.k_a = g.k_a, m.k_d = g.k_d, m.k_s = g.k_s, m.emission = g.emission, m.n = g.n;
    if (g.color_line > 0) m.color = g.color;
    return m;
  }

  void materials() {
    std::vector<GlDraw> drawn = s_.drawn;
    if (drawn.empty()) drawn.push_back(begin_draw(s_, 0));
    const ColorMaterial first = tracked(drawn[0].color_material);
    const bool one_mode =
        std::all_of(drawn.begin(), drawn.end(), [&](const GlDraw& d) { return tracked(d.color_material) == first; });
    std::vector<Material> all;
    bool unfollowed = true, meant = false;
    long color_line = 0;
    for (const GlDraw& d : drawn) {
      Material m = material_of_state(d.material);
      if (!one_mode) write_color(m, tracked(d.color_material));
      const bool follows = tracked(d.color_material) != ColorMaterial::off;
      unfollowed = unfollowed && !follows;
      if (!follows && d.material.color_line > 0 && (d.lit || !whole_)) {
        color_line = std::max(color_line, d.material.color_line);
        meant = meant || (!d.material.ambient_set && !d.material.diffuse_set);
      }
      all.push_back(m);
    }
    if (one_mode) scene_.shading.color_material = first;
    if (unfollowed && color_line > 0) {
      complain(color_line, {"glColor does nothing here: GL_COLOR_MATERIAL is never enabled",
                            "この glColor は効かない：GL_COLOR_MATERIAL が有効になっていない"});
      if (meant) scene_.mistakes.no_color_material = true, scene_.shading.color_material = tracked(s_.color_material);
    }
    scene_.material = all[0];
    const bool alike = std::all_of(all.begin(), all.end(), [&](const Material& m) { return m == all[0]; });
    for (std::size_t i = 0; i < all.size() && !alike; ++i)
      scene_.objects[i].own_material = true, scene_.objects[i].material = all[i];
  }

  // ---- the light model ----

  bool enabled(int what) const { return s_.enabled.contains(what); }

  void shading() {
    Shading& shading = scene_.shading;
    shading.mode = s_.flat ? ShadingMode::flat : ShadingMode::gouraud;
    shading.ambient = s_.ambient;
    shading.local_viewer = s_.local_viewer, shading.two_sided = s_.two_sided, shading.clamp = s_.clamp;
    scene_.display.background = s_.background;
    const bool normalize = enabled(gl_constant::normalize), rescale = enabled(gl_constant::rescale_normal);
    const bool fitted = std::any_of(scene_.objects.begin(), scene_.objects.end(),
                                    [](const Object& o) { return o.transform.scale != glm::dvec3(1); });
    shading.normal_length = normalize ? NormalLength::normalize
                            : rescale ? NormalLength::rescale
                            : fitted  ? NormalLength::normalize
                                      : NormalLength::off;
    if (scales_ && !normalize && !rescale) {
      scene_.mistakes.no_normalize = true;
      complain(scale_line(), {"glScale without GL_NORMALIZE changes the length of the normals, and with it N·L",
                              "GL_NORMALIZE なしの glScale は法線の長さを変え、N·L もその分変わる"});
    }
    whole_program();
    front_face();
  }

  long scale_line() const {
    for (const GlDraw& draw : s_.drawn)
      for (const MatrixCall& c : behind_view(draw.modelview))
        if (c.kind == MatrixCall::scale || c.kind == MatrixCall::matrix) return c.line;
    for (const MatrixCall& c : s_.modelview)
      if (c.kind == MatrixCall::scale) return c.line;
    return 0;
  }

  // What only a whole program can forget.
  void whole_program() {
    if (!whole_) return;
    const bool lit = std::any_of(s_.drawn.begin(), s_.drawn.end(), [](const GlDraw& d) { return d.lit; });
    if (!lit && !s_.drawn.empty())
      complain(0, {"GL_LIGHTING is never enabled: OpenGL draws glColor, without light",
                   "GL_LIGHTING が有効になっていない：光源なしで glColor の色になる"});
    if (enabled(gl_constant::depth_test)) return;
    scene_.mistakes.no_depth_test = true;
    complain(0, {"GL_DEPTH_TEST is never enabled: what is drawn last is seen",
                 "GL_DEPTH_TEST が有効になっていない：最後に描いたものが見える"});
  }

  // GLUT's teapot is wound clockwise: for it GL_CW is right.
  void front_face() {
    const bool matters = enabled(gl_constant::cull_face) || s_.two_sided;
    const bool teapots =
        std::any_of(s_.drawn.begin(), s_.drawn.end(), [](const GlDraw& d) { return d.model == "teapot"; });
    if (!s_.clockwise || teapots || !matters) return;
    scene_.mistakes.swapped_front_face = true;
    complain(s_.front_face_line,
             {"GL_CW exchanges front and back: the sides that face the eye are taken for back faces",
              "GL_CW で表と裏が入れ替わる：手前の面が裏面として扱われる"});
  }

  // ---- ranges ----

  // Values that the scene does not take stay its defaults, and are told.
  void check_ranges() {
    Scene usual;
    usual.objects.resize(scene_.objects.size());
    usual.lights.resize(scene_.lights.size());
    const Slots now = slots(scene_), before = slots(usual);
    for (std::size_t i = 0; i < now.size(); ++i) {
      try {
        assign(before[i], slot_tree(now[i]));
      } catch (const InputError& e) {
        complain(line_of(now[i].path), {"{0}: left out", "{0}。読み込まない"},
                 {{e.message(Language::english), e.message(Language::japanese)}});
        reset(now[i]);
      }
    }
  }

  // Where the parameter was given, roughly; 0: not known.
  long line_of(std::string_view path) const {
    if (path == "camera.fov" || path == "camera.height" || path == "camera.near" || path == "camera.far")
      return s_.lens.line;
    for (std::size_t i = 0; i < s_.lights.size(); ++i)
      if (path.starts_with("lights." + std::to_string(i) + ".")) return s_.lights[i].line;
    for (std::size_t i = 0; i < s_.drawn.size(); ++i)
      if (path.starts_with("objects." + std::to_string(i) + ".")) return s_.drawn[i].line;
    return path.starts_with("camera.") && !view_.empty() ? view_.back().line : 0;
  }

  const GlState& s_;
  const bool whole_;
  Complaints& complaints_;
  const MatrixCalls view_;
  Scene scene_;
  bool scales_ = false;
};

}  // namespace

Scene scene_of_state(const GlState& state, bool whole, Complaints& complaints) {
  return Converter(state, whole, complaints).run();
}

}  // namespace cg
