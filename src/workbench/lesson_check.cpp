#include "workbench/lesson_check.h"

#include <algorithm>

#include "params/input_error.h"
#include "params/slots.h"
#include "workbench/preset.h"
#include "workbench/technique_list.h"

namespace cg {

namespace {

class Check {
 public:
  Check(const Lesson& lesson, std::span<const Technique> techniques, Progress& progress)
      : lesson_(lesson), techniques_(techniques), progress_(progress) {}

  std::vector<LessonFinding> findings() {
    for (std::size_t i = 0; i < lesson_.steps.size(); ++i) {
      step_ = &lesson_.steps[i];
      same_in_both_languages();
      try {
        const Scene scene = scene_of_step(lesson_, i);
        views(scene);
        offers(scene);
        texts(scene);
        numbers();
        for (const LessonTask& task : step_->tasks) try_task(task, scene);
      } catch (const InputError& e) {
        wrong("scene", e);
      }
      progress_.fraction = float(i + 1) / float(lesson_.steps.size());
    }
    return std::move(out_);
  }

 private:
  LessonFinding& add(LessonFinding::Kind kind, const std::string& name, bool holds) {
    LessonFinding finding;
    finding.kind = kind;
    finding.lesson = lesson_.id;
    finding.step = step_->id;
    finding.name = name;
    finding.holds = holds;
    return out_.emplace_back(std::move(finding));
  }
  void wrong(const std::string& name, const InputError& e) {
    add(LessonFinding::problem, name, false).note = {e.message(Language::english), e.message(Language::japanese)};
  }

  // The techniques that the step shows can draw it, or, as where two cannot be shown side by side, one of them can.
  void views(const Scene& scene) {
    for (const std::string& id : {step_->view.left, step_->view.right}) try {
        require(find_technique(techniques_, id), scene);
      } catch (const InputError& e) {
        wrong("view", e);
      }
  }

  void offers(const Scene& scene) {
    Scene copy = scene;
    const Slots all = slots(copy);
    for (const std::string& path : step_->offered) try {
        const bool list =
            std::any_of(all.begin(), all.end(), [&](const Slot& s) { return s.path.starts_with(path + "."); });
        if (!list) find_slot(all, path);
      } catch (const InputError& e) {
        wrong("offer", e);
      }
  }

  // Every {{path.of.parameter}} is one.
  void texts(const Scene& scene) {
    for (const TextSection& text : step_->text)
      for (const std::string& name : numbers_in(text.blocks))
        if (name.find('.') != name.npos && !text_of_number(name, {}, scene))
          wrong("text", InputError(name, {"there is no such parameter", "そのようなパラメータはない"}));
  }

  static void count(const std::vector<TextBlock>& blocks, std::vector<std::string>& out) {
    for (const TextBlock& b : blocks)
      if (b.kind == TextBlock::question) {
        std::string right = "?";
        for (const TextChoice& choice : b.choices) right += choice.right ? 'x' : '-';
        out.push_back(right);
      } else if (b.kind == TextBlock::task) {
        out.push_back(b.id);
      }
  }
  void same_in_both_languages() {
    std::vector<std::string> both[2], names[2];
    for (const int i : {0, 1}) {
      count(step_->text[i].blocks, both[i]);
      names[i] = numbers_in(step_->text[i].blocks);
      std::sort(names[i].begin(), names[i].end());
    }
    if (both[0] != both[1])
      wrong("text", InputError(step_->id, {"the texts do not ask the same questions and tasks",
                                           "二つの言語で問い・選択肢・課題が食い違っている"}));
    if (names[0] != names[1])
      wrong("text", InputError(step_->id,
                               {"the texts do not name the same numbers", "二つの言語で使っている数が食い違っている"}));
  }

  void numbers() {
    const auto results = compute_numbers(*step_, step_->preset, lesson_.folder, techniques_, progress_, solved_);
    for (std::size_t i = 0; i < results.size(); ++i) {
      const NumberResult& r = results[i];
      LessonFinding& finding = add(LessonFinding::number, r.name, r.holds());
      finding.value = r.value, finding.expected = r.expected, finding.tolerance = r.tolerance;
      finding.note = r.problem ? *r.problem : step_->numbers[i].source;
    }
  }

  void try_task(const LessonTask& task, const Scene& start) {
    try {
      const auto result = [&](const Scene& scene) {
        return check_task(task, scene, start, lesson_.folder, techniques_, progress_, solved_);
      };
      const TaskResult before = result(start);
      const Scene solved = scene_of(merge_patch(step_->preset, task.solution), task.id, lesson_.folder);
      const TaskResult after = result(solved);
      LessonFinding& finding = add(LessonFinding::task, task.id, !before.done && after.done);
      finding.value = after.value, finding.expected = after.goal, finding.tolerance = after.tolerance;
      finding.note = before.done ? Text{"the task is done at the start", "初めから達成されている"}
                                 : Text{"the task's solution", "課題の解答例"};
    } catch (const InputError& e) {
      wrong(task.id, e);
    }
  }

  const Lesson& lesson_;
  const std::span<const Technique> techniques_;
  Progress& progress_;
  SolvedScenes solved_;
  const LessonStep* step_ = nullptr;
  std::vector<LessonFinding> out_;
};

}  // namespace

std::vector<LessonFinding> check_lesson(const std::filesystem::path& folder, std::span<const Technique> techniques,
                                        Progress& progress) {
  try {
    const Lesson lesson = read_lesson(folder);
    return Check(lesson, techniques, progress).findings();
  } catch (const InputError& e) {
    LessonFinding finding;
    finding.lesson = folder.filename().string();
    finding.name = "files";
    finding.note = {e.message(Language::english), e.message(Language::japanese)};
    return {finding};
  }
}

}  // namespace cg
