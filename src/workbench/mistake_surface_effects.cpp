// The mistakes with normals, with the material, and with what is seen.
#include <cmath>

#include "raster/interpolation.h"
#include "raster/triangle_raster.h"
#include "shading/eye_normal.h"
#include "workbench/mistake_scene.h"

namespace cg {

MistakeEffect no_normalize_effect(const MistakeScene& s) {
  MistakeEffect e{false, 1, {}};
  if (s.scene.shading.normal_length == NormalLength::off) {
    e.text = Words{"The scene takes normals as they come anyway: choose GL_NORMALIZE to see it.",
                   "このシーンはもともと法線をそのまま使う。GL_NORMALIZE を選べば見える。"};
    return e;
  }
  for (const MistakeObject& o : s.objects)
    for (int axis = 0; axis < 3; ++axis) {
      // Turning keeps lengths: of T Rz Ry Rx S only the scale changes them, by its inverse.
      const double length = 1 / std::abs(s.scene.objects[std::size_t(o.index)].transform.scale[axis]);
      if (std::abs(std::log(length)) > std::abs(std::log(e.value))) e.value = length;
    }
  e.shows = std::abs(e.value - 1) > 1e-3;
  const std::string n = short_number(e.value);
  e.text = e.shows ? Text("Normals reach the light model " + n + " long where they should be 1: N·L is " + n +
                              " times what it should be.",
                          "法線の長さが 1 でなく " + n + " のまま計算され、N·L は " + n + " 倍になる。")
                   : Text(Words{"No object is scaled, so GL_NORMALIZE does nothing here: scale one to see it.",
                                "拡大縮小した物体がないので GL_NORMALIZE の有無で変わらない。拡大縮小すれば見える。"});
  return e;
}

MistakeEffect flipped_normals_effect(const MistakeScene& s) {
  const EyeLight<double>& light = s.eye_lights.lights[0];
  std::size_t meant = 0, drawn = 0, all = 0;
  for (const MistakeObject& o : s.objects)
    for (std::size_t i = 0; i < o.P.size(); ++i) {
      const double cosine = glm::dot(o.N[i], light.directional ? light.position : unit(light.position - o.P[i]));
      meant += cosine > 0, drawn += cosine < 0, ++all;
    }
  MistakeEffect e;
  e.value = double(drawn) / double(all);
  const std::string i = std::to_string(light.index), right = percent(double(meant) / double(all)),
                    wrong = percent(e.value);
  e.text = {"N·L > 0 at " + wrong + " of the vertices, those turned away from light " + i + ", instead of the " +
                right + " that face it.",
            "N·L > 0 となるのは、光源 " + i + " を向いた頂点 " + right + " でなく、背を向けた " + wrong + "。"};
  return e;
}

MistakeEffect no_normals_effect(const MistakeScene& s) {
  const MistakeObject& o = s.objects[0];
  const EyeLight<double>& light = s.eye_lights.lights[0];
  const auto normals = normals_to_eye<double>(s.view * matrix(s.scene.objects[std::size_t(o.index)].transform),
                                              s.scene.shading.normal_length);
  const glm::dvec3 P(s.view * glm::dvec4(o.middle, 1));
  MistakeEffect e;
  e.value =
      glm::dot(eye_normal(normals, glm::dvec3(0, 0, 1)), light.directional ? light.position : unit(light.position - P));
  const std::string i = std::to_string(light.index), n = short_number(e.value);
  e.text = {"Every vertex has the normal (0, 0, 1): N·L is " + std::string(light.directional ? "" : "about ") + n +
                " all over the object (light " + i + ").",
            "どの頂点でも法線は (0, 0, 1)。物体全体で N·L は" + std::string(light.directional ? " " : "およそ ") + n +
                "（光源 " + i + "）。"};
  return e;
}

MistakeEffect no_color_material_effect(const MistakeScene& s) {
  // OpenGL's own reflectances (GL 2.1, table 2.10), of a material that nobody set.
  const EyeMaterial<double> initial{glm::dvec3(0.2), glm::dvec3(0.8), glm::dvec3(0), glm::dvec3(0), 0};
  const ColorMaterial tracked = s.scene.shading.color_material;
  MistakeEffect e;
  const char* name = "k_d";
  for (const MistakeObject& o : s.objects) {
    const auto meant = eye_material<double>(material_of(s.scene, s.scene.objects[std::size_t(o.index)]), tracked);
    const auto compare = [&](const char* k, const glm::dvec3& right, const glm::dvec3& wrong) {
      const glm::dvec3 d = glm::abs(right - wrong);
      if (const double largest = std::max({d.x, d.y, d.z}); largest > e.value) e.value = largest, name = k;
    };
    const bool both = tracked == ColorMaterial::off || tracked == ColorMaterial::ambient_and_diffuse;
    if (both || tracked == ColorMaterial::diffuse) compare("k_d", meant.k_d, initial.k_d);
    if (both || tracked == ColorMaterial::ambient) compare("k_a", meant.k_a, initial.k_a);
    if (tracked == ColorMaterial::specular) compare("k_s", meant.k_s, initial.k_s);
    if (tracked == ColorMaterial::emission) compare("E", meant.emission, initial.emission);
  }
  e.shows = e.value > 1e-3;
  const std::string n = short_number(e.value), k = name;
  e.text = e.shows
               ? Text("glColor is ignored and the material stays OpenGL's own (k_a 0.2, k_d 0.8, k_s 0): " + k +
                          " is off by up to " + n + ".",
                      "glColor は無視され、素材は OpenGL の初期値（k_a 0.2、k_d 0.8、k_s 0）のまま。" + k + " は最大 " +
                          n + " ずれる。")
               : Text(Words{"The material is OpenGL's own grey anyway (k_a 0.2, k_d 0.8): give it a colour to see it.",
                            "素材が OpenGL の初期値の灰色（k_a 0.2、k_d 0.8）と同じ。色を付ければ見える。"});
  return e;
}

namespace {

// What is seen without a depth test: the triangle drawn last. Each is given a depth before all that came earlier.
void find_last(const Drawing& drawing, VisibilityBuffer& out) {
  const Band band{&out, 0, out.height};
  const float step = 1 / (float(drawing.objects.back().end) + 2);
  std::uint32_t drawn = 0;
  for (const DrawnObject& o : drawing.objects)
    for_each_triangle(o, {0, o.surface->triangle_count()},
                      [&](WindowVertex v0, WindowVertex v1, WindowVertex v2, std::uint32_t id) {
                        ++drawn;
                        for (WindowVertex* v : {&v0, &v1, &v2}) v->z = 1 - float(drawn) * step;
                        draw_triangle(band, v0, v1, v2, id);
                      });
}

}  // namespace

MistakeEffect no_depth_test_effect(const MistakeScene& s, const View& view) {
  Progress progress;
  Workers workers(1, progress);
  const Drawing drawing = drawing_of(s.scene, view, workers);
  std::size_t covered = 0, wrong = 0;
  if (!drawing.objects.empty()) {
    VisibilityBuffer nearest, last;
    nearest.resize(view.width, view.height), last.clear(view.width, view.height);
    ThreadsMemory memory;
    find_visible(drawing, workers, memory, nearest);
    find_last(drawing, last);
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) {
        covered += nearest.triangle(x, y) != no_triangle;
        wrong += nearest.triangle(x, y) != last.triangle(x, y);
      }
  }
  MistakeEffect e;
  e.value = covered > 0 ? double(wrong) / double(covered) : 0;
  e.shows = wrong > 0;
  const std::string n = percent(e.value);
  e.text = e.shows ? Text(n + " of the covered pixels show a face that should be hidden: the one drawn last.",
                          "物体の画素の " + n + " に、隠れるはずの面（最後に描いた面）が見える。")
                   : Text(Words{"By chance what is nearest is drawn last everywhere: turn the camera to see it.",
                                "どの画素でもたまたま最も手前の面が最後に描かれる。カメラを回せば見える。"});
  return e;
}

MistakeEffect swapped_front_face_effect(const MistakeScene& s, const View& view) {
  Progress progress;
  Workers workers(1, progress);
  std::size_t front = 0, all = 0;
  const Drawing drawing = drawing_of(s.scene, view, workers);
  for (const DrawnObject& o : drawing.objects)
    for_each_triangle(o, {0, o.surface->triangle_count()},
                      [&](const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2, std::uint32_t) {
                        front += is_front_face({&v0, &v1, &v2}), ++all;
                      });
  MistakeEffect e;
  e.value = all > 0 ? double(front) / double(all) : 0;
  e.shows = all > 0;
  const std::string n = percent(e.value);
  if (!e.shows)
    e.text = Words{"No triangle is in the picture: turn the camera to see it.",
                   "画面に三角形がない。カメラを回せば見える。"};
  else if (s.scene.shading.two_sided)
    e.text = {n + " of the triangles face the eye and are lit as backs, with -N.",
              "視点を向いた三角形 " + n + " が裏とみなされ、-N で照らされる。"};
  else
    e.text = {"GL_CULL_FACE removes the " + n + " of the triangles that face the eye; the insides remain.",
              "GL_CULL_FACE が、視点を向いた三角形 " + n + " を捨て、内側だけが残る。"};
  return e;
}

}  // namespace cg
