#include "measure/lesson_results.h"

#include <algorithm>
#include <chrono>

#include "image/image_file.h"
#include "params/file.h"
#include "params/input_error.h"
#include "workbench/isolate.h"
#include "workbench/scene_radiosity.h"
#include "workbench/technique_list.h"

namespace cg {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// The lesson's name and the step's number in letters that a web page needs no escape for.
std::string file_stem(const std::string& lesson, std::size_t step) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-",
                             hex = "0123456789abcdef";
  std::string out;
  for (const char c : lesson)
    if (plain.find(c) != plain.npos)
      out += c;
    else
      (out += '_') += {hex[static_cast<unsigned char>(c) >> 4], hex[static_cast<unsigned char>(c) & 15]};
  return out + "-" + std::to_string(step + 1);
}

class StepDrawing {
 public:
  StepDrawing(const LessonStep& step, const Scene& scene, std::span<const Technique> techniques,
              const ResultOptions& options, Progress& progress)
      : scene_(isolated(scene, quantity_of(step.view.term), step.view.light)),
        techniques_(techniques),
        options_(options),
        progress_(progress) {}

  // The technique of that id, drawn once; null where it cannot.
  const Technique* draw(const std::string& id, DrawnStep& out, Frame& frame) {
    out.technique = id;
    out.name = {id, id};
    try {
      const Technique& technique = find_technique(techniques_, id);
      out.name = technique.name;
      require(technique, scene_);
      frame = rendered(technique, options_.picture);
      return &technique;
    } catch (const InputError& e) {
      out.problem = Text{e.message(Language::english), e.message(Language::japanese)};
      return nullptr;
    }
  }

  // In turn, so that both meet what else the machine does.
  void time(const Technique* left, const Technique* right, StepResult& out) {
    std::vector<double> clock[2], cpu[2];
    const auto start = Clock::now();
    for (int i = 0; i <= options_.repeats; ++i) {
      if (i > 3 && ms_since(start) > 1e3 * options_.seconds) break;
      for (const int side : {0, 1}) {
        const Technique* technique = side == 0 ? left : right;
        if (!technique) continue;
        const auto begin = Clock::now();
        const Frame frame = rendered(*technique, options_.timed);
        if (i == 0) continue;  // it pays for what is made once
        clock[side].push_back(ms_since(begin));
        cpu[side].push_back(frame.cpu_ms);
      }
    }
    for (const int side : {0, 1})
      if (!clock[side].empty()) {
        DrawnStep& drawn = side == 0 ? out.left : out.right;
        drawn.clock = spread_of(clock[side]), drawn.cpu = spread_of(cpu[side]);
      }
  }

 private:
  Frame rendered(const Technique& technique, int size) {
    View view;
    view.width = view.height = size;
    view.threads = options_.threads;
    if (progress_.cancelled) throw Cancelled{};
    Progress untold;
    return technique.render(scene_, technique.plan(scene_, view), view, untold);
  }

  const Scene scene_;
  const std::span<const Technique> techniques_;
  const ResultOptions& options_;
  Progress& progress_;
};

// The largest power of two that shows the largest error as less than the end of the ramp, 1 to 256.
double gain_for(double max_error) {
  double gain = 256;
  while (gain > 1 && max_error * gain > 1) gain /= 2;
  return gain;
}

StepResult draw_step(const Lesson& lesson, std::size_t index, const fs::path& into,
                     std::span<const Technique> techniques, const ResultOptions& options, Progress& progress) {
  const LessonStep& step = lesson.steps[index];
  StepResult out;
  out.left.technique = step.view.left, out.right.technique = step.view.right;
  try {
    out.scene = scene_of_step(lesson, index);
    if (wants_radiosity(out.scene))
      out.scene.radiosity_field = solve_scene(out.scene, {}, progress, options.threads).field;
  } catch (const InputError& e) {
    out.left.problem = out.right.problem = Text{e.message(Language::english), e.message(Language::japanese)};
    return out;
  }
  StepDrawing drawing(step, out.scene, techniques, options, progress);
  Frame frames[2];
  const Technique* const left = drawing.draw(step.view.left, out.left, frames[0]);
  const Technique* const right = drawing.draw(step.view.right, out.right, frames[1]);
  const std::string stem = "pictures/" + file_stem(lesson.id, index);
  const auto save = [&](const std::string& name, const Picture& picture) {
    write_image(into / (stem + name), picture);
    return stem + name;
  };
  if (left) out.left.file = save("-left.png", picture(out.scene.display, frames[0].colour));
  if (right) out.right.file = save("-right.png", picture(out.scene.display, frames[1].colour));
  if (left && right) {
    out.difference =
        difference(frames[0].colour, frames[1].colour, frames[0].covered, frames[1].covered, out.scene.display);
    out.seen_gain = gain_for(out.difference->max_error);
    out.difference_file = save("-difference.png", false_colour(*out.difference, out.seen_gain));
    out.difference->error = {};  // a picture a step is much
  }
  drawing.time(left, right, out);
  return out;
}

// The numbers of a step's text, from what the check found.
std::vector<NumberResult> numbers_of(const LessonStep& step, const std::vector<LessonFinding>& findings) {
  std::vector<NumberResult> out;
  for (const LessonNumber& number : step.numbers)
    for (const LessonFinding& f : findings)
      if (f.kind == LessonFinding::number && f.step == step.id && f.name == number.name) {
        NumberResult result;
        result.name = number.name;
        result.digits = number.digits, result.decimals = number.decimals;
        result.value = f.value, result.expected = f.expected, result.tolerance = f.tolerance;
        out.push_back(std::move(result));
      }
  return out;
}

}  // namespace

std::size_t LessonResult::count(LessonFinding::Kind kind) const {
  return std::size_t(std::count_if(findings.begin(), findings.end(), [&](const auto& f) { return f.kind == kind; }));
}
std::size_t LessonResult::compared() const {
  return std::size_t(std::count_if(findings.begin(), findings.end(), [](const auto& f) {
    return f.expected || f.kind == LessonFinding::task || !f.holds;
  }));
}
std::size_t LessonResult::off() const {
  return std::size_t(std::count_if(findings.begin(), findings.end(), [](const auto& f) { return !f.holds; }));
}

LessonResult lesson_result(const fs::path& folder, std::vector<LessonFinding> findings, const fs::path& into,
                           std::span<const Technique> techniques, const ResultOptions& options, Progress& progress) {
  std::error_code error;
  fs::create_directories(into / "pictures", error);
  if (error) throw InputError((into / "pictures").string(), system_text(error.value()));
  LessonResult out;
  out.id = folder.filename().string();
  out.findings = std::move(findings);
  try {
    out.lesson = read_lesson(folder);
  } catch (const InputError&) {
    return out;  // the check says it
  }
  out.id = out.lesson->id;
  for (std::size_t i = 0; i < out.lesson->steps.size(); ++i) {
    out.steps.push_back(draw_step(*out.lesson, i, into, techniques, options, progress));
    out.steps.back().numbers = numbers_of(out.lesson->steps[i], out.findings);
    progress.fraction = float(i + 1) / float(out.lesson->steps.size());
  }
  return out;
}

}  // namespace cg
