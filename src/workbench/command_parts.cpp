#include "workbench/command_parts.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <thread>

#include "params/numbers.h"
#include "workbench/open.h"
#include "workbench/progress_line.h"
#include "workbench/scene_radiosity.h"
#include "workbench/technique_list.h"
#include "workbench/texture_library.h"

namespace cg {

namespace {

constexpr int largest_side = 16384;
constexpr int most_threads = 1024;

}  // namespace

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

std::optional<int> whole_number(std::string_view text, int least, int most) {
  int v = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), v);
  return error == std::errc() && end == text.data() + text.size() && v >= least && v <= most ? std::optional(v)
                                                                                             : std::nullopt;
}

InputError bad_option(const std::string& option, const std::string& value, Text accepted) {
  return InputError(option, {"\"" + value + "\" is not possible", "「" + value + "」は使えません"},
                    std::move(accepted));
}

View view_of(const Arguments& a) {
  View view;
  if (!a.size.empty()) {
    const std::size_t x = a.size.find('x');
    const auto width = whole_number(a.size.substr(0, x), 1, largest_side);
    const auto height = whole_number(x == a.size.npos ? "" : a.size.substr(x + 1), 1, largest_side);
    if (!width || !height)
      throw bad_option("--size", a.size,
                       {"give width x height, each from 1 to 16384: 512x512",
                        "幅x高さを 512x512 のように、それぞれ 1 から 16384 で指定してください"});
    view.width = *width, view.height = *height;
  }
  view.threads = int(std::clamp(std::thread::hardware_concurrency(), 1u, unsigned(most_threads)));
  if (!a.threads.empty()) {
    const auto threads = whole_number(a.threads, 1, most_threads);
    if (!threads)
      throw bad_option("--threads", a.threads,
                       {"give a whole number from 1 to 1024", "1 から 1024 の整数を指定してください"});
    view.threads = *threads;
  }
  return view;
}

std::optional<double> limit_of(const std::string& option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const std::size_t slash = text.find('/');
  const auto above = parse_number(text.substr(0, slash));
  const auto below = slash == text.npos ? 1.0 : parse_number(text.substr(slash + 1));
  if (!above || !below || !(*above >= 0) || !(*below > 0))
    throw bad_option(option, text,
                     {"give a number from 0: 0.01 or 2/255", "0.01 や 2/255 のように 0 以上の数を指定してください"});
  return *above / *below;
}

Scene scene_for(const Arguments& a, Language language) {
  if (a.scene.empty())
    throw InputError("SCENE", {"no scene is named", "シーンの指定がありません"},
                     {"name a model file, a shape such as teapot, or a preset",
                      "モデルのファイル、teapot などの形、プリセットのどれかを指定してください"});
  std::vector<Text> notes;
  Scene scene = open_scene(a.scene, &notes);
  for (const Text& note : notes)
    std::fprintf(stderr, "shadebench: %s: %s\n", a.scene.c_str(), note.in(language).c_str());
  for (const std::string& set : a.set) set_parameter(scene, set);
  if (!a.set.empty()) load_meshes(scene);
  std::vector<InputError> bad;
  load_textures(scene, &bad);
  if (!bad.empty()) throw bad.front();
  return scene;
}

void solve_for_command(Scene& scene, const View& view, const Arguments& a, Language language) {
  if (!wants_radiosity(scene)) return;
  Progress progress;
  const ProgressLine line(progress, std::string(Words{"Radiosity", "ラジオシティ"}.in(language)));
  const SceneRadiosity solved = solve_scene(scene, {}, progress, view.threads, a.draw_items);
  for (const Text& note : solved.solution->notes)
    std::fprintf(stderr, "shadebench: radiosity: %s\n", note.in(language).c_str());
  scene.radiosity_field = solved.field;
}

const Technique& technique_for(const std::string& id, std::initializer_list<std::string_view> usual,
                               std::span<const Technique> all, const Scene& scene) {
  const Technique* technique = id.empty() ? first_able(all, scene, usual) : nullptr;
  if (!technique) technique = &find_technique(all, id.empty() ? *(usual.end() - 1) : std::string_view(id));
  require(*technique, scene);
  return *technique;
}

std::string label_of(const Technique& technique, Language language) { return std::string(technique.name.in(language)); }

void tell_notes(const Plan& plan, Language language) {
  for (const Text& note : plan.notes)
    std::fprintf(stderr, "shadebench: %s: %s\n", plan.technique.c_str(), note.in(language).c_str());
}

void tell_nan(const std::string& technique, const Frame& frame, Language language) {
  if (frame.nan_pixels == 0) return;
  const std::string n = std::to_string(frame.nan_pixels);
  const Text text{n + " pixels were not finite and are black", n + " 画素が有限の値にならず、黒にしました"};
  std::fprintf(stderr, "shadebench: %s: %s\n", technique.c_str(), text.in(language).c_str());
}

Frame draw_for_command(const Technique& technique, const Scene& scene, const View& view, Progress& progress,
                       Language language) {
  const Plan plan = technique.plan(scene, view);
  tell_notes(plan, language);
  Frame frame;
  {
    const ProgressLine line(progress, label_of(technique, language));
    frame = technique.render(scene, plan, view, progress);
  }
  tell_nan(technique.id, frame, language);
  return frame;
}

}  // namespace cg
