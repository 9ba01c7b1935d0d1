// A probed pixel as JSON and as text.
#include <array>
#include <charconv>
#include <cmath>

#include "params/numbers.h"
#include "params/tree.h"
#include "workbench/probe.h"

namespace cg {

namespace {

Tree list_of(const glm::dvec3& v) { return Tree::List{v.x, v.y, v.z}; }

template <class E>
std::string id_of(E value) {
  return std::string(names_of<E>[std::size_t(value)].id);
}

Tree light_tree(int light) { return light < 0 ? Tree() : Tree(light); }

Tree terms_tree(const std::vector<ProbedTerm>& terms) {
  Tree::List out;
  for (const ProbedTerm& t : terms)
    out.push_back(Tree::Members{{"name", t.name}, {"light", light_tree(t.light)}, {"rgb", list_of(t.rgb)}});
  return out;
}

Tree tree_of(const ProbedLight& l, const Scene& scene, Reflection reflection) {
  return Tree::Members{{"light", l.light},
                       {"kind", id_of(scene.lights[std::size_t(l.light)].kind)},
                       {"L", list_of(l.L)},
                       {"R", list_of(l.R)},
                       {"H", list_of(l.H)},
                       {"cosine", l.cosine},
                       {"n_dot_l", l.n_dot_l},
                       {reflection == Reflection::half_vector ? "n_dot_h" : "r_dot_v", l.lobe_cosine},
                       {"lobe", l.lobe},
                       {"attenuation", l.attenuation},
                       {"spot", l.spot},
                       {"distance", l.distance > 0 ? Tree(l.distance) : Tree()},
                       {"I_a", list_of(l.ambient)},
                       {"I_d", list_of(l.diffuse)},
                       {"I_s", list_of(l.specular)}};
}

void add_vectors(Tree& out, const LitPoint& p, const Scene& scene, Reflection reflection) {
  out.at("P") = list_of(p.P);
  out.at("N") = list_of(p.N);
  out.at("normal_length") = p.normal_length;
  out.at("V") = list_of(p.V);
  Tree::List lights;
  for (const ProbedLight& l : p.lights) lights.push_back(tree_of(l, scene, reflection));
  out.at("lights") = std::move(lights);
}

Tree tree_of(const LitPoint& p, const Scene& scene, Reflection reflection) {
  Tree out;
  out.at("weight") = p.weight;
  add_vectors(out, p, scene, reflection);
  out.at("terms") = terms_tree(p.terms);
  out.at("sum") = list_of(p.sum);
  out.at("clamped") = list_of(p.clamped);
  return out;
}

void add_surface(Tree& out, const Probe& p, const Scene& scene) {
  out.at("object") = p.object;
  out.at("triangle") = p.triangle;
  out.at("front") = p.front;
  out.at("depth") = p.depth;
  out.at("shading") = id_of(p.mode);
  out.at("reflection") = id_of(p.reflection);
  out.at("clamp") = p.clamps;
  if (p.radiosity) out.at("ambient_source") = "radiosity";
  out.at("I_a") = list_of(p.global_ambient);
  out.at("k_a") = list_of(p.material.k_a);
  out.at("k_d") = list_of(p.material.k_d);
  out.at("k_s") = list_of(p.material.k_s);
  out.at("emission") = list_of(p.material.emission);
  out.at("n") = p.material.n;
  add_vectors(out, p.here, scene, p.reflection);
  Tree::List vertices;
  for (const LitPoint& v : p.vertices) vertices.push_back(tree_of(v, scene, p.reflection));
  out.at("vertices") = std::move(vertices);
}

// With four digits behind the point and no needless zeros; a very small number with three that count.
std::string digits(double v) {
  const double size = std::abs(v);
  if (size < 1e-30) return "0";
  if (!(size < 1e11)) return number_text(v);
  if (size >= 1e-4) return number_text(std::round(v * 1e4) / 1e4);
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), v, std::chars_format::scientific, 2).ptr};
}

std::string vector_text(const glm::dvec3& v) {
  return "(" + digits(v.x) + ", " + digits(v.y) + ", " + digits(v.z) + ")";
}

class Report {
 public:
  Report(const Probe& p, const Scene& scene, Language language) : p_(p), scene_(scene), language_(language) {}

  std::string text() {
    head();
    if (p_.covered && p_.object >= 0) {
      surface();
      if (p_.vertices.empty()) point(p_.here, "  ");
      for (std::size_t i = 0; i < p_.vertices.size(); ++i) vertex(i);
    }
    if (p_.mode == ShadingMode::gouraud && !p_.vertices.empty())
      line("  " + say({"The vertices' terms, interpolated:", "頂点の各項を補間したもの："}));
    terms(p_.terms);
    result();
    return std::move(out_);
  }

 private:
  std::string say(Words words) const { return std::string(words.in(language_)); }
  void line(const std::string& text) { out_ += text + "\n"; }

  void head() {
    line(p_.technique + ": " + std::to_string(p_.size.x) + "×" + std::to_string(p_.size.y) +
         say({", pixel (", "、画素 ("}) + std::to_string(p_.pixel.x) + ", " + std::to_string(p_.pixel.y) + ")");
    if (!p_.covered) line("  " + say({"Nothing is drawn here: the background", "何も描かれていない。背景の色"}));
    if (p_.covered && p_.object < 0) line("  " + say({"The triangle was not found", "どの三角形か分からない"}));
  }

  void surface() {
    const std::string& name = scene_.objects[std::size_t(p_.object)].name;
    line("  " + say({"object ", "物体 "}) + std::to_string(p_.object) + (name.empty() ? "" : " " + name) +
         say({", triangle ", "、三角形 "}) + std::to_string(p_.triangle) +
         (p_.front ? say({", front face", "、表"}) : say({", back face", "、裏"})) + say({", depth ", "、奥行き "}) +
         digits(p_.depth));
    if (p_.mode == ShadingMode::gouraud)
      line("  " + say({"Gouraud: light is computed at three vertices, their colours are interpolated",
                       "グロー：三つの頂点で光源計算をし、その色を補間する"}));
    if (p_.mode == ShadingMode::flat)
      line("  " + say({"Flat: light is computed at the last vertex, with the normal of the face",
                       "フラット：最後の頂点で、面の法線を使って光源計算をする"}));
    if (p_.mode == ShadingMode::phong)
      line("  " + say({"Phong: the normal is interpolated, light is computed here",
                       "フォン：法線を補間し、ここで光源計算をする"}));
  }

  void point(const LitPoint& at, const std::string& indent) {
    std::string vectors = indent + "P = " + vector_text(at.P) + "  N = " + vector_text(at.N);
    if (std::abs(at.normal_length - 1) > 1e-4) vectors += "  |N| = " + digits(at.normal_length);
    line(vectors + "  V = " + vector_text(at.V));
    for (const ProbedLight& l : at.lights) light(l, indent);
  }

  void light(const ProbedLight& l, const std::string& indent) {
    const Light& given = scene_.lights[std::size_t(l.light)];
    line(indent + say({"light ", "光源 "}) + std::to_string(l.light) + " (" +
         std::string(names_of<LightKind>[std::size_t(given.kind)].label.in(language_)) + "): L = " + vector_text(l.L) +
         "  R = " + vector_text(l.R) + "  H = " + vector_text(l.H));
    const bool blinn = p_.reflection == Reflection::half_vector;
    std::string factors = indent + "  N·L = " + digits(l.cosine);
    if (l.cosine < 0) factors += say({" (behind: 0)", "（裏側なので 0）"});
    factors += std::string(blinn ? "  N·H = " : "  R·V = ") + digits(l.lobe_cosine) + "  ^" + digits(p_.material.n) +
               " = " + digits(l.lobe);
    line(factors + say({"  attenuation ", "  減衰 "}) + digits(l.attenuation) + say({"  spot ", "  スポット "}) +
         digits(l.spot));
  }

  void vertex(std::size_t i) {
    const LitPoint& at = p_.vertices[i];
    const bool several = p_.vertices.size() > 1;
    line("  " + say({"vertex ", "頂点 "}) + std::to_string(several ? i + 1 : std::size_t(3)) +
         (several ? say({", weight ", "、重み "}) + digits(at.weight) : ""));
    point(at, "    ");
    if (!several) return;
    row(at.sum, say({"sum", "合計"}), "    ");
    if (p_.clamps) row(at.clamped, say({"after clamping to 0..1", "0..1 に制限した後"}), "    ");
  }

  void row(const glm::dvec3& rgb, const std::string& name, const std::string& indent) {
    std::string text = indent;
    for (int c = 0; c < 3; ++c) {
      const std::string number = digits(rgb[c]);
      text += number + std::string(number.size() < 9 ? 9 - number.size() : 1, ' ');
    }
    line(text + name);
  }

  std::string name_of(const ProbedTerm& t) const {
    const std::string of = t.light < 0 ? "" : say({", light ", "、光源 "}) + std::to_string(t.light);
    if (t.name == "emission") return "E" + say({", emission", "、自己発光"});
    if (t.name == "global-ambient") return "I_a k_a" + say({", global ambient", "、全体の環境光"});
    if (t.name == "radiosity") return say({"radiosity, light of other surfaces", "ラジオシティ、他の面からの光"});
    if (t.name == "ambient") return "I_a k_a" + of;
    if (t.name == "diffuse") return "I_d k_d (N·L)" + of;
    if (t.name == "specular")
      return (p_.reflection == Reflection::half_vector ? "I_s k_s (N·H)^n" : "I_s k_s (R·V)^n") + of;
    return say({"background", "背景"});
  }

  void terms(const std::vector<ProbedTerm>& all) {
    for (const ProbedTerm& t : all) row(t.rgb, name_of(t), "  ");
  }

  void result() {
    row(p_.sum, say({"sum", "合計"}), "  ");
    if (p_.covered && p_.clamps)
      row(p_.clamped,
          p_.mode == ShadingMode::gouraud ? say({"after clamping at the vertices", "頂点で 0..1 に制限した後"})
                                          : say({"after clamping to 0..1", "0..1 に制限した後"}),
          "  ");
    row(p_.frame, say({"in the picture", "画像の値"}), "  ");
  }

  const Probe& p_;
  const Scene& scene_;
  const Language language_;
  std::string out_;
};

}  // namespace

Tree json_of(const Probe& p, const Scene& scene) {
  Tree out;
  out.at("technique") = p.technique;
  out.at("pixel") = Tree::List{p.pixel.x, p.pixel.y};
  out.at("width") = p.size.x;
  out.at("height") = p.size.y;
  out.at("covered") = p.covered;
  out.at("terms") = terms_tree(p.terms);
  out.at("sum") = list_of(p.sum);
  out.at("clamped") = list_of(p.clamped);
  out.at("frame") = list_of(p.frame);
  if (p.covered && p.object >= 0) add_surface(out, p, scene);
  return out;
}

std::string text_of(const Probe& probe, const Scene& scene, Language language) {
  return Report(probe, scene, language).text();
}

}  // namespace cg
