#include <algorithm>

#include "shading/gl_call_list.h"
#include "shading/layer_uv.h"

namespace cg {

namespace {

const char* token_of(Wrap wrap) {
  constexpr const char* tokens[] = {"GL_REPEAT", "GL_MIRRORED_REPEAT", "GL_CLAMP_TO_EDGE", "GL_CLAMP_TO_BORDER"};
  return tokens[int(wrap)];
}

const char* token_of(MinFilter filter) {
  constexpr const char* tokens[] = {"GL_NEAREST",
                                    "GL_LINEAR",
                                    "GL_NEAREST_MIPMAP_NEAREST",
                                    "GL_LINEAR_MIPMAP_NEAREST",
                                    "GL_NEAREST_MIPMAP_LINEAR",
                                    "GL_LINEAR_MIPMAP_LINEAR"};
  return tokens[int(filter)];
}

const char* token_of(LayerBlend blend) {
  constexpr const char* tokens[] = {"GL_REPLACE", "GL_MODULATE", "GL_DECAL", "GL_BLEND", "GL_ADD"};
  return tokens[int(blend)];
}

std::string unit_token(int unit) { return "GL_TEXTURE" + std::to_string(unit); }

// The calls of one texture unit.
class OneLayer {
 public:
  OneLayer(const TextureLayer& layer, std::string path, std::string variable, GlCallList& list)
      : layer_(layer), path_(std::move(path)), variable_(std::move(variable)), list_(list) {}

  void add(bool matrix) {
    list_.add("glEnable", {"GL_TEXTURE_2D"}).path = path_ + "visible";
    list_.add("glBindTexture", {"GL_TEXTURE_2D", variable_}).path = path_ + "image";
    sampling();
    environment();
    if (matrix) texture_matrix();
  }

 private:
  GlCall& parameter(std::string_view function, const char* what, const char* name) {
    GlCall& call = list_.add(function, {"GL_TEXTURE_2D", what});
    call.path = path_ + "sampling." + name;
    return call;
  }

  void choice(const char* what, const char* name, const char* value) {
    parameter("glTexParameteri", what, name).tokens.push_back(value);
  }

  void number(const char* what, const char* name, double value) {
    GlCall& call = parameter("glTexParameterf", what, name);
    call.numbers = {{.value = value, .path = call.path}};
    call.path.clear();
  }

  void sampling() {
    const Sampling& s = layer_.sampling;
    choice("GL_TEXTURE_WRAP_S", "wrap_s", token_of(s.wrap_s));
    choice("GL_TEXTURE_WRAP_T", "wrap_t", token_of(s.wrap_t));
    choice("GL_TEXTURE_MAG_FILTER", "mag_filter", s.mag_filter == MagFilter::linear ? "GL_LINEAR" : "GL_NEAREST");
    choice("GL_TEXTURE_MIN_FILTER", "min_filter", token_of(s.min_filter));
    if (s.bias != 0) number("GL_TEXTURE_LOD_BIAS", "bias", s.bias);
    if (s.anisotropy > 1) number("GL_TEXTURE_MAX_ANISOTROPY_EXT", "anisotropy", s.anisotropy);
    if (s.wrap_s != Wrap::border && s.wrap_t != Wrap::border) return;
    list_.add_array("glTexParameterfv", {"GL_TEXTURE_2D", "GL_TEXTURE_BORDER_COLOR"}, variable_ + "_border",
                    path_ + "sampling.border", s.border,
                    {.value = s.border_alpha, .path = path_ + "sampling.border_alpha"}, Quantity::none);
  }

  void environment() {
    list_.add("glTexEnvi", {"GL_TEXTURE_ENV", "GL_TEXTURE_ENV_MODE", token_of(layer_.blend)}).path = path_ + "blend";
    if (layer_.blend != LayerBlend::blend) return;
    list_.add_array("glTexEnvfv", {"GL_TEXTURE_ENV", "GL_TEXTURE_ENV_COLOR"}, variable_ + "_blend_colour",
                    path_ + "blend_colour", layer_.blend_colour, fixed(1), Quantity::none);
  }

  void texture_matrix() {
    const TextureMatrix& m = layer_.matrix;
    const auto of = [&](double value, const char* name) {
      return GlNumber{.value = value, .path = path_ + "matrix." + name};
    };
    list_.add("glMatrixMode", {"GL_TEXTURE"});
    list_.add("glLoadIdentity", {});
    if (m.offset_u != 0 || m.offset_v != 0)
      list_.add("glTranslated", {}).numbers = {of(m.offset_u, "offset_u"), of(m.offset_v, "offset_v"), fixed(0)};
    if (m.turn != 0) list_.add("glRotated", {}).numbers = {of(m.turn, "turn"), fixed(0), fixed(0), fixed(1)};
    if (m.repeat_u != 1 || m.repeat_v != 1)
      list_.add("glScaled", {}).numbers = {of(m.repeat_u, "repeat_u"), of(m.repeat_v, "repeat_v"), fixed(1)};
    list_.add("glMatrixMode", {"GL_MODELVIEW"});
  }

  const TextureLayer& layer_;
  std::string path_, variable_;
  GlCallList& list_;
};

// What all objects use together: how many units, and whether a texture matrix is other than 1.
struct Units {
  int count = 0;
  bool matrix = false;
};

Units units_of(const Scene& scene) {
  Units units;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (!scene.objects[i].visible) continue;
    const std::vector<const TextureLayer*> layers = fixed_function_layers(scene, int(i));
    units.count = std::max(units.count, int(layers.size()));
    for (const TextureLayer* l : layers) units.matrix = units.matrix || l->matrix != TextureMatrix{};
  }
  return units;
}

// Only what has a texture is tested.
void alpha_test(const Scene& scene, bool on, bool was_on, GlCallList& list) {
  if (on == was_on) return;
  list.add(on ? "glEnable" : "glDisable", {"GL_ALPHA_TEST"}).path = "shading.transparency";
  if (!on) return;
  list.add("glAlphaFunc", {"GL_GREATER"}).numbers = {
      {.value = scene.shading.alpha_threshold, .path = "shading.alpha_threshold"}};
}

}  // namespace

std::vector<const TextureLayer*> fixed_function_layers(const Scene& scene, int object) {
  std::vector<const TextureLayer*> out;
  for (const TextureLayer* l : layer_uv(scene, std::size_t(object), field_of_calls(scene)).layers)
    if (l->target == LayerTarget::colour && int(out.size()) < gl_texture_unit_limit) out.push_back(l);
  return out;
}

void add_texture_calls(const Scene& scene, int object, int& units_on, GlCallList& list) {
  const Units units = units_of(scene);
  if (units.count == 0) return;
  const Object& o = scene.objects[std::size_t(object)];
  const std::vector<TextureLayer>& all = material_of(scene, o).layers;
  const std::vector<const TextureLayer*> layers = fixed_function_layers(scene, object);
  const std::size_t first = list.calls.size();
  list.section = GlSection::material;
  const auto choose = [&](int unit) {
    if (units.count > 1) list.add("glActiveTexture", {unit_token(unit)});
  };
  for (int unit = 0; unit < int(layers.size()); ++unit) {
    const auto index = layers[std::size_t(unit)] - all.data();
    const std::string n = std::to_string(index);
    const std::string material = o.own_material ? "objects." + std::to_string(object) + ".material" : "material";
    choose(unit);
    const std::size_t begin = list.calls.size();
    OneLayer(*layers[std::size_t(unit)], material + ".layers." + n + ".",
             gl_material_variable(scene, object) + "_texture" + n, list)
        .add(units.matrix);
    for (std::size_t i = begin; i < list.calls.size(); ++i) list.calls[i].layer = int(index);
  }
  for (int unit = int(layers.size()); unit < units_on; ++unit) {
    choose(unit);
    list.add("glDisable", {"GL_TEXTURE_2D"});
  }
  if (scene.shading.transparency == Transparency::test) alpha_test(scene, !layers.empty(), units_on > 0, list);
  units_on = int(layers.size());
  for (std::size_t i = first; i < list.calls.size(); ++i) list.calls[i].object = object;
}

void add_texture_coordinates(const Scene& scene, GlCallList& list) {
  const int units = units_of(scene).count;
  for (int unit = 0; unit < units; ++unit) {
    const std::string uv = units > 1 ? "uv" + std::to_string(unit) : "uv";
    if (unit == 0)
      list.add("glTexCoord2fv", {uv});
    else
      list.add("glMultiTexCoord2fv", {unit_token(unit), uv});
  }
}

}  // namespace cg
