#include "ui/parameter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/shape.h"
#include "ui/app.h"
#include "ui/row.h"
#include "ui/widgets.h"

namespace cg {
namespace {

// Stores, or tells the user why not.
void store(App& app, const Slot& slot, const Tree& value) {
  try {
    assign(slot, value);
  } catch (const InputError& e) {
    say(app, e);
  }
}

void store_typed(App& app, const Slot& slot, const std::string& text) {
  try {
    assign_text(slot, text);
  } catch (const InputError& e) {
    say(app, e);
  }
}

Tree list_of(const glm::dvec3& v) { return Tree::List{v.x, v.y, v.z}; }

// The label on a line of its own, for what has no symbol.
void label_above(App& app, const Slot& slot) {
  heading(app, slot.about->label.in(app.language()));
  if (wants_tooltip(app)) describe(app, *slot.about, {});
}

void number(App& app, const Slot& slot, double value) {
  if (slot.about->symbol.empty()) label_above(app, slot);
  const RowChange c = number_row(app, {.id = "n",
                                       .symbol = slot.about->symbol,
                                       .about = slot.about,
                                       .value = value,
                                       .whole = std::holds_alternative<int*>(slot.value),
                                       .differs = !is_initial(slot)});
  if (c.moved) store(app, slot, *c.moved);
  if (c.typed) store_typed(app, slot, *c.typed);
  if (c.reset) reset(slot);
}

// A row a coordinate: x, y, z. Each is set back by itself.
void coordinates(App& app, const Slot& slot, const glm::dvec3& value, bool labelled) {
  if (labelled) label_above(app, slot);
  const glm::dvec3& initial = **std::get_if<glm::dvec3*>(&slot.initial);
  constexpr std::array<const char*, 3> letters{"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const RowChange c = number_row(app, {.id = letters[std::size_t(i)],
                                         .symbol = letters[std::size_t(i)],
                                         .about = slot.about,
                                         .value = value[i],
                                         .differs = value[i] != initial[i]});
    glm::dvec3 next = value;
    if (c.moved) next[i] = *c.moved;
    if (c.reset) next[i] = initial[i];
    if (c.moved || c.reset) store(app, slot, list_of(next));
    if (c.typed) {  // one number for this coordinate, or three for all
      if (c.typed->find(',') != std::string::npos) return store_typed(app, slot, *c.typed);
      double one = value[i];
      const Slot single{slot.path, slot.about, &one, &one};
      store_typed(app, single, *c.typed);
      next[i] = one;
      if (one != value[i]) store(app, slot, list_of(next));
    }
  }
}

void pick_colour(App& app, const Slot& slot, const glm::dvec3& value) {
  if (!ImGui::BeginPopup("pick")) return;
  float rgb[3] = {float(value.x), float(value.y), float(value.z)};
  for (float& c : rgb) c = std::isfinite(c) ? std::clamp(c, -1e6f, 1e6f) : 0.0f;
  ImGui::SetNextItemWidth(app.look.px(230));
  if (ImGui::ColorPicker3("##rgb", rgb,
                          ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_DisplayRGB |
                              ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoOptions |
                              ImGuiColorEditFlags_PickerHueBar)) {
    glm::dvec3 next;
    for (int i = 0; i < 3; ++i) next[i] = std::round(double(rgb[i]) * 1000) / 1000;
    store(app, slot, list_of(next));
  }
  ImGui::EndPopup();
}

// The colour with its largest number 1. Black has none: then the one it had before, so that a slider dragged to 0
// and back keeps it.
glm::dvec3 remembered_hue(const glm::dvec3& value, double largest) {
  ImGuiStorage* store = ImGui::GetStateStorage();
  const ImGuiID ids[3] = {ImGui::GetID("r"), ImGui::GetID("g"), ImGui::GetID("b")};
  glm::dvec3 hue(1);
  const bool black = !(largest > 0) || !std::isfinite(largest);
  for (int i = 0; i < 3; ++i) {
    hue[i] = black ? double(store->GetFloat(ids[i], 1.0f)) : std::max(value[i] / largest, 0.0);
    if (!black) store->SetFloat(ids[i], float(hue[i]));
  }
  return hue;
}

// The slider is the brightness, the largest of the three numbers; the hue stays.
void colour(App& app, const Slot& slot, const glm::dvec3& value) {
  if (slot.about->symbol.empty()) label_above(app, slot);
  const double largest = std::max({value.x, value.y, value.z});
  const bool grey = value.x == value.y && value.y == value.z;
  const auto shown = [](double v) { return float(v > 0 ? std::min(v, 1.0) : 0.0); };
  const Tree exact = slot_tree(slot);
  std::string all = to_json(exact, 0);
  if (all.size() > 2) all = all.substr(1, all.size() - 2);
  const RowChange c = number_row(app, {.id = "c",
                                       .symbol = slot.about->symbol,
                                       .about = slot.about,
                                       .value = largest,
                                       .differs = !is_initial(slot),
                                       .swatch = ImVec4{shown(value.x), shown(value.y), shown(value.z), 1},
                                       .exact = grey ? std::string{} : all});
  const glm::dvec3 hue = remembered_hue(value, largest);
  if (c.moved) {
    glm::dvec3 next = hue * *c.moved;
    for (int i = 0; i < 3; ++i) next[i] = std::clamp(next[i], slot.about->range.min, slot.about->range.max);
    store(app, slot, list_of(next));
  }
  if (c.typed) store_typed(app, slot, *c.typed);
  if (c.reset) reset(slot);
  if (c.swatch) ImGui::OpenPopup("pick");
  pick_colour(app, slot, value);
}

void choice(App& app, const Slot& slot, const Choice& c) {
  label_above(app, slot);
  const ImVec2 end = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, side = app.look.px(20);
  if (!is_initial(slot)) {  // the arrow stands at the right end of the label's line
    ImGui::SetCursorScreenPos({end.x + room - side, end.y - app.look.px(24)});
    if (reset_arrow(app, "reset", true, {side, app.look.px(24)})) reset(slot);
    ImGui::SetCursorScreenPos(end);
  }
  int index = c.get(c.object);
  if (choose(app, "choice", c.names, index)) c.set(c.object, index);
}

}  // namespace

void parameter(App& app, const Slot& slot, bool labelled) {
  ImGui::PushID(slot.path.c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {app.look.px(8), app.look.px(4)});
  if (auto v = std::get_if<bool*>(&slot.value)) {
    toggle(app, "on", slot.about->label.in(app.language()), **v);
    if (wants_tooltip(app)) tooltip(app, {}, slot.about->help.in(app.language()), slot.about->gl);
  } else if (auto v = std::get_if<int*>(&slot.value)) {
    number(app, slot, double(**v));
  } else if (auto v = std::get_if<double*>(&slot.value)) {
    number(app, slot, **v);
  } else if (auto v = std::get_if<glm::dvec3*>(&slot.value)) {
    if (slot.about->meaning == Meaning::colour)
      colour(app, slot, **v);
    else
      coordinates(app, slot, **v, labelled);
  } else if (auto v = std::get_if<Choice>(&slot.value)) {
    choice(app, slot, *v);
  }
  ImGui::PopStyleVar();
  ImGui::PopID();
}

void tessellation(App& app, const Slot& slot, const Object& object) {
  const Shape* shape = find_shape(object.model);
  if (!shape || shape->max_level <= shape->min_level) return;
  About about = *slot.about;
  about.slider = Range{double(shape->min_level), double(shape->max_level)};
  about.scale = shape->min_level > 0 && shape->max_level > 20 * shape->min_level ? Scale::logarithmic : Scale::linear;
  Slot narrow = slot;
  narrow.about = &about;
  int& level = **std::get_if<int*>(&narrow.value);
  const bool own = level == 0;  // show what 0 stands for
  if (own) level = shape->level;
  const int before = level;
  int initial = before;
  narrow.initial = own ? SlotValue(&initial) : slot.initial;
  parameter(app, narrow);
  if (own && level == before) level = 0;
}

void parameters(App& app, const Slots& all, std::string_view prefix, std::initializer_list<std::string_view> names,
                bool labelled) {
  for (std::string_view name : names)
    for (const Slot& slot : all)
      if (slot.path.size() == prefix.size() + name.size() && slot.path.starts_with(prefix) && slot.path.ends_with(name))
        parameter(app, slot, labelled);
}

}  // namespace cg
