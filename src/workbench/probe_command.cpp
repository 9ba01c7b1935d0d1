// shadebench probe: what the colour of one pixel is made of.
#include "params/tree.h"
#include "workbench/command_parts.h"
#include "workbench/probe.h"

namespace cg {

namespace {

glm::ivec2 pixel_of(const std::string& text, const View& view) {
  const std::size_t comma = text.find(',');
  const auto x = whole_number(text.substr(0, comma), 0, view.width - 1);
  const auto y = whole_number(comma == text.npos ? "" : text.substr(comma + 1), 0, view.height - 1);
  if (x && y) return {*x, *y};
  const std::string size = std::to_string(view.width) + "x" + std::to_string(view.height),
                    last = std::to_string(view.width - 1) + "," + std::to_string(view.height - 1);
  if (text.empty())
    throw InputError("--pixel", {"no pixel is named", "画素の指定がありません"},
                     {"give x,y from the top-left corner: --pixel 0,0 to " + last,
                      "左上を 0,0 として --pixel x,y を " + last + " までで指定してください"});
  throw bad_option(
      "--pixel", text,
      {"give x,y from 0,0 to " + last + " (the picture is " + size + ", see --size)",
       "0,0 から " + last + " までの x,y を指定してください（画像は " + size + "、--size で変えられます）"});
}

}  // namespace

int run_probe(const Arguments& a, std::span<const Technique> techniques, Language language) {
  View view = view_of(a);
  const glm::ivec2 pixel = pixel_of(a.pixel, view);
  Scene scene = scene_for(a, language);
  solve_for_command(scene, view, a, language);
  const Technique& technique = technique_for(a.technique, {"software"}, techniques, scene);
  view.ids = true;
  Progress progress;
  const Frame frame = draw_for_command(technique, scene, view, progress, language);
  const Probe p = probe(scene, technique, view, frame, pixel, progress);
  print(a.json ? to_json(json_of(p, scene)) + "\n" : text_of(p, scene, language));
  return 0;
}

}  // namespace cg
