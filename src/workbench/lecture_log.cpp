#include "workbench/lecture_log.h"

#include <algorithm>

#include "params/file.h"
#include "params/input_error.h"
#include "params/numbers.h"
#include "workbench/lecture_text.h"
#include "workbench/listing.h"
#include "workbench/model_library.h"
#include "workbench/preset.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_entries = 5000;

// A preset takes away what its model brings by null, which a merge patch cannot hold: a light or a part that was
// removed stays, switched off. The picture is the same.
Scene without_removals(Scene scene) {
  if (scene.lights.empty()) {
    scene.lights.emplace_back();
    scene.lights.back().enabled = false;
  }
  if (scene.objects.empty() || scene.objects[0].model.empty()) return scene;
  const Scene base = open_model(scene.objects[0].model);
  for (std::size_t i = scene.objects.size(); i < base.objects.size(); ++i) {
    scene.objects.push_back(base.objects[i]);
    scene.objects.back().visible = false;
  }
  return scene;
}

bool same_parameters(const LectureEntry& before, const LectureEntry& a, const LectureEntry& b) {
  return changed_paths(before, a) == changed_paths(a, b);
}

}  // namespace

void LectureLog::note(const Scene& scene, const LessonView& view, double seconds, bool held) {
  if (!entries_.empty() && (held || (entries_.back().scene == scene && entries_.back().view == view))) return;
  if (entries_.size() == most_entries) entries_.erase(entries_.begin() + 1);  // the scene at the beginning stays
  entries_.push_back({seconds, scene, view});
}

void LectureLog::restart() {
  if (entries_.size() > 1) entries_.erase(entries_.begin(), entries_.end() - 1);
}

std::vector<LectureEntry> coalesced(std::vector<LectureEntry> entries, double within, std::size_t most) {
  std::vector<LectureEntry> out;
  for (LectureEntry& entry : entries) {
    const std::size_t n = out.size();
    if (n >= 2 && entry.seconds - out[n - 1].seconds <= within && same_parameters(out[n - 2], out[n - 1], entry))
      out[n - 1] = std::move(entry);
    else
      out.push_back(std::move(entry));
    // Changed and changed back is no step.
    if (const std::size_t m = out.size(); m >= 2 && changed_paths(out[m - 2], out[m - 1]).empty()) out.pop_back();
  }
  while (out.size() > std::max<std::size_t>(most, 2)) {
    std::size_t shortest = 2;
    for (std::size_t i = 2; i < out.size(); ++i)
      if (out[i].seconds - out[i - 1].seconds < out[shortest].seconds - out[shortest - 1].seconds) shortest = i;
    out.erase(out.begin() + std::ptrdiff_t(shortest) - 1);
  }
  return out;
}

Tree patch_between(const Tree& from, const Tree& to) {
  if (!to.members()) return to;
  Tree patch{Tree::Members{}};
  static const Tree nothing_there{Tree::Members{}};
  const Tree& before = from.members() ? from : nothing_there;
  for (const auto& [key, value] : *before.members())
    if (!to.find(key)) patch.at(key) = Tree();
  for (const auto& [key, value] : *to.members()) {
    const Tree* old = before.find(key);
    if (!old)
      patch.at(key) = value;
    else if (*old != value)
      patch.at(key) = patch_between(*old, value);
  }
  return patch;
}

std::vector<std::string> changed_lines(const Scene& from, const Scene& to, Language language) {
  const Listing before = listing(from, language), after = listing(to, language);
  const auto& a = before.lines;
  const auto& b = after.lines;
  // The longest common subsequence: length[i][j] is that of the lines from i and j on.
  std::vector<std::vector<std::size_t>> length(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t j = b.size(); j-- > 0;)
      length[i][j] = a[i].text == b[j].text ? length[i + 1][j + 1] + 1 : std::max(length[i + 1][j], length[i][j + 1]);
  std::vector<std::string> out;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    if (i < a.size() && j < b.size() && a[i].text == b[j].text)
      ++i, ++j;
    else if (j == b.size() || (i < a.size() && length[i + 1][j] >= length[i][j + 1]))
      out.push_back("- " + a[i++].text);
    else
      out.push_back("+ " + b[j++].text);
  }
  std::erase_if(out, [](const std::string& line) { return line.size() == 2; });  // the gaps between sections
  return out;
}

void save_lecture(const std::vector<LectureEntry>& entries, const fs::path& folder, const Text& title) {
  std::vector<LectureEntry> steps = coalesced(entries);
  if (steps.size() < 2)
    throw InputError(folder.string(), {"nothing was changed yet", "まだ何も変更されていない"},
                     {"turn a parameter first", "先にパラメータを変える"});
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_empty(folder, error) && !fs::is_regular_file(folder / "lesson.json", error))
    throw InputError(folder.string(), {"there is something else in this folder", "このフォルダには別のものがある"},
                     {"name a new folder", "新しいフォルダの名前を書く"});
  Tree json;
  json.at("schema") = 1;
  Tree::List list;
  Tree before{Tree::Members{}};
  LessonView view;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i].scene = without_removals(steps[i].scene);
    const Tree preset = preset_of(steps[i].scene, fs::absolute(folder, error));
    Tree step;
    step.at("id") = lecture_step_id(i);
    step.at("scene") = patch_between(before, preset);
    if (Tree seen = view_changes(view, steps[i].view, i == 0); !seen.members()->empty()) step.at("view") = seen;
    if (i > 0) step.at("offer") = offered_after(steps[i - 1], steps[i]);
    before = preset;
    view = steps[i].view;
    list.push_back(std::move(step));
  }
  json.at("steps") = std::move(list);
  const std::string english = lecture_text(steps, title, Language::english);
  const std::string japanese = lecture_text(steps, title, Language::japanese);
  fs::create_directories(folder, error);
  save_file(folder / "lesson.en.md", english);
  save_file(folder / "lesson.ja.md", japanese);
  save_file(folder / "lesson.json", to_json(json) + "\n");  // last: without it the folder is no lesson
}

}  // namespace cg
