// A number in the listing as a control: dragged sideways as a slider's value is, typed in its place, set back by a
// double click.
#include <imgui_internal.h>

#include <cmath>
#include <optional>

#include "params/slots.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/number.h"
#include "ui/row.h"
#include "ui/widgets.h"

namespace cg {
namespace {

double component_of(const SlotValue& value, int component) {
  if (auto v = std::get_if<double*>(&value)) return **v;
  if (auto v = std::get_if<int*>(&value)) return double(**v);
  if (auto v = std::get_if<glm::dvec3*>(&value); v && component >= 0 && component < 3) return (**v)[component];
  return 0;
}

// Stores what `value` gives for the parameter of `number`, or tells the user why not.
template <class Value>
void store(App& app, const ListingNumber& number, Value value) {
  try {
    assign_number(app.scene, number, value);
  } catch (const InputError& e) {
    say(app, e);
  }
}

void set_back(App& app, const ListingNumber& number) {
  const Slots all = slots(app.scene);
  const Slot& slot = find_slot(all, number.path);
  store(app, number, component_of(slot.initial, number.component) * number.factor);
}

// Above the line, which the mouse is at: what stands below it is to be read.
void describe_number(App& app, const ListingNumber& number, ImVec2 at) {
  const Slots all = slots(app.scene);
  ImGui::SetNextWindowPos({at.x, at.y - app.look.px(4)}, 0, {0, 1});
  describe(app, *find_slot(all, number.path).about, number.path);
}

ImGuiID id_of(int key) { return ImGui::GetCurrentWindow()->GetID(key); }

void begin_typing(App& app, ImGuiID item, std::string text) {
  app.editing = {item, std::move(text), true};
  app.code.typing_since = app.now;
}

// The number behind this one, for Tab.
void type_next(App& app, const ListingLine& line, std::size_t index) {
  const CodeView& view = app.code;
  std::size_t l = std::size_t(&line - view.listing.lines.data()), i = index + 1;
  for (; l < view.listing.lines.size(); ++l, i = 0)
    for (; i < view.listing.lines[l].numbers.size(); ++i) {
      const ListingNumber& next = view.listing.lines[l].numbers[i];
      if (next.path.empty()) continue;
      return begin_typing(app, id_of(view.keys[l][i]),
                          view.listing.lines[l].text.substr(next.begin, next.end - next.begin));
    }
}

float type_number(App& app, const ListingLine& line, std::size_t index, ImVec2 at, ImVec2 size) {
  const ListingNumber number = line.numbers[index];
  const std::string shown = line.text.substr(number.begin, number.end - number.begin);
  Look& look = app.look;
  const ImVec2 field{std::max(size.x + look.px(8), look.px(84)), size.y};
  const bool opened_just_now = app.now - app.code.typing_since < 0.4;
  if (opened_just_now && ImGui::IsMouseDoubleClicked(0) &&
      ImGui::IsMouseHoveringRect(at, {at.x + field.x, at.y + size.y})) {
    app.editing = {};
    set_back(app, number);
    return 0;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      {look.px(3), std::max(0.0f, 0.5f * (size.y - look.fonts.small_mono->FontSize))});
  ImGui::PushOverrideID(app.editing.item);
  const std::optional<std::string> typed =
      type_value(app, look.fonts.small_mono, shown, {at.x - look.px(3), at.y}, field.x);
  ImGui::PopID();
  ImGui::PopStyleVar();
  const bool onward = app.editing.item == 0 && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab), false);
  if (typed) store(app, number, std::string_view(*typed));
  if (onward) type_next(app, line, index);
  return field.x - size.x;
}

// As the sketch of a blank to be filled in.
void underline(ImDrawList* draw, const Look& look, ImVec2 at, float width, ImU32 colour, bool whole) {
  const float dot = std::max(1.0f, look.px(1));
  if (whole) return draw->AddRectFilled(at, {at.x + width, at.y + dot}, colour);
  for (float x = 0; x + dot <= width; x += 3 * dot)
    draw->AddRectFilled({at.x + x, at.y}, {at.x + x + dot, at.y + dot}, colour);
}

}  // namespace

float code_number(App& app, const ListingLine& line, std::size_t index, int key, ImVec2 at, float height) {
  Look& look = app.look;
  const ListingNumber& number = line.numbers[index];
  ImFont* font = look.fonts.small_mono;
  const std::string_view text = std::string_view(line.text).substr(number.begin, number.end - number.begin);
  const ImVec2 size{text_width(font, text), height};
  const ImGuiID id = id_of(key);
  if (app.editing.item == id) return type_number(app, line, index, at, size);

  ImGui::SetCursorScreenPos({at.x - look.px(2), at.y});
  ImGui::PushOverrideID(id);
  ImGui::InvisibleButton("number", {size.x + look.px(4), height});
  note_place(app, "code", number.path);
  ImGui::PopID();
  CodeView& view = app.code;
  if (ImGui::IsItemActivated()) view.held = {ImGui::GetItemID(), number, false};
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  if (ImGui::IsItemDeactivated() && hovered && !ImGui::IsMouseDragPastThreshold(0))
    begin_typing(app, id, std::string(text));
  if (hovered || held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (wants_tooltip(app)) describe_number(app, number, at);

  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 colour = line.quantity == Quantity::none ? look.palette.text : look.of(line.quantity);
  if (hovered || held)
    draw->AddRectFilled({at.x - look.px(2), at.y + look.px(1)},
                        {at.x + size.x + look.px(2), at.y + height - look.px(1)}, look.palette.raised_hover,
                        look.px(3));
  const float baseline = at.y + std::floor(0.5f * (height - font->FontSize)) + font->Ascent;
  set_text(draw, font, {at.x, baseline}, colour, text);
  underline(draw, look, {at.x, std::floor(baseline + look.px(3))}, size.x, colour, hovered || held);
  return 0;
}

void move_held_number(App& app) {
  CodeView::Held& held = app.code.held;
  if (held.id == 0) return;
  if (!ImGui::IsMouseDown(0) || ImGui::GetActiveID() != held.id) {
    held = {};
    return;
  }
  ImGui::KeepAliveID(held.id);
  app.animating = true;
  const float pixels = ImGui::GetIO().MouseDelta.x;
  if (!ImGui::IsMouseDragging(0) || pixels == 0) return;
  const Slots all = slots(app.scene);
  const auto slot = std::find_if(all.begin(), all.end(), [&](const Slot& s) { return s.path == held.number.path; });
  if (slot == all.end()) return;  // its light was removed meanwhile
  // Where OpenGL's number is not the parameter (an n over 128), the drag begins at what is seen.
  const double now =
      held.moved ? component_of(slot->value, held.number.component) : held.number.value / held.number.factor;
  held.moved = true;
  // A factor below 0 turns the number around, and with it the drag.
  const double steps = double(pixels) / double(app.look.scale) * (held.number.factor < 0 ? -0.5 : 0.5);
  store(app, held.number, stepped(*slot->about, now, steps, ImGui::GetIO().KeyShift) * held.number.factor);
}

}  // namespace cg
