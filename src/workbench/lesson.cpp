#include "workbench/lesson.h"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "params/file.h"
#include "params/input_error.h"
#include "workbench/data_folder.h"
#include "workbench/lesson_json.h"
#include "workbench/preset.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_file = std::size_t(4) << 20;
constexpr std::array<const char*, 2> text_files{"lesson.en.md", "lesson.ja.md"};  // by Language

void collect_tasks(const std::vector<TextBlock>& blocks, std::vector<std::pair<std::string, long>>& out) {
  for (const TextBlock& block : blocks) {
    if (block.kind == TextBlock::task) out.emplace_back(block.id, block.line);
    collect_tasks(block.inner, out);
  }
}

// What a text speaks of is in lesson.json, and the other way round.
void check_text(const LessonStep& step, const TextSection& text, const std::string& where) {
  std::vector<std::pair<std::string, long>> tasks;
  collect_tasks(text.blocks, tasks);
  for (const auto& [id, line] : tasks)
    if (std::none_of(step.tasks.begin(), step.tasks.end(), [&id = id](const LessonTask& t) { return t.id == id; }))
      throw InputError(where, {"lesson.json has no task " + id, "lesson.json に課題 " + id + " がない"},
                       {"add it to the step " + step.id, "ステップ " + step.id + " に加える"}, line);
  for (const LessonTask& task : step.tasks)
    if (std::none_of(tasks.begin(), tasks.end(), [&](const auto& t) { return t.first == task.id; }))
      throw InputError(where, {"the text of the task " + task.id + " is missing", "課題 " + task.id + " の文がない"},
                       {"write - [ ] text {#" + task.id + "}", "- [ ] 文 {#" + task.id + "} と書く"}, text.line);
  for (const std::string& name : numbers_in(text.blocks)) {
    const auto is_it = [&](const LessonNumber& n) { return n.name == name; };
    if (name.find('.') == name.npos && std::none_of(step.numbers.begin(), step.numbers.end(), is_it))
      throw InputError(where, {"lesson.json has no number " + name, "lesson.json に数 " + name + " がない"},
                       {"add it to the step " + step.id, "ステップ " + step.id + " に加える"}, text.line);
  }
}

void take_text(Lesson& lesson, Language language, LessonText text, const std::string& where) {
  const auto index = std::size_t(language);
  for (LessonStep& step : lesson.steps) {
    const auto found = std::find_if(text.sections.begin() + 1, text.sections.end(),
                                    [&](const TextSection& s) { return s.id == step.id; });
    if (found == text.sections.end())
      throw InputError(where, {"the step " + step.id + " is missing", "ステップ " + step.id + " がない"},
                       {"write ## Title {#" + step.id + "}", "「## 題 {#" + step.id + "}」と書く"}, 1);
    check_text(step, *found, where);
    step.text[index] = std::move(*found);
    text.sections.erase(found);
  }
  if (text.sections.size() > 1)
    throw InputError(
        where,
        {"lesson.json has no step " + text.sections[1].id, "lesson.json にステップ " + text.sections[1].id + " がない"},
        {"add it there", "書き加える"}, text.sections[1].line);
  if (const auto names = numbers_in(text.sections[0].blocks); !names.empty())
    throw InputError(
        where, {"{{" + names[0] + "}} before the first step", "最初のステップより前に {{" + names[0] + "}} がある"},
        {"numbers belong to steps", "数はステップの中に書く"}, text.sections[0].line);
  lesson.text[index] = std::move(text.sections[0]);
}

}  // namespace

Lesson read_lesson(const fs::path& folder) {
  Lesson lesson;
  lesson.folder = folder;
  lesson.id = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  const fs::path json = folder / "lesson.json";
  lesson.steps = parse_lesson_json(read_file(json, largest_file), json.string());
  for (const Language language : {Language::english, Language::japanese}) {
    const fs::path file = folder / text_files[std::size_t(language)];
    take_text(lesson, language, parse_lesson_text(read_file(file, largest_file), file.string()), file.string());
  }
  return lesson;
}

Scene scene_of_step(const Lesson& lesson, std::size_t step) {
  const LessonStep& s = lesson.steps.at(step);
  return scene_of(s.preset, lesson.id + ":" + std::to_string(step + 1), lesson.folder);
}

std::vector<fs::path> lesson_folders(const fs::path& folder) {
  std::vector<fs::path> out;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (std::error_code none; fs::is_regular_file(entry->path() / "lesson.json", none)) out.push_back(entry->path());
  std::sort(out.begin(), out.end());
  return out;
}

std::optional<StepName> find_step(const std::string& name) {
  const std::size_t colon = name.find(':');
  const std::string id = name.substr(0, colon);
  for (const fs::path& folder : lesson_folders(data_folder() / "lessons")) {
    if (folder.filename() != id) continue;
    StepName out{folder, 0};
    if (colon == name.npos) return out;
    const std::string number = name.substr(colon + 1);
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), out.step);
    const std::size_t count = read_lesson(folder).steps.size();
    if (error != std::errc() || end != number.data() + number.size() || out.step < 1 || out.step > count)
      throw InputError(name, {"there is no such step", "そのようなステップはない"},
                       {"the steps are " + id + ":1 to " + id + ":" + std::to_string(count),
                        "ステップは " + id + ":1 から " + id + ":" + std::to_string(count)});
    --out.step;
    return out;
  }
  return std::nullopt;
}

}  // namespace cg
