// lesson.json as steps. What a key may hold is the description of the struct that it fills.
#include "workbench/lesson_json.h"

#include <algorithm>

#include "params/input_error.h"
#include "params/numbers.h"

namespace cg {

namespace {

constexpr std::size_t most_steps = 100, most_items = 200;

// The beginning of a text for a message, whole characters of it.
std::string excerpt(const std::string& text, std::size_t most = 40) {
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end) + "…";
}

// Where in a document something stands: the keys that lead there. JSON as a Tree has no lines, so an error looks for
// the keys in the text, one behind the other.
class Place {
 public:
  Place(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  Place below(const std::string& key) const {
    Place inner = *this;
    inner.path_ += (path_.empty() ? "" : ".") + key;
    const std::size_t found = text_.find("\"" + key + "\"", at_);
    if (found != text_.npos) inner.at_ = found;
    return inner;
  }
  [[noreturn]] void refuse(Text found, Text accepted) const {
    const long line = 1 + std::count(text_.begin(), text_.begin() + std::ptrdiff_t(at_), '\n');
    throw InputError(file_, {excerpt(path_, 120) + ": " + found.en, excerpt(path_, 120) + "：" + found.ja},
                     std::move(accepted), line);
  }
  // Runs what may throw an InputError about a key, and adds the place.
  template <class Act>
  auto with_place(Act&& act) const {
    try {
      return act();
    } catch (const InputError& e) {
      below(e.where).refuse({e.found.en, e.found.ja}, e.accepted);
    }
  }

 private:
  std::string_view text_;
  std::string file_, path_;
  std::size_t at_ = 0;
};

const Tree::Members& members_of(const Tree& tree, const Place& place) {
  if (const Tree::Members* members = tree.members()) return *members;
  place.refuse({"this is no object", "オブジェクトでない"}, {"write { ... }", "{ ... } と書く"});
}
const Tree::List& list_of(const Tree& tree, const Place& place) {
  const Tree::List* list = tree.list();
  if (!list) place.refuse({"this is no list", "リストでない"}, {"write [ ... ]", "[ ... ] と書く"});
  if (list->size() > most_items)
    place.refuse({"the list is too long", "リストが長すぎる"}, {"200 items are read", "200 個まで"});
  return *list;
}
std::string text_in(const Tree& tree, const Place& place) {
  if (tree.string()) return *tree.string();
  place.refuse({excerpt(to_json(tree, 0)) + " is no text", excerpt(to_json(tree, 0)) + " は文字列でない"},
               {"write it in quotes", "引用符で囲む"});
}
// An expression may be written as a number.
std::string expression_in(const Tree& tree, const Place& place) {
  return tree.number() ? number_text(*tree.number()) : text_in(tree, place);
}
Tree patch_in(const Tree& tree, const Place& place) {
  members_of(tree, place);
  return tree;
}

void check_keys(const Tree& tree, const std::vector<std::string_view>& known, const Place& place) {
  for (const auto& [key, value] : members_of(tree, place))
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      std::string all;
      for (const std::string_view name : known) all += (all.empty() ? "" : ", ") + std::string(name);
      place.below(key).refuse({"there is no such key", "そのようなキーはない"},
                              {"known are: " + all, "あるのは " + all});
    }
}

bool is_name(std::string_view name) {
  return !name.empty() && name.size() <= 40 &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") == name.npos;
}

// "measure" and the options among the keys of `tree`.
Measuring measuring_in(const Tree& tree, const Place& place) {
  Measuring out;
  if (const Tree* what = tree.find("measure"))
    out.what = place.with_place([&] { return &find_measurement(text_in(*what, place.below("measure"))); });
  const Slots options = slots(out.options);
  for (const Slot& slot : options)
    if (const Tree* value = tree.find(slot.path)) place.with_place([&] { assign(slot, *value); });
  return out;
}

// What a text says in both languages, or what needs no language: a formula.
Text text_pair_in(const Tree& tree, const Place& place) {
  if (tree.string()) return {*tree.string(), *tree.string()};
  check_keys(tree, {"en", "ja"}, place);
  Text out;
  for (const auto& [key, value] : *tree.members()) (key == "en" ? out.en : out.ja) = text_in(value, place.below(key));
  if (out.en.empty() || out.ja.empty())
    place.refuse({"one language is missing", "片方の言語がない"},
                 {"write \"en\" and \"ja\"", "\"en\" と \"ja\" を書く"});
  return out;
}

// The keys of a number or a task: those of its measurement's options, and its own.
std::vector<std::string_view> with_options(std::vector<std::string_view> own) {
  std::apply([&](const auto&... f) { (own.push_back(f.about.name), ...); }, fields_of<MeasurementOptions>);
  return own;
}

void need(const Tree& tree, std::string_view key, const Place& place) {
  if (!tree.find(key))
    place.refuse({"\"" + std::string(key) + "\" is missing", "\"" + std::string(key) + "\" がない"},
                 {"add it", "書き加える"});
}

int whole_in(const Tree& tree, int least, int most, const Place& place) {
  const double* v = tree.number();
  if (v && *v >= least && *v <= most) return int(*v);
  const std::string low = std::to_string(least), high = std::to_string(most);
  place.refuse({excerpt(to_json(tree, 0)) + " is not possible", excerpt(to_json(tree, 0)) + " は使えない"},
               {"give " + low + " to " + high, low + " から " + high + " を書く"});
}

LessonNumber number_in(const std::string& name, const Tree& tree, const Place& place) {
  if (!is_name(name))
    place.refuse({"this is no name of a number", "数の名前に使えない"},
                 {"use letters, digits and _", "英数字と _ を使う"});
  check_keys(
      tree,
      with_options({"measure", "value", "scene", "against", "expect", "tolerance", "source", "digits", "decimals"}),
      place);
  LessonNumber out;
  out.name = name;
  out.measuring = measuring_in(tree, place);
  for (const auto& [key, value] : *tree.members()) {
    const Place at = place.below(key);
    if (key == "value") out.value = expression_in(value, at);
    if (key == "scene") out.scene = patch_in(value, at);
    if (key == "against") out.against = patch_in(value, at);
    if (key == "expect") out.expect = expression_in(value, at);
    if (key == "tolerance") out.tolerance = expression_in(value, at);
    if (key == "source") out.source = text_pair_in(value, at);
    if (key == "digits") out.digits = whole_in(value, 1, 17, at);
    if (key == "decimals") out.decimals = whole_in(value, 0, 15, at);
  }
  if ((out.measuring.what == nullptr) == out.value.empty())
    place.refuse({"a number is measured or computed", "数は測定か計算のどちらか"},
                 {"give \"measure\" or \"value\"", "\"measure\" か \"value\" の一方を書く"});
  if (!out.expect.empty() && (out.tolerance.empty() || out.source.en.empty()))
    place.refuse({"what is expected needs a tolerance and a source", "期待値には許容差と出典が必要"},
                 {"give \"tolerance\" and \"source\"", "\"tolerance\" と \"source\" を書く"});
  return out;
}

LessonTask task_in(const Tree& tree, const Place& outer) {
  need(tree, "id", outer);
  LessonTask out;
  out.id = text_in(*tree.find("id"), outer);
  const Place place = outer.below(out.id);
  check_keys(tree, with_options({"id", "measure", "against", "goal", "tolerance", "solution"}), place);
  for (const std::string_view key : {"measure", "goal", "tolerance", "solution"}) need(tree, key, place);
  out.measuring = measuring_in(tree, place);
  out.goal = expression_in(*tree.find("goal"), place.below("goal"));
  out.tolerance = expression_in(*tree.find("tolerance"), place.below("tolerance"));
  out.solution = patch_in(*tree.find("solution"), place.below("solution"));
  if (const Tree* against = tree.find("against")) out.against = patch_in(*against, place.below("against"));
  return out;
}

LessonStep step_in(const Tree& tree, const std::string& id, const LessonStep* before, const Place& place) {
  check_keys(tree, {"id", "scene", "view", "offer", "numbers", "tasks"}, place);
  LessonStep out;
  out.id = id;
  if (before) out.preset = before->preset, out.view = before->view;
  if (const Tree* scene = tree.find("scene"))
    out.preset = merge_patch(std::move(out.preset), patch_in(*scene, place.below("scene")));
  if (!out.preset.members())
    place.refuse({"the first step has no scene", "最初のステップにシーンがない"},
                 {"give \"scene\"", "\"scene\" を書く"});
  out.preset.at("schema") = 1;
  if (const Tree* view = tree.find("view")) {
    const Place at = place.below("view");
    const Slots all = slots(out.view);
    for (const auto& [key, value] : members_of(*view, at))
      at.with_place([&, &key = key, &value = value] { assign(find_slot(all, key), value); });
  }
  if (const Tree* offer = tree.find("offer"))
    for (const Tree& path : list_of(*offer, place.below("offer")))
      out.offered.push_back(text_in(path, place.below("offer")));
  if (const Tree* numbers = tree.find("numbers"))
    for (const auto& [name, value] : members_of(*numbers, place.below("numbers")))
      out.numbers.push_back(number_in(name, value, place.below("numbers").below(name)));
  if (const Tree* tasks = tree.find("tasks"))
    for (const Tree& task : list_of(*tasks, place.below("tasks")))
      out.tasks.push_back(task_in(task, place.below("tasks")));
  return out;
}

}  // namespace

std::vector<LessonStep> parse_lesson_json(std::string_view json, const std::string& where) {
  const Tree tree = parse_json(json, where);
  const Place place(json, where);
  check_keys(tree, {"schema", "steps"}, place);
  const Tree* schema = tree.find("schema");
  if (!schema || *schema != Tree(1))
    place.refuse({"the version is not known", "版が分からない"}, {"write \"schema\": 1", "\"schema\": 1 と書く"});
  need(tree, "steps", place);
  std::vector<LessonStep> steps;
  for (const Tree& step : list_of(*tree.find("steps"), place.below("steps"))) {
    need(step, "id", place.below("steps"));
    const std::string id = text_in(*step.find("id"), place.below("steps"));
    const Place at = place.below(id);
    for (const LessonStep& other : steps)
      if (other.id == id)
        at.refuse({"the id is used twice", "id が二度使われている"}, {"give each its own", "別の id にする"});
    if (steps.size() == most_steps) at.refuse({"too many steps", "ステップが多すぎる"}, {"100 are read", "100 まで"});
    steps.push_back(step_in(step, id, steps.empty() ? nullptr : &steps.back(), at));
  }
  if (steps.empty()) place.refuse({"there is no step", "ステップがない"}, {"give at least one", "一つ以上書く"});
  return steps;
}

}  // namespace cg
