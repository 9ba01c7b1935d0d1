#include <algorithm>

#include "shading/gl_call_list.h"
#include "shading/light_notes.h"

namespace cg {

namespace {

// Mesa's fixed function has (N.L)^(N.L) for the highlight where the exponent is exactly 0 and a light has a position
// or a cone (ffvertex_prog.c: emit_lit after a replicated N.L).
bool meets_zero_exponent_fault(const Scene& scene, double n) {
  if (!(n < gl_smallest_shininess)) return false;
  for (const Light& light : scene.lights) {
    if (!light.enabled) continue;
    const bool directional = light.kind == LightKind::directional || std::abs(light.w) < 1e-6;
    if (!directional || (light.kind == LightKind::spot && light.cutoff != 180)) return true;
  }
  return false;
}

bool is_tracked(const Scene& scene, ColorMaterial which) {
  if (!follows_color(scene)) return false;
  const ColorMaterial tracked = scene.shading.color_material;
  const bool both = tracked == ColorMaterial::off || tracked == ColorMaterial::ambient_and_diffuse;
  return tracked == which || (both && (which == ColorMaterial::ambient || which == ColorMaterial::diffuse));
}

void add_shininess(const Scene& scene, const Material& m, const std::string& path, GlCallList& list) {
  GlCall& call = list.add("glMaterialf", {"GL_FRONT_AND_BACK", "GL_SHININESS"});
  call.quantity = Quantity::specular;
  call.numbers = {{.value = std::clamp(m.n, 0.0, gl_largest_shininess), .path = path + "n"}};
  if (m.n > gl_largest_shininess)
    call.notes.push_back(Words{"GL_SHININESS ends at 128: a larger n is drawn as 128",
                               "GL_SHININESS は 128 まで：それより大きい n は 128 として描く"});
  if (meets_zero_exponent_fault(scene, m.n)) {
    call.numbers[0].value = gl_smallest_shininess;
    call.notes.push_back(
        Words{"n = 0 is sent as 0.000001: some drivers get 0 wrong where a light has a position or a cone",
              "n = 0 は 0.000001 として送る：位置か円錐のある光源で 0 を誤るドライバーがあるため"});
  }
  if (scene.shading.reflection == Reflection::reflection_vector)
    call.notes.push_back(Words{"OpenGL has (N·H)^n here, not (R·V)^n: the same highlight needs about 4n",
                               "OpenGL は (R·V)^n でなく (N·H)^n：同じ広がりには約 4n が必要"});
}

// The colour that the glColor of the mistake gives, where the scene itself has no colour material: k_d.
void add_color(const Scene& scene, const Material& m, const std::string& path, GlCallList& list) {
  const bool own = scene.shading.color_material != ColorMaterial::off;
  GlCall& call = list.add("glColor3d", {});
  call.numbers = vector_numbers(path + (own ? "color" : "k_d"), own ? m.color : m.k_d);
  switch (scene.shading.color_material) {
    case ColorMaterial::ambient:
      call.quantity = Quantity::ambient;
      break;
    case ColorMaterial::specular:
      call.quantity = Quantity::specular;
      break;
    case ColorMaterial::emission:
      call.quantity = Quantity::emission;
      break;
    default:
      call.quantity = Quantity::diffuse;
  }
  if (scene.mistakes.no_color_material) call.mistake = "no_color_material";
}

bool takes_part(const RadiosityField* field, int object) { return field && field->objects[std::size_t(object)].mesh; }

// The emission of what takes part in a radiosity solution comes with each vertex; all else has its own.
void add_emission_of_vertices(bool part, GlCallList& list) {
  if (part) list.add("glColorMaterial", {"GL_FRONT_AND_BACK", "GL_EMISSION"}).path = "shading.ambient_source";
  GlCall& follow = list.add(part ? "glEnable" : "glDisable", {"GL_COLOR_MATERIAL"});
  follow.path = "shading.ambient_source";
}

void add_material(const Scene& scene, int object, GlCallList& list) {
  const Object& o = scene.objects[std::size_t(object)];
  const Material& m = material_of(scene, o);
  const std::string path = o.own_material ? "objects." + std::to_string(object) + ".material." : "material.";
  const std::string variable = gl_material_variable(scene, object);
  list.section = GlSection::material;
  const std::size_t first = list.calls.size();
  const RadiosityField* field = field_of_calls(scene);
  const bool part = takes_part(field, object);
  auto reflectance = [&](const char* token, const char* suffix, const char* name, const glm::dvec3& k, Quantity q) {
    list.add_array("glMaterialfv", {"GL_FRONT_AND_BACK", token}, variable + suffix, path + name, k, fixed(1), q);
  };
  // A reflectance that follows glColor where glColor says something else, so that the colour is written here.
  auto given = [&](const char* token, const char* suffix, const char* name, const glm::dvec3& k, Quantity q,
                   ColorMaterial which) {
    const bool tracked = is_tracked(scene, which);
    if (!tracked || field) reflectance(token, suffix, tracked ? "color" : name, tracked ? m.color : k, q);
  };
  if (part) {
    GlCall& none = list.add_array("glMaterialfv", {"GL_FRONT_AND_BACK", "GL_AMBIENT"}, variable + "_ambient", "",
                                  glm::dvec3(0), fixed(1), Quantity::ambient);
    none.notes.push_back(Words{"radiosity stands in for I_a k_a", "I_a k_a の代わりにラジオシティを使う"});
  } else {
    given("GL_AMBIENT", "_ambient", "k_a", m.k_a, Quantity::ambient, ColorMaterial::ambient);
  }
  given("GL_DIFFUSE", "_diffuse", "k_d", m.k_d, Quantity::diffuse, ColorMaterial::diffuse);
  given("GL_SPECULAR", "_specular", "k_s", m.k_s, Quantity::specular, ColorMaterial::specular);
  if (field) add_emission_of_vertices(part, list);
  const bool some_emission = std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& other) {
    return other.visible && material_of(scene, other).emission != glm::dvec3(0);
  });
  if ((some_emission || field) && !part)
    given("GL_EMISSION", "_emission", "emission", m.emission, Quantity::emission, ColorMaterial::emission);
  add_shininess(scene, m, path, list);
  if (follows_color(scene) && !field) add_color(scene, m, path, list);
  if (m.k_r != glm::dvec3(0) || m.k_t != glm::dvec3(0)) list.calls[first].notes.push_back(needs_rays_note);
  for (std::size_t i = first; i < list.calls.size(); ++i) list.calls[i].object = object;
}

void add_transform(const Object& o, int object, GlCallList& list) {
  const std::string path = "objects." + std::to_string(object) + ".transform.";
  const Transform& t = o.transform;
  list.section = GlSection::transform;
  const std::size_t first = list.calls.size();
  list.add("glPushMatrix", {});
  if (t.translate != glm::dvec3(0))
    list.add("glTranslated", {}).numbers = vector_numbers(path + "translate", t.translate);
  for (int axis = 2; axis >= 0; --axis) {
    if (t.rotate[axis] == 0) continue;
    GlCall& call = list.add("glRotated", {});
    call.numbers.push_back({.value = finite(t.rotate[axis]), .path = path + "rotate", .component = axis});
    for (int i = 0; i < 3; ++i) call.numbers.push_back(fixed(i == axis));
  }
  if (t.scale != glm::dvec3(1)) list.add("glScaled", {}).numbers = vector_numbers(path + "scale", t.scale);
  for (std::size_t i = first; i < list.calls.size(); ++i) list.calls[i].object = object;
}

}  // namespace

void add_object_calls(const Scene& scene, GlCallList& list) {
  int last = -1;  // whose material's calls stand last
  int units_on = 0;
  const RadiosityField* field = field_of_calls(scene);
  for (int i = 0; i < int(scene.objects.size()); ++i) {
    const Object& o = scene.objects[std::size_t(i)];
    if (!o.visible) continue;
    add_transform(o, i, list);
    // The program's own light model calls glColor, and so changes the reflectance that follows it.
    const bool color_changed = lights_by_hand(scene.mistakes) && follows_color(scene);
    const bool other = last < 0 || o.own_material || scene.objects[std::size_t(last)].own_material ||
                       takes_part(field, last) != takes_part(field, i);
    if (other || color_changed) add_material(scene, i, list);
    if (other) add_texture_calls(scene, i, units_on, list);
    last = i;
    list.section = GlSection::draw;
    list.add("draw_mesh", {"mesh" + std::to_string(i)}).object = i;
    list.section = GlSection::transform;
    list.add("glPopMatrix", {}).object = i;
  }
}

std::string gl_material_variable(const Scene& scene, int object) {
  return scene.objects[std::size_t(object)].own_material ? "material" + std::to_string(object) : "material";
}

}  // namespace cg
