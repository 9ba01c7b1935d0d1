#include "workbench/lesson_numbers.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "params/input_error.h"
#include "params/numbers.h"
#include "params/slots.h"
#include "workbench/lesson_expression.h"
#include "workbench/preset.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

// The parameter at a path of the scene: a number, one of three by .x .y .z (or .r .g .b), or 0 and 1 for off and on.
std::optional<double> parameter(const Scene& scene, std::string_view path) {
  if (path.find('.') == path.npos) return std::nullopt;
  Scene copy = scene;  // slots are made of what can be written
  const std::string_view component = path.substr(path.rfind('.') + 1);
  const std::string_view whole = path.substr(0, path.rfind('.'));
  for (const Slot& slot : slots(copy)) {
    if (slot.path == path) {
      if (const auto v = std::get_if<double*>(&slot.value)) return **v;
      if (const auto v = std::get_if<int*>(&slot.value)) return **v;
      if (const auto v = std::get_if<bool*>(&slot.value)) return **v ? 1 : 0;
    }
    if (slot.path == whole && component.size() == 1)
      if (const auto v = std::get_if<glm::dvec3*>(&slot.value)) {
        const std::size_t index = std::string_view("xyzrgb").find(component[0]);
        if (index != std::string_view::npos) return (**v)[int(index % 3)];
      }
  }
  return std::nullopt;
}

Scene patched(const Scene& base, const Tree& preset, const Tree& patch, const std::string& where,
              const fs::path& folder) {
  return patch.is_null() ? base : scene_of(merge_patch(preset, patch), where, folder);
}

// The numbers of one step for one scene, each computed when it is first asked for.
class Numbers {
 public:
  Numbers(const LessonStep& step, const Tree& preset, const fs::path& folder, std::span<const Technique> techniques,
          Progress& progress, SolvedScenes& solved)
      : step_(step),
        preset_(preset),
        folder_(folder),
        techniques_(techniques),
        progress_(progress),
        solved_(solved),
        base_(scene_of(preset, step.id, folder)),
        results_(step.numbers.size()),
        state_(step.numbers.size(), unknown) {}

  NumberResult result(std::size_t i) {
    if (state_[i] == unknown) {
      state_[i] = computing;
      results_[i] = compute(step_.numbers[i]);
      state_[i] = known;
    }
    return results_[i];
  }

 private:
  enum State { unknown, computing, known };

  // The value of another number, or a parameter of the scene that is measured.
  std::optional<double> variable(std::string_view name, const Scene& scene) {
    for (std::size_t i = 0; i < step_.numbers.size(); ++i) {
      if (step_.numbers[i].name != name) continue;
      if (state_[i] == computing)
        throw InputError(std::string(name), {"the number needs itself", "数が自分自身を必要としている"},
                         {"break the circle", "循環をなくす"});
      const NumberResult r = result(i);
      if (r.problem) throw InputError(std::string(name), *r.problem);
      return r.value;
    }
    return parameter(scene, name);
  }

  NumberResult compute(const LessonNumber& number) {
    NumberResult out;
    out.name = number.name;
    out.digits = number.digits, out.decimals = number.decimals;
    if (number.measuring.what) out.unit = number.measuring.what->unit;
    try {
      const std::string where = step_.id + "." + number.name;
      const Scene scene = patched(base_, preset_, number.scene, where, folder_);
      const VariableOf value_of = [&](std::string_view name) { return variable(name, scene); };
      if (number.measuring.what) {
        const Tree own = number.scene.is_null() ? preset_ : merge_patch(preset_, number.scene);
        const Scene against = patched(scene, own, number.against, where, folder_);
        out.value = measure(number.measuring, scene, against, techniques_, progress_, solved_);
      } else {
        out.value = evaluate(number.value, value_of, where);
      }
      if (number.expect.empty()) return out;
      out.expected = evaluate(number.expect, value_of, where);
      out.tolerance = evaluate(number.tolerance, value_of, where);
    } catch (const InputError& e) {
      out.problem = Text{e.message(Language::english), e.message(Language::japanese)};
    }
    return out;
  }

  const LessonStep& step_;
  const Tree& preset_;
  const fs::path& folder_;
  const std::span<const Technique> techniques_;
  Progress& progress_;
  SolvedScenes& solved_;
  const Scene base_;
  std::vector<NumberResult> results_;
  std::vector<State> state_;
};

}  // namespace

std::string in_digits(double v, int digits, int decimals) {
  if (!std::isfinite(v)) return number_text(v);
  if (decimals >= 0) v = std::round(v * std::pow(10.0, decimals)) / std::pow(10.0, decimals);
  if (v == 0 || std::abs(v) < 1e-12) return "0";
  char buffer[64];
  std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, v, std::chars_format::general, digits).ptr);
  const std::size_t e = text.find('e');
  if (e == text.npos) return text;
  std::string exponent = text[e + 1] == '-' ? "⁻" : "";
  constexpr std::array<const char*, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::size_t first = text.find_first_not_of("+-0", e + 1);
  for (std::size_t i = std::min(first, text.size()); i < text.size(); ++i)
    exponent += raised[std::size_t(text[i] - '0')];
  return text.substr(0, e) + "×10" + exponent;
}

std::vector<NumberResult> compute_numbers(const LessonStep& step, const Tree& preset, const fs::path& folder,
                                          std::span<const Technique> techniques, Progress& progress,
                                          SolvedScenes& solved) {
  std::vector<NumberResult> out;
  try {
    Numbers numbers(step, preset, folder, techniques, progress, solved);
    for (std::size_t i = 0; i < step.numbers.size(); ++i) out.push_back(numbers.result(i));
  } catch (const InputError& e) {
    for (const LessonNumber& number : step.numbers) {
      NumberResult result;
      result.name = number.name;
      result.problem = Text{e.message(Language::english), e.message(Language::japanese)};
      out.push_back(result);
    }
  }
  return out;
}

std::optional<std::string> text_of_number(std::string_view name, const std::vector<NumberResult>& results,
                                          const Scene& scene) {
  for (const NumberResult& result : results)
    if (result.name == name)
      return result.value ? std::optional(in_digits(*result.value, result.digits, result.decimals)) : std::nullopt;
  const auto value = parameter(scene, name);
  return value ? std::optional(number_text(*value)) : std::nullopt;
}

TaskResult check_task(const LessonTask& task, const Scene& scene, const Scene& start, const fs::path& folder,
                      std::span<const Technique> techniques, Progress& progress, SolvedScenes& solved) {
  const auto measured = [&](const Scene& s) {
    const Scene against =
        task.against.is_null() ? s : scene_of(merge_patch(preset_of(s), task.against), task.id, folder);
    return measure(task.measuring, s, against, techniques, progress, solved);
  };
  TaskResult out;
  out.value = measured(scene);
  std::optional<double> at_start;
  const VariableOf value_of = [&](std::string_view name) -> std::optional<double> {
    if (name != "start") return parameter(start, name);
    if (!at_start) at_start = measured(start);
    return at_start;
  };
  out.goal = evaluate(task.goal, value_of, task.id);
  out.tolerance = evaluate(task.tolerance, value_of, task.id);
  out.done = std::abs(out.value - out.goal) <= out.tolerance;
  return out;
}

}  // namespace cg
