#include "workbench/lesson_report.h"

#include <algorithm>
#include <system_error>

#include "params/file.h"
#include "params/input_error.h"
#include "workbench/lesson_numbers.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

// The lines of `text` from `first` up to `last` (from 1; `last` itself is left out), each ended.
std::string_view lines_between(std::string_view text, long first, long last) {
  std::size_t begin = 0, end = text.size(), at = 0;
  for (long line = 1; at < text.size(); ++line) {
    if (line == first) begin = at;
    if (line == last) end = at;
    const std::size_t newline = text.find('\n', at);
    at = newline == text.npos ? text.size() : newline + 1;
  }
  return text.substr(begin, end - begin);
}

struct FilledStep {
  std::vector<NumberResult> results;
  Scene scene;
};

// The file with the numbers of each step put into the step's own lines; the order of the steps in the file is its own.
std::string filled_text(const Lesson& lesson, const std::vector<FilledStep>& steps, Language language,
                        std::string_view text) {
  const long end = 2 + std::count(text.begin(), text.end(), '\n');
  std::vector<std::pair<long, std::size_t>> begins;
  for (std::size_t i = 0; i < steps.size(); ++i) begins.emplace_back(lesson.steps[i].in(language).line, i);
  std::sort(begins.begin(), begins.end());
  std::string out(lines_between(text, 1, begins[0].first));
  for (std::size_t k = 0; k < begins.size(); ++k) {
    const FilledStep& step = steps[begins[k].second];
    const long next = k + 1 < begins.size() ? begins[k + 1].first : end;
    out += filled(lines_between(text, begins[k].first, next),
                  [&](std::string_view name) { return text_of_number(name, step.results, step.scene); });
  }
  return out;
}

}  // namespace

void write_lesson_report(const fs::path& folder, const fs::path& into, std::span<const Technique> techniques,
                         Progress& progress) {
  const Lesson lesson = read_lesson(folder);
  std::vector<FilledStep> steps;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i)
    steps.push_back({compute_numbers(lesson.steps[i], lesson.steps[i].preset, folder, techniques, progress),
                     scene_of_step(lesson, i)});
  std::error_code error;
  fs::create_directories(into, error);
  if (error) throw InputError(into.string(), system_text(error.value()));
  for (const Language language : {Language::english, Language::japanese}) {
    const std::string ending = language == Language::japanese ? ".ja.md" : ".en.md";
    save_file(into / (lesson.id + ending),
              filled_text(lesson, steps, language, read_file(folder / ("lesson" + ending))));
  }
}

}  // namespace cg
