// The lists under the hemicube: ways to weigh its pixels, and the row of form factors as bars.
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/app.h"
#include "ui/formula.h"
#include "ui/hemicube_figures.h"
#include "ui/lines.h"
#include "ui/number.h"
#include "ui/widgets.h"

namespace cg {
namespace {

constexpr std::array<Words, names_of<PixelWeight>.size()> short_names{{{"ΔF", "ΔF"},
                                                                       {"integrated", "積分した ΔF"},
                                                                       {"no weight", "重みなし"},
                                                                       {"solid angle", "立体角だけ"},
                                                                       {"r² for r⁴", "r⁴ でなく r²"}}};

struct WeightLine {
  std::string factor, miss, sum;
  bool wrong = false;
};

// A row of the table of weights; true when it was pressed.
bool draw_weight(App& app, PixelWeight weight, const WeightLine& line, bool chosen) {
  Look& look = app.look;
  const Palette& p = look.palette;
  const ImVec2 at = ImGui::GetCursorScreenPos(), size{ImGui::GetContentRegionAvail().x, look.px(24)};
  const bool pressed = ImGui::InvisibleButton("weight", size);
  note_place(app, "weight", names_of<PixelWeight>[std::size_t(weight)].id);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (chosen || ImGui::IsItemHovered())
    draw->AddRectFilled({at.x - look.px(6), at.y}, {at.x + size.x + look.px(6), at.y + size.y}, p.raised, look.px(3));
  const float baseline = at.y + look.px(17), r = look.px(4);
  const ImVec2 dot{at.x + r + look.px(1), at.y + 0.5f * size.y};
  draw->AddCircle(dot, r, chosen ? p.text : p.dim, 16, look.px(1.2f));
  if (chosen) draw->AddCircleFilled(dot, 0.55f * r, p.text, 12);
  set_text(draw, look.fonts.small, {at.x + look.px(16), baseline}, p.text,
           noted(app, short_names[std::size_t(weight)]));
  const float first = look.px(100), column = (size.x - first) / 3;
  const std::array<std::pair<const std::string*, ImU32>, 3> cells{
      {{&line.factor, p.text}, {&line.miss, line.wrong ? p.error : p.text}, {&line.sum, p.text}}};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const float w = text_width(look.fonts.small_mono, noted(app, *cells[i].first));
    set_text(draw, look.fonts.small_mono, {at.x + first + column * float(i + 1) - w, baseline}, cells[i].second,
             *cells[i].first);
  }
  if (wants_tooltip(app)) {
    constexpr std::array<Words, names_of<PixelWeight>.size()> helps{
        {{"The lecture's delta form factor at the pixel's centre: z/(π(x² + y² + 1)²) on the top.",
          "画素の中心での ΔF。上面では z/(π(x² + y² + 1)²)。"},
         {"The same integrated over the pixel: all of them sum to exactly 1.",
          "画素内で積分した ΔF。全画素の和はちょうど 1。"},
         {"Wrong: every pixel counts the same, whatever its angle and distance.",
          "間違い：角度や距離によらず、どの画素も同じ重み。"},
         {"Wrong: the pixel's solid angle without the cosine at the patch.",
          "間違い：パッチ側の余弦がなく、画素の立体角だけ。"},
         {"Wrong: 1/r² where both cosines make it 1/r⁴.", "間違い：2 つの余弦を含めて 1/r⁴ になる所を 1/r² にした。"}}};
    tooltip(app, names_of<PixelWeight>[std::size_t(weight)].label.in(app.language()),
            helps[std::size_t(weight)].in(app.language()), {});
  }
  return pressed;
}

// A factor of the row as a bar; true when it was pressed.
bool draw_bar(App& app, HemicubeDesk& desk, const HemicubeRow& row, std::size_t index, float height) {
  Look& look = app.look;
  const Palette& p = look.palette;
  const FormFactor& f = row.by_size[index];
  const ImVec2 at = ImGui::GetCursorScreenPos(), size{std::max(ImGui::GetContentRegionAvail().x, 1.0f), height};
  const bool pressed = ImGui::InvisibleButton("bar", size);
  note_place(app, "bar", std::to_string(f.patch));
  if (ImGui::IsItemHovered()) desk.point_at(f.patch);
  const bool lit = (desk.item(app.settings) & ~from_behind) == f.patch;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (lit) draw->AddRectFilled(at, {at.x + size.x, at.y + size.y}, p.raised, look.px(3));
  const float swatch = look.px(10), baseline = at.y + look.px(15), from = at.x + look.px(126), value_w = look.px(64);
  const glm::u8vec4 c = item_colour(f.patch);
  const float y = at.y + 0.5f * (height - swatch);
  draw->AddRectFilled({at.x + look.px(2), y}, {at.x + look.px(2) + swatch, y + swatch}, IM_COL32(c.r, c.g, c.b, 255),
                      look.px(2));
  draw->PushClipRect(at, {from - look.px(6), at.y + height}, true);
  set_text(draw, look.fonts.small, {at.x + look.px(18), baseline}, lit ? other_ink(app) : p.text,
           noted(app, patch_name(app, *row.ground, f.patch)));
  draw->PopClipRect();
  const float room = std::max(at.x + size.x - value_w - from, look.px(10));
  double most = double(row.by_size.front().value);
  for (const KnownFactor& known : row.known)
    if (known.exact()) most = std::max(most, known.value);
  const auto x_of = [&](double v) { return from + room * float(std::clamp(v / most, 0.0, 1.0)); };
  const float middle = at.y + 0.5f * height, thick = look.px(4);
  draw->AddRectFilled({from, middle - thick}, {std::max(x_of(double(f.value)), from + 1), middle + thick},
                      lit ? other_ink(app) : p.dim, look.px(1));
  if (index < row.known.size() && row.known[index].exact()) {
    const float x = x_of(row.known[index].value);
    draw->AddRectFilled({x - look.px(1), middle - look.px(8)}, {x + look.px(1), middle + look.px(8)}, p.text);
  }
  const std::string value = number_text(double(f.value), 5, 7);
  set_text(draw, look.fonts.small_mono,
           {at.x + size.x - look.px(2) - text_width(look.fonts.small_mono, value), baseline}, p.text, value);
  return pressed;
}

// How far the largest factors are from their closed forms, all together.
void draw_mean_miss(App& app, const HemicubeRow& row) {
  double off = 0, exact = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < row.known.size(); ++i) {
    if (!row.known[i].exact()) continue;
    off += std::abs(double(row.by_size[i].value) - row.known[i].value), exact += row.known[i].value, ++count;
  }
  if (!(exact > 0)) return;
  const double miss = off / exact;
  small_pair_line(app, Words{"Mean miss of closed forms", "閉じた式との平均誤差"}.in(app.language()),
                  rounded(100 * miss, miss < 0.0995 ? 2 : 1) + " %",
                  miss > told_miss ? app.look.palette.error : app.look.palette.text);
  if (wants_tooltip(app)) {
    const std::string n = std::to_string(count), all = std::to_string(row.known.size());
    tooltip(app, {},
            Text("Of the " + all + " largest factors those " + n +
                     " that nothing stands between: what they are off, "
                     "over what they are. The thin line on a bar is the closed form.",
                 "大きい順に " + all + " 個の係数のうち、間に何もない " + n +
                     " 個の誤差の和 ÷ 値の和。"
                     "棒の細い線が閉じた式。")
                .in(app.language()),
            {});
  }
}

}  // namespace

void draw_weights(App& app, const HemicubeDesk& desk) {
  if (!section(app, "weights", {"What a pixel counts", "画素の重み"}, true)) return;
  const Language l = app.language();
  const Palette& p = app.look.palette;
  const HemicubePair* pair = desk.art.pair && desk.art.pair->sight == desk.art.sight ? desk.art.pair.get() : nullptr;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float first = app.look.px(100), room = ImGui::GetContentRegionAvail().x, column = (room - first) / 3;
  const std::array<Words, 3> titles{{{"i to j", "i から j"}, {"off by", "誤差"}, {"all", "全部の和"}}};
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const std::string_view text = noted(app, titles[i].in(l));
    const float w = text_width(app.look.fonts.small, text);
    set_text(ImGui::GetWindowDrawList(), app.look.fonts.small,
             {at.x + first + column * float(i + 1) - w, at.y + app.look.px(14)}, p.dim, text);
  }
  ImGui::Dummy({room, app.look.px(20) - ImGui::GetStyle().ItemSpacing.y});
  Radiosity& options = app.scene.radiosity;
  for (std::size_t k = 0; k < short_names.size(); ++k) {
    WeightLine line;
    const bool there = pair && pair->weighted[k].all > 0;
    if (there) {
      const WeightedSum& sum = pair->weighted[k];
      line.factor = number_text(sum.item, 5, 7), line.sum = number_text(sum.all, 4, 6);
      if (pair->point.exact() && pair->point.value > 0) {
        line.miss = miss_text(sum.item, pair->point.value);
        line.wrong = std::abs(sum.item / pair->point.value - 1) > told_miss;
      }
    }
    ImGui::PushID(int(k));
    if (draw_weight(app, PixelWeight(k), line, std::size_t(options.weight) == k)) options.weight = PixelWeight(k);
    ImGui::PopID();
  }
}

void draw_row_bars(App& app, HemicubeDesk& desk) {
  const Language l = app.language();
  const Palette& p = app.look.palette;
  if (!section(app, "row", {"Form factors of the patch", "このパッチの形態係数"}, true)) return;
  const std::shared_ptr<const HemicubeRow>& row = desk.state().row;
  if (!row || row->ground != desk.art.sight->ground) return small_text(app, "…", p.dim);
  const bool closed = row->ground->patches.closed, off = closed && std::abs(row->row.sum - 1) > 1e-3;
  const bool normalised = closed && row->options.normalise != Normalise::none;
  small_pair_line(
      app,
      (normalised ? Words{"Sum, before it is made 1", "行の和（1 にする前）"} : Words{"Sum of the row", "行の和"})
          .in(l),
      rounded(row->row.sum, 6), off ? p.error : p.text);
  draw_mean_miss(app, *row);
  if (row->row.missed > 0)
    small_pair_line(app, Words{"In front, hidden or too small", "前にあるが隠れるか小さすぎる"}.in(l),
                    std::to_string(row->row.missed), p.text);
  if (row->by_size.empty()) return small_text(app, Words{"It sees nothing.", "何も見えない。"}.in(l), p.dim);
  const float height = app.look.px(21);
  const float wanted = height * float(row->by_size.size());
  const float room = std::max(ImGui::GetContentRegionAvail().y, height * 8);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  if (ImGui::BeginChild("bars", {0, std::min(wanted, room)})) {
    // What is lit elsewhere is seen here too.
    if (desk.pointed() != no_item && !ImGui::IsWindowHovered()) {
      const auto lit = std::find_if(row->by_size.begin(), row->by_size.end(),
                                    [&](const FormFactor& f) { return f.patch == (desk.pointed() & ~from_behind); });
      const float at = height * float(lit - row->by_size.begin()), seen = ImGui::GetWindowHeight();
      const bool hidden = at < ImGui::GetScrollY() || at + height > ImGui::GetScrollY() + seen;
      if (lit != row->by_size.end() && hidden) ImGui::SetScrollY(at - 0.5f * seen);
    }
    ImGuiListClipper clipper;
    clipper.Begin(int(row->by_size.size()), height);
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        ImGui::PushID(i);
        const int patch = int(row->by_size[std::size_t(i)].patch);
        if (draw_bar(app, desk, *row, std::size_t(i), height))
          app.settings.other_patch = app.settings.other_patch == patch ? -1 : patch;
        ImGui::PopID();
      }
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace cg
