#include "workbench/lecture_text.h"

#include <algorithm>
#include <cmath>

#include "workbench/scene_differences.h"

namespace cg {

namespace {

constexpr std::size_t most_offered = 8, most_lines_told = 6;

// What Markdown would take for markup in a text.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_{}[]<>#|$").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

// "1:05"
std::string clock_text(double seconds) {
  const long whole = long(std::floor(std::max(seconds, 0.0)));
  const std::string rest = std::to_string(whole % 60);
  return std::to_string(whole / 60) + ":" + (rest.size() < 2 ? "0" : "") + rest;
}

std::string value_text(const Slot& slot, Language language) {
  if (const Choice* c = std::get_if<Choice>(&slot.value))
    return std::string(c->names[std::size_t(c->get(c->object))].label.in(language));
  const Tree tree = slot_tree(slot);
  if (const std::string* s = tree.string()) return *s;
  if (const Tree::List* list = tree.list()) {
    std::string text;
    for (const Tree& item : *list) text += (text.empty() ? "" : ", ") + to_json(item, 0);
    return text;
  }
  if (const bool* b = tree.boolean())
    return std::string((*b ? Words{"on", "オン"} : Words{"off", "オフ"}).in(language));
  return to_json(tree, 0);
}

const Slot* find_path(const Slots& all, std::string_view path) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Slot& s) { return s.path == path; });
  return found == all.end() ? nullptr : &*found;
}

// "LIGHT1 " before the label of a light's parameter.
std::string owner_of(std::string_view path, Language language) {
  const std::size_t dot = path.find('.');
  const std::string index(path.substr(dot + 1, path.find('.', dot + 1) - dot - 1));
  if (path.starts_with("lights.")) return "LIGHT" + index + " ";
  if (path.starts_with("objects.")) return std::string(Words{"object ", "物体 "}.in(language)) + index + " ";
  return {};
}

std::string label_of(const std::string& path, const Slots& before, const Slots& after, Language language) {
  if (path == "view") return std::string(Words{"Another view", "見方を変える"}.in(language));
  const Slot* slot = find_path(after, path);
  if (!slot) slot = find_path(before, path);
  if (slot) return owner_of(path, language) + std::string(slot->about->label.in(language));
  std::string owner = owner_of(path, language);  // a light or an object that came or went
  while (owner.ends_with(' ')) owner.pop_back();
  return owner;
}

struct Told {
  std::string title;
  std::vector<std::string> lines;
};

// "Shininess: 32 → 10".
std::string change_text(const std::string& label, const Slot& from, const Slot& to, Language language) {
  return plain(label) + std::string(Words{": ", "："}.in(language)) + plain(value_text(from, language)) + " → " +
         plain(value_text(to, language));
}

// How it is looked at.
void tell_view(LessonView from, LessonView to, Language language, Told& out) {
  const Slots before = slots(from), after = slots(to);
  for (std::size_t i = 0; i < after.size(); ++i)
    if (slot_tree(before[i]) != slot_tree(after[i]))
      out.lines.push_back(change_text(std::string(after[i].about->label.in(language)), before[i], after[i], language));
}

std::string item_text(const std::string& path, const std::string& label, const Slots& after, Language language) {
  const std::string below = path + ".";
  const bool added = std::any_of(after.begin(), after.end(), [&](const Slot& s) { return s.path.starts_with(below); });
  return plain(label) + std::string((added ? Words{" added", "を加える"} : Words{" removed", "を消す"}).in(language));
}

Told told(LectureEntry from, LectureEntry to, Language language) {
  const Slots before = slots(from.scene), after = slots(to.scene);
  Told out;
  bool camera = false;
  for (const std::string& path : changed_paths(from, to)) {
    if (path.starts_with("camera.")) {
      camera = true;
      continue;
    }
    const std::string label = label_of(path, before, after, language);
    if (out.title.empty()) out.title = label;
    const Slot *a = find_path(before, path), *b = find_path(after, path);
    if (path == "view")
      tell_view(from.view, to.view, language, out);
    else
      out.lines.push_back(a && b ? change_text(label, *a, *b, language) : item_text(path, label, after, language));
  }
  if (camera) {
    const std::string moved(Words{"The camera moves", "カメラを動かす"}.in(language));
    if (out.title.empty()) out.title = moved;
    out.lines.push_back(moved);
  }
  return out;
}

}  // namespace

std::string lecture_step_id(std::size_t index) { return "s" + std::to_string(index + 1); }

std::vector<std::string> changed_paths(const LectureEntry& from, const LectureEntry& to) {
  std::vector<std::string> out;
  for (const ParameterDifference& d : scene_differences(from.scene, to.scene)) out.push_back(d.path);
  if (out.empty() && !(from.view == to.view)) out.push_back("view");
  return out;
}

Tree view_changes(const LessonView& from, const LessonView& to, bool all) {
  LessonView a = from, b = to;
  const Slots before = slots(a), after = slots(b);
  Tree out{Tree::Members{}};
  for (std::size_t i = 0; i < after.size(); ++i)
    if (Tree value = slot_tree(after[i]); all || slot_tree(before[i]) != value)
      out.at(after[i].path) = std::move(value);
  return out;
}

Tree offered_after(const LectureEntry& from, const LectureEntry& to) {
  Scene scene = to.scene;
  const Slots all = slots(scene);
  Tree::List out;
  for (const std::string& path : changed_paths(from, to)) {
    const Slot* slot = find_path(all, path);
    const bool shown = slot && !path.starts_with("camera.") && !std::holds_alternative<std::string*>(slot->value);
    if (shown && out.size() < most_offered) out.push_back(path);
  }
  return out;
}

std::string lecture_text(const std::vector<LectureEntry>& steps, const Text& title, Language language) {
  std::string out = "# " + plain(title.in(language)) + "\n\n";
  out += Words{"What was changed in the lecture, in order.", "講義で変えたことを順に並べたもの。"}.in(language);
  out += "\n\n## " + std::string(Words{"At the beginning", "はじめの状態"}.in(language)) + " {#" + lecture_step_id(0) +
         "}\n\n" + std::string(Words{"The scene as it stood.", "はじめのシーン。"}.in(language)) + "\n";
  for (std::size_t i = 1; i < steps.size(); ++i) {
    Told what = told(steps[i - 1], steps[i], language);
    if (what.lines.size() > most_lines_told) {
      what.lines.resize(most_lines_told);
      what.lines.push_back("…");
    }
    out += "\n## " + clock_text(steps[i].seconds) + " " + plain(what.title) + " {#" + lecture_step_id(i) + "}\n\n";
    for (const std::string& line : what.lines) out += "- " + line + "\n";
    const std::vector<std::string> lines = changed_lines(steps[i - 1].scene, steps[i].scene, language);
    if (lines.empty()) continue;
    out += "\n```c\n";
    for (const std::string& line : lines) out += line + "\n";
    out += "```\n";
  }
  return out;
}

}  // namespace cg
