// The dialogue that saves a measured trade: its numbers, or the picture of its plots.
#include <imgui.h>

#include <array>
#include <filesystem>

#include "params/file.h"
#include "ui/app.h"
#include "ui/layout.h"
#include "ui/trade_desk.h"
#include "ui/widgets.h"
#include "workbench/environment.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

constexpr std::array<Name, 3> formats{{{".csv", {"CSV: numbers", "CSV（数値）"}},
                                       {".json", {"JSON: everything", "JSON（全部）"}},
                                       {".svg", {"SVG: the plots", "SVG（図）"}}}};

void save(App& app, std::shared_ptr<const MeasuredTrade> measured, const fs::path& file, int format) {
  app.errands->run(app, [measured, file, format, language = app.language()]() -> Errands::Done {
    const Trade& trade = measured->trade;
    save_file(file, format == 0   ? csv_of(trade)
                    : format == 1 ? to_json(json_of(trade), 1) + "\n"
                                  : svg_of(trade, language));
    return [file](App& a) { say_saved(a, file); };
  });
}

}  // namespace

bool draw_trade_dialogue(App& app) {
  Dialogue& d = app.dialogue;
  const std::span<const Knob> all = knobs();
  const auto knob = std::find_if(all.begin(), all.end(), [&](const Knob& k) { return k.id == d.subject; });
  const auto measured = knob == all.end() ? nullptr : trades_of(app).of(*knob);
  if (!measured) return true;
  d.format = std::clamp(d.format, 0, int(formats.size()) - 1);
  if (d.text.empty()) d.text = d.subject + std::string(formats[std::size_t(d.format)].id);
  for (int i = 0; i < int(formats.size()); ++i) {
    if (i > 0) ImGui::SameLine(0, app.look.px(6));
    ImGui::PushID(i);
    if (button(app, "format", {.label = formats[std::size_t(i)].label.in(app.language()), .chosen = d.format == i})) {
      d.text = fs::path(d.text).replace_extension(formats[std::size_t(i)].id).string();
      d.format = i;
    }
    ImGui::PopID();
  }
  const bool entered = save_field(app, Words{});
  ImGui::Dummy({1, app.look.px(4)});
  if ((button(app, "save", {.label = Words{"Save", "保存"}.in(app.language()), .chosen = true}) || entered) &&
      !d.text.empty()) {
    save(app, measured, typed_path(d.text), d.format);
    return true;
  }
  return false;
}

}  // namespace cg
