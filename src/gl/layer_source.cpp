#include "gl/layer_source.h"

#include <algorithm>

namespace cg {

namespace {

std::string number(int i) { return std::to_string(i); }

bool is_of_material(LayerTarget target) { return is_before_light(target) && target != LayerTarget::normal; }

// Two sets share an attribute.
std::string attribute(int uv) { return "uv_pair" + number(uv / 2) + (uv % 2 == 0 ? ".xy" : ".zw"); }

struct Varying {
  int uv;
  bool perspective;
  std::string name() const { return (perspective ? "uv" : "affine_uv") + number(uv); }
  friend bool operator==(const Varying&, const Varying&) = default;
};

Varying varying(const LayerUse& l) { return {l.uv, l.perspective}; }

// What the fragment shader reads, each once.
std::vector<Varying> varyings(const std::vector<LayerUse>& layers, bool phong) {
  std::vector<Varying> out;
  const auto add = [&](const Varying& v) {
    if (std::find(out.begin(), out.end(), v) == out.end()) out.push_back(v);
  };
  for (const LayerUse& l : layers) {
    if (!phong && is_before_light(l.target)) continue;
    add(varying(l));
    if (l.target == LayerTarget::normal) add({l.uv, true});  // of the tangent frame
  }
  return out;
}

std::string declared(const std::vector<Varying>& varyings, const char* direction) {
  std::string out;
  for (const Varying& v : varyings)
    out += std::string(v.perspective ? "" : "noperspective ") + direction + " vec2 " + v.name() + ";\n";
  return out;
}

// C and the picture's texel: what is there after the layer.
std::string layer_function(int i, const LayerUse& l) {
  constexpr const char* names[] = {"replaced", "modulated", "decalled", "blended", "added"};
  const std::string n = number(i), layer = "layers[" + n + "]";
  const std::string colour = l.blend == LayerBlend::blend ? ", " + layer + ".blend_colour" : "";
  return "vec4 layer" + n + "(vec4 C, vec4 texel) {\n  vec4 T = vec4(texel.rgb * " + layer +
         ".scale, texel.a);\n  return C + (" + names[int(l.blend)] + "(C, T" + colour + ") - C) * " + layer +
         ".amount;\n}\n";
}

std::string picture(int i) { return "picture" + number(i) + "()"; }

// `where`: the place in uv; `read`: the function that reads there and what it takes first.
std::string picture_function(int i, const std::string& read, const std::string& where) {
  const std::string n = number(i);
  return "vec4 " + picture(i) + " { return " + read + "texture_point(" + n + ", " + where + ")); }\n";
}

std::string material_line(int i, LayerTarget target) {
  const std::string m = "  material." + std::string(names_of<LayerTarget>[std::size_t(target)].id);
  const std::string call = " = layer" + number(i) + "(";
  if (target != LayerTarget::n) return m + call + "vec4(" + m.substr(2) + ", 1.0), " + picture(i) + ").rgb;\n";
  return "  vec4 n" + number(i) + " = " + picture(i) + ";\n" + m + " = clamp(layer" + number(i) +
         "(vec4(material.n), n" + number(i) + ".rrra).r, 0.0, 1e6);\n";
}

std::string apply_function(const std::vector<LayerUse>& layers) {
  std::string out;
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (is_of_material(layers[i].target)) out += material_line(int(i), layers[i].target);
  return out.empty() ? "" : "void apply_layers() {\n  material = given;\n" + out + "}\n";
}

std::string normal_lines(int i, const LayerUse& l) {
  const std::string n = number(i), uv = Varying{l.uv, true}.name();
  const std::string strength = "layers[" + n + "].scale * layers[" + n + "].amount";
  const std::string steps = "dFdx(P), dFdy(P), texture_difference(" + n + ", dFdx(" + uv + ")), texture_difference(" +
                            n + ", dFdy(" + uv + "))";
  const std::string changed = l.bump == BumpKind::height
                                  ? "bumped_normal(N, frame, height_gradient(pictures[" + n + "], " + n +
                                        ", texture_point(" + n + ", " + varying(l).name() + ")) * (" + strength + "))"
                                  : "mapped_normal(N, frame, " + picture(i) + ".rgb, " + strength + ")";
  return "  if (tangent_frame(" + steps + ", frame)) N = " + changed + ";\n";
}

std::string normal_function(const std::vector<LayerUse>& layers) {
  std::string out;
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (layers[i].target == LayerTarget::normal) out += normal_lines(int(i), layers[i]);
  if (out.empty()) return "";
  return "vec3 layered_normal(vec3 N, vec3 P) {\n  TangentFrame frame;\n  float length = length_and_unit(N, N);\n" +
         out + "  return length * N;\n}\n";
}

std::string composed_function(const std::vector<LayerUse>& layers) {
  std::string opacity, colour;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string n = number(int(i)), call = "layer" + n + "(";
    if (layers[i].target == LayerTarget::opacity)
      opacity += "  C.a = clamp(" + call + "vec4(C.a), " + picture(int(i)) + ".aaaa).r, 0.0, 1.0);\n";
    if (layers[i].target == LayerTarget::colour) colour += "  C = " + call + "C, " + picture(int(i)) + ");\n";
  }
  const std::string out = opacity + colour;
  return out.empty() ? "" : "vec4 layered_colour(vec4 C) {\n" + out + "  return C;\n}\n";
}

}  // namespace

std::string LayerUse::text() const {
  std::string out(names_of<LayerTarget>[std::size_t(target)].id);
  out += target == LayerTarget::normal ? bump == BumpKind::height ? " height" : " map"
                                       : " " + std::string(names_of<LayerBlend>[std::size_t(blend)].id);
  return out + (perspective ? " uv" : " affine_uv") + number(uv);
}

std::vector<LayerUse> layer_uses(const LayerUv& layers) {
  std::vector<LayerUse> out;
  for (std::size_t i = 0; i < layers.layers.size(); ++i) {
    const TextureLayer& l = *layers.layers[i];
    out.push_back({int(i), layers.set_of_layer[i], l.perspective, l.target, l.blend, l.bump});
  }
  return out;
}

std::string vertex_layers(const std::vector<LayerUse>& layers, bool phong) {
  int sets = 0;
  for (const LayerUse& l : layers) sets = std::max(sets, l.uv + 1);
  std::string out, passed;
  for (int pair = 0; 2 * pair < sets; ++pair) out += "in vec4 uv_pair" + number(pair) + ";\n";
  const std::vector<Varying> wanted = varyings(layers, phong);
  for (const Varying& v : wanted) passed += "  " + v.name() + " = " + attribute(v.uv) + ";\n";
  out += declared(wanted, "out") + "void pass_uv() {\n" + passed + "}\n";
  if (phong) return out;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!is_of_material(layers[i].target)) continue;
    const std::string n = number(int(i));
    out += layer_function(int(i), layers[i]) +
           picture_function(int(i), "texture_at_vertex(pictures[" + n + "], " + n + ", ", attribute(layers[i].uv));
  }
  return out + apply_function(layers);
}

std::string fragment_layers(const std::vector<LayerUse>& layers, bool phong) {
  std::string out = declared(varyings(layers, phong), "in");
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const LayerUse& l = layers[i];
    if (!phong && is_before_light(l.target)) continue;
    if (l.target != LayerTarget::normal) out += layer_function(int(i), l);
    if (l.target == LayerTarget::normal && l.bump == BumpKind::height) continue;
    out += picture_function(int(i), "texture(pictures[" + number(int(i)) + "], ", varying(l).name());
  }
  if (phong) out += apply_function(layers) + normal_function(layers);
  return out + composed_function(layers);
}

}  // namespace cg
