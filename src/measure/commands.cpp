// The command `trade`: the list of the knobs, or one knob's trade into files.
#include "measure/commands.h"

#include <filesystem>
#include <system_error>

#include "measure/extreme_command.h"
#include "measure/lessons_command.h"
#include "measure/plot.h"
#include "measure/repetition.h"
#include "params/file.h"
#include "workbench/command_parts.h"
#include "workbench/progress_line.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

constexpr int most_repeats = 1000;
constexpr std::size_t most_bytes = 16 << 20;  // of an earlier run's file

Tree list_tree() {
  Tree::List list;
  for (const Knob& knob : knobs()) list.push_back(json_of(knob));
  return Tree::Members{{"knobs", std::move(list)}};
}

std::string list_text(Language language) {
  std::string out;
  for (const Knob& knob : knobs()) {
    const auto say = [&](Words words) { return std::string(words.in(language)); };
    out += std::string(knob.id) + say({": ", "："}) + say(knob.name) + "\n  " + say(knob.help) + "\n";
    for (const Prediction& p : knob.predictions)
      out += "  " + std::string(p.law) + say({" (", "（"}) + say(knob.series[p.series].name) + say({"): ", "）："}) +
             say(p.why) + "\n    " + std::string(p.source) + "\n";
  }
  return out;
}

TradeOptions options_of(const Arguments& a) {
  TradeOptions options;
  const View view = view_of(a);
  if (!a.size.empty()) options.width = view.width, options.height = view.height;
  if (!a.threads.empty()) options.threads = view.threads;
  options.technique = a.technique;
  if (a.repeats.empty()) {
    options.seconds = usual_seconds;
    return options;
  }
  const auto repeats = whole_number(a.repeats, 1, most_repeats);
  if (!repeats)
    throw bad_option("--repeats", a.repeats,
                     {"give a whole number from 1 to 1000", "1 から 1000 の整数を指定すること"});
  options.repeats = *repeats;
  return options;
}

// The scene's name as a part of a file's name: "03-shading:2" is "03-shading-2".
std::string file_stem(const std::string& scene) {
  std::string out;
  for (const char c : fs::path(scene).stem().string()) {
    const bool plain = static_cast<unsigned char>(c) > 0x20 && c != ':' && c != '/' && c != '\\';
    out += plain ? c : '-';
  }
  return out.empty() ? "scene" : out;
}

// Before anything is measured: a mistake in the name should not cost that time.
void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    const Text why = system_text(error.value());
    throw InputError(folder.string(), {"the folder cannot be made: " + why.en, "フォルダを作れない：" + why.ja});
  }
}

void write_files(const Trade& trade, const fs::path& folder, Language language) {
  const std::string stem = std::string(trade.knob->id) + "-" + file_stem(trade.scene);
  save_file(folder / (stem + ".csv"), csv_of(trade));
  save_file(folder / (stem + ".json"), to_json(json_of(trade)) + "\n");
  save_file(folder / (stem + ".svg"), svg_of(trade, language));
}

}  // namespace

int run_trade_command(const Arguments& a, std::span<const Technique> techniques, Language language) {
  if (a.list) {
    print(a.json ? to_json(list_tree()) + "\n" : list_text(language));
    return 0;
  }
  const Knob& knob = find_knob(a.knob);
  const TradeOptions options = options_of(a);
  Arguments named = a;
  if (named.scene.empty()) named.scene = knob.scene.empty() ? "teapot" : knob.scene;
  const Scene scene = scene_for(named, language);
  std::optional<Tree> earlier;
  if (!a.against.empty()) {
    earlier = parse_json(read_file(a.against, most_bytes), a.against);
    check_same_trade(*earlier, knob, named.scene, a.against);
  }
  if (!a.output.empty()) make_folder(a.output);
  Trade trade;
  {
    Progress progress;
    const ProgressLine line(progress, std::string(knob.name.in(language)));
    trade = run_trade(knob, named.scene, scene, techniques, options, progress);
  }
  if (!a.output.empty()) write_files(trade, a.output, language);
  if (earlier) {
    const Repetition r = hold_against(trade, *earlier, a.against);
    print(a.json ? to_json(json_of(r)) + "\n" : text_of(r, language));
    return r.same_errors == r.settings ? 0 : 1;
  }
  print(a.json ? to_json(json_of(trade)) + "\n" : text_of(trade, language));
  return 0;
}

std::vector<CommandOffer> measure_commands() {
  CommandOffer trade{
      .name = "trade",
      .help = {"Measure a knob's speed against its accuracy", "調整項目の速さと正確さの関係を測る"},
      .run = run_trade_command,
      .words = {{"KNOB", &Arguments::knob}, {"SCENE", &Arguments::scene}},
      .options = {{"-o,--output",
                   "DIR",
                   {"Write the table (csv, json) and the plot (svg) here", "表（csv、json）と図（svg）の保存先"},
                   &Arguments::output},
                  {"--repeats",
                   "N",
                   {"Each setting is timed so often; else 9 times, and more for 10 seconds",
                    "各設定の測定回数。省略すると 9 回以上、10 秒間"},
                   &Arguments::repeats},
                  {"--against",
                   "FILE",
                   {"An earlier run's json: are the errors the same, the times within its spread",
                    "前回の json と比べる（誤差が同じか、時間がその幅に入るか）"},
                   &Arguments::against},
                  {"--technique",
                   "T",
                   {"How it is drawn, where the knob leaves a choice", "手法（調整項目が選べるとき）"},
                   &Arguments::technique},
                  {.names = "--list",
                   .type = nullptr,
                   .help = {"The knobs, what theory predicts, and where that stands", "調整項目と理論の予測、その出典"},
                   .flag = &Arguments::list},
                  {.names = "--json",
                   .type = nullptr,
                   .help = {"One JSON object on stdout", "JSON で出力する"},
                   .flag = &Arguments::json}},
      .draws = true};
  return {std::move(trade), extremes_command(), lessons_command()};
}

}  // namespace cg
