#include "ui/hemicube_figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/app.h"
#include "ui/formula.h"
#include "ui/lines.h"
#include "ui/number.h"
#include "ui/widgets.h"

namespace cg {
namespace {

std::string factor_text(double v) { return number_text(v, 5, 7); }

ImU32 miss_ink(const App& app, double value, double exact) {
  return exact > 0 && std::abs(value / exact - 1) > told_miss ? app.look.palette.error : app.look.palette.text;
}

// A line of a small table: a name, and columns of figures to the right of it.
struct Cell {
  std::string text;
  ImU32 ink;
};
void table_line(App& app, std::string_view name, ImU32 ink, std::span<const Cell> cells, float first, bool heading) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, baseline = at.y + look.px(15);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(at, {at.x + first, at.y + look.px(21)}, true);
  set_text(draw, look.fonts.small, {at.x, baseline}, ink, noted(app, name));
  draw->PopClipRect();
  ImFont* font = heading ? look.fonts.small : look.fonts.small_mono;
  const float column = (room - first) / float(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string_view text = noted(app, cells[i].text);
    set_text(draw, font, {at.x + first + column * float(i + 1) - text_width(font, text), baseline}, cells[i].ink, text);
  }
  ImGui::Dummy({room, look.px(20) - ImGui::GetStyle().ItemSpacing.y});
}

const HemicubePair* pair_of(const HemicubeDesk& desk) {
  return desk.art.pair && desk.art.pair->sight == desk.art.sight ? desk.art.pair.get() : nullptr;
}

std::string face_text(HemicubeFace face, Language l) {
  constexpr std::array<Words, 5> names{
      {{"top", "上面"}, {"right", "右"}, {"left", "左"}, {"upper", "奥"}, {"lower", "手前"}}};
  return std::string(names[std::size_t(face)].in(l));
}

void draw_reciprocity(App& app, const HemicubePair::Whole& whole) {
  const Palette& p = app.look.palette;
  std::string text = short_number(whole.reciprocity, 8) + " m²";
  if (whole.there > 0) text += "  " + rounded(100 * whole.relative, whole.relative < 0.0995 ? 2 : 1) + " %";
  const ImVec2 at = ImGui::GetCursorScreenPos();
  small_pair_line(app, " ", text, whole.relative > told_miss ? p.error : p.text);
  const float scale = app.look.fonts.small->FontSize / app.look.fonts.text->FontSize;
  typeset(ImGui::GetWindowDrawList(), {app.look.fonts.math, app.look.fonts.math_sub, scale, scale},
          {at.x, at.y + app.look.px(15)}, p.dim, noted(app, "|A_i F_{ij} − A_j F_{ji}|"));
}

}  // namespace

float fitting_scale(ImFont* font, std::string_view text, float room) {
  return std::clamp(room / std::max(text_width(font, text), 1.0f), 0.8f, 1.0f);
}

std::string short_number(double v, std::size_t room) {
  std::string text = number_text(v, 0, room);
  if (const std::size_t e = text.find("e-0"); e != text.npos) text.erase(e + 2, 1);
  return text;
}

std::string miss_text(double value, double exact) {
  if (!(exact > 0)) return {};
  const double percent = 100 * (value / exact - 1);
  const int places = std::abs(percent) < 9.995 ? 2 : std::abs(percent) < 99.95 ? 1 : 0;
  const std::string number = rounded(std::abs(percent), places);
  const bool zero = number.find_first_not_of("0.") == number.npos;
  return (zero ? "" : percent < 0 ? "−" : "+") + number + " %";
}

void draw_pixel_lines(App& app, const HemicubeDesk& desk, const PointedPixel& pixel) {
  Look& look = app.look;
  const Language l = app.language();
  const HemicubeSight& sight = *desk.art.sight;
  std::array<std::string, 2> lines;
  std::array<ImU32, 2> inks{look.palette.dim, look.palette.text};
  std::uint32_t item = desk.item(app.settings);
  if (pixel.x >= 0) {
    item = sight.view.items.at(pixel.x, pixel.y);
    const auto p = cross_pixel(pixel.x, pixel.y, sight.view.resolution);
    const std::string weight = short_number(double(sight.view.weights.at(pixel.x, pixel.y)), 9);
    if (p)
      lines[0] =
          face_text(p->face, l) + " (" + std::to_string(p->x) + ", " + std::to_string(p->y) + ")   ΔF = " + weight;
  } else {
    lines[0] = Words{"Point at a pixel: the patch it sees lights up", "画素に合わせると、見えるパッチが光る"}.in(l);
  }
  if (item == no_item) {
    lines[1] = Words{"It sees nothing", "何も見えない"}.in(l);
    inks[1] = look.palette.dim;
  } else {
    const PatchPixels* own = sight.of(item);
    const std::string name = patch_name(app, *sight.ground, item & ~from_behind);
    const std::string count = std::to_string(own ? own->pixels : 0), sum = factor_text(own ? own->sum : 0);
    if (item & from_behind)
      lines[1] = name + std::string(Words{": its back, which gives no light", "の裏側。光を返さない"}.in(l));
    else
      lines[1] = l == Language::english ? name + ": " + count + " px, ΣΔF = " + sum
                                        : name + "：" + count + " 画素、ΣΔF = " + sum;
    if (!(item & from_behind)) inks[1] = other_ink(app);
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(at, {at.x + room, at.y + look.px(42)}, true);
  for (std::size_t i = 0; i < 2; ++i)
    set_text(draw, look.fonts.small, {at.x, at.y + look.px(16 + 20 * float(i))}, inks[i], lines[i],
             fitting_scale(look.fonts.small, noted(app, lines[i]), room));
  draw->PopClipRect();
  ImGui::Dummy({room, look.px(42) - ImGui::GetStyle().ItemSpacing.y});
}

void draw_pair(App& app, const HemicubeDesk& desk) {
  const Language l = app.language();
  const Palette& p = app.look.palette;
  const HemicubeSight& sight = *desk.art.sight;
  const HemicubePair* pair = pair_of(desk);
  const float first = app.look.px(82);
  const std::array<Cell, 3> titles{{{std::string(Words{"hemicube", "計算値"}.in(l)), p.dim},
                                    {std::string(Words{"exact", "厳密値"}.in(l)), p.dim},
                                    {std::string(Words{"off by", "誤差"}.in(l)), p.dim}}};
  table_line(app, l == Language::english ? "F from i to j" : "i → j の F", p.dim, titles, first, true);
  const auto line = [&](const Words& name, bool there, double value, const KnownFactor& known) {
    const bool exact = there && known.exact();
    const std::array<Cell, 3> cells{
        {{there ? factor_text(value) : "…", p.text},
         {there ? exact ? factor_text(known.value) : "—" : "", p.text},
         {exact ? miss_text(value, known.value) : "", miss_ink(app, value, exact ? known.value : 0)}}};
    table_line(app, name.in(l), p.text, cells, first, false);
  };
  const PatchPixels* pixels = pair ? sight.of(pair->item) : nullptr;
  line({"Position", "この位置"}, pair != nullptr, pixels ? pixels->sum : 0, pair ? pair->point : KnownFactor{});
  const bool whole = pair && pair->whole;
  line({"Whole patch", "パッチ全体"}, whole, whole ? pair->whole->there : 0,
       whole ? pair->whole->known : KnownFactor{});
  if (whole) draw_reciprocity(app, *pair->whole);
  if (whole && !pair->whole->known.exact()) {
    const std::string name = patch_name(app, *sight.ground, pair->whole->known.between);
    small_text(
        app,
        std::string(
            Words{"No closed form: something stands between, patch ", "閉じた式はない。間にパッチがある："}.in(l)) +
            name,
        p.dim);
  }
}

}  // namespace cg
