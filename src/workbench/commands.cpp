#include "workbench/commands.h"

#include <cstdio>
#include <filesystem>

#include "image/image_file.h"
#include "params/input_error.h"
#include "params/numbers.h"
#include "workbench/command_parts.h"
#include "workbench/comparison.h"
#include "workbench/environment.h"
#include "workbench/progress_line.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

constexpr double usual_gain = 32;  // of the difference in a file of 8 bits: 1/255 can be seen

bool keeps_floats(const fs::path& file) {
  const std::string type = file.extension().string();
  return type == ".exr" || type == ".EXR" || type == ".hdr" || type == ".HDR";
}

// |a - b|: as it is where the file holds floats, else times the gain.
void write_difference(const fs::path& file, const Comparison& c, double gain) {
  if (!keeps_floats(file)) return write_image(file, absolute_picture(c.difference, gain));
  ColourImage error = c.difference.error;
  for (glm::vec3& pixel : error.pixels()) pixel = glm::abs(pixel);
  write_image(file, error, Display{});
}

}  // namespace

int run_render(const Arguments& a, std::span<const Technique> techniques, Language language) {
  const View view = view_of(a);
  if (a.output.empty())
    throw InputError("-o", {"no file is named", "保存先の指定がありません"},
                     {"name a picture: -o picture.png", "-o picture.png のように指定してください"});
  Scene scene = scene_for(a, language);
  solve_for_command(scene, view, a, language);
  const Technique& technique = technique_for(a.technique, {"software"}, techniques, scene);
  Progress progress;
  const Frame frame = draw_for_command(technique, scene, view, progress, language);
  write_image(a.output, frame.colour, scene.display);
  return 0;
}

namespace {

Comparison compare_as_asked(const Arguments& a, std::span<const Technique> techniques, Scene scene, Language language) {
  const View view = view_of(a);
  solve_for_command(scene, view, a, language);
  const Technique& left = technique_for(a.left, {"gl-fixed", "gl"}, techniques, scene);
  const Technique& right = technique_for(a.right, {"software"}, techniques, scene);
  for (const Technique* technique : {&left, &right}) tell_notes(technique->plan(scene, view), language);
  Progress progress;
  const ProgressLine line(progress, left.id + ", " + right.id);
  Comparison comparison = compare(left, right, scene, view, progress);
  tell_nan(left.id, comparison.left_frame.frame, language);
  tell_nan(right.id, comparison.right_frame.frame, language);
  return comparison;
}

}  // namespace

int run_compare(const Arguments& a, std::span<const Technique> techniques, Language language) {
  const auto limit = limit_of("--max-error", a.max_error);
  const double gain = limit_of("--gain", a.gain).value_or(usual_gain);
  const Comparison comparison = compare_as_asked(a, techniques, scene_for(a, language), language);
  if (!a.output.empty()) write_difference(a.output, comparison, gain);
  print(a.json ? to_json(json_of(comparison)) + "\n" : text_of(comparison, language));
  if (!limit || comparison.difference.max_error <= *limit) return 0;
  const std::string over = number_text(comparison.difference.max_error) + " > " + a.max_error;
  const Text text{"the largest error is over --max-error: " + over, "最大誤差が --max-error を超えました：" + over};
  std::fprintf(stderr, "shadebench: %s\n", text.in(language).c_str());
  return 1;
}

int run_without_display(const Arguments& a, std::span<const Technique> techniques, Language language) {
  const Scene scene = scene_for(a, language);
  const Comparison comparison = compare_as_asked(a, techniques, scene, language);
  std::error_code error;
  fs::path folder = cache_folder().value_or("");
  if (folder.empty() || (fs::create_directories(folder, error), error)) folder = fs::temp_directory_path();
  const fs::path left = folder / (comparison.left + ".png"), right = folder / (comparison.right + ".png"),
                 both = folder / "difference.png";
  write_image(left, comparison.left_frame.frame.colour, scene.display);
  write_image(right, comparison.right_frame.frame.colour, scene.display);
  write_difference(both, comparison, usual_gain);
  print(std::string(Words{"There is no display, so no window: ", "ディスプレイがないため、ウィンドウは開きません："}.in(
            language)) +
        a.scene + "\n" + text_of(comparison, language));
  for (const fs::path& file : {left, right, both}) print("  " + file.string() + "\n");
  return 0;
}

}  // namespace cg
