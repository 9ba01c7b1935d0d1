#include "ui/lesson_player.h"

#include <algorithm>

#include "raster/software.h"
#include "ui/app.h"
#include "ui/hemicube_desk.h"
#include "ui/keeping.h"
#include "ui/trade_desk.h"
#include "workbench/data_folder.h"
#include "workbench/environment.h"
#include "workbench/lesson_watcher.h"
#include "workbench/open.h"
#include "workbench/preset.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t last_step = std::size_t(-1);

LessonEntry entry_of(const fs::path& folder) {
  LessonEntry entry{folder, folder.filename().string(), {}, 0, {}};
  entry.title = {entry.id, entry.id};
  try {
    const Lesson lesson = read_lesson(folder);
    entry.steps = lesson.steps.size();
    entry.title = {lesson.in(Language::english).title, lesson.in(Language::japanese).title};
  } catch (const InputError& e) {
    entry.error = e;
  }
  return entry;
}

// The techniques for measurements: the software of one's own, so that the panes need not wait for it.
std::vector<Technique> for_measuring(std::vector<Technique> techniques) {
  for (Technique& t : techniques)
    if (t.id == "software") t = software_technique();
  return techniques;
}

bool same_place(const fs::path& a, const fs::path& b) { return a.lexically_normal() == b.lexically_normal(); }

}  // namespace

class LessonPlayer::Watched {
 public:
  explicit Watched(const fs::path& folder) : watcher(folder) {}
  LessonWatcher watcher;
};

LessonPlayer::LessonPlayer(std::vector<Technique> techniques, std::vector<fs::path> folders, std::function<void()> wake)
    : techniques_(for_measuring(std::move(techniques))),
      folders_(std::move(folders)),
      wake_(wake ? std::move(wake) : [] {}) {
  refresh_list();
}

void LessonPlayer::refresh_list() {
  lister_.submit([this, folders = folders_](Progress&) {
    std::vector<LessonEntry> out;
    for (const fs::path& place : folders)
      for (const fs::path& folder : lesson_folders(place)) out.push_back(entry_of(folder));
    list_mail_.put(std::move(out));
    wake_();
  });
}

void LessonPlayer::open(const fs::path& folder, std::size_t step, bool enter, std::vector<std::string> set) {
  set_ = std::move(set);
  if (lesson_ && same_place(folder, folder_)) {
    step_ = std::min(step, lesson_->steps.size() - 1);
    return enter_step(enter);
  }
  folder_ = folder;
  lesson_ = nullptr;
  error_.reset();
  step_ = step;
  enter_ = enter;
  start_.reset();
  numbers_.clear(), tasks_.clear();
  measured_.reset();
  reader_.submit([this, folder](Progress&) {
    watched_ = std::make_shared<Watched>(folder);
    version_mail_.put({folder, watched_->watcher.lesson(), watched_->watcher.error()});
    wake_();
  });
}

void LessonPlayer::resume(const std::string& name, bool enter) {
  const std::size_t colon = name.rfind(':');
  if (name.empty() || colon == name.npos) return;
  const fs::path path(name.substr(0, colon));
  const std::size_t step = std::size_t(std::max(1, std::atoi(name.c_str() + colon + 1))) - 1;
  std::error_code error;
  if (path.is_absolute() && fs::is_regular_file(path / "lesson.json", error)) return open(path, step, enter);
  for (const fs::path& place : folders_)
    if (!path.empty() && fs::is_regular_file(place / path / "lesson.json", error))
      return open(place / path, step, enter);
}

void LessonPlayer::close() {
  folder_.clear();
  lesson_ = nullptr;
  error_.reset();
  start_.reset();
  numbers_.clear(), tasks_.clear();
}

std::ptrdiff_t LessonPlayer::index_in_list() const {
  const auto found =
      std::find_if(list_.begin(), list_.end(), [&](const LessonEntry& e) { return same_place(e.folder, folder_); });
  return found == list_.end() ? -1 : found - list_.begin();
}

bool LessonPlayer::has_next() const {
  if (!lesson_) return false;
  return step_ + 1 < lesson_->steps.size() || (index_in_list() >= 0 && index_in_list() + 1 < std::ssize(list_));
}

bool LessonPlayer::has_previous() const { return lesson_ && (step_ > 0 || index_in_list() > 0); }

void LessonPlayer::go(int by) {
  if (!is_open()) {
    if (!list_.empty()) open(list_.front().folder);
    return;
  }
  if (!lesson_) return;
  const std::ptrdiff_t here = index_in_list();
  if (by > 0) {
    if (step_ + 1 < lesson_->steps.size()) return open(folder_, step_ + 1);
    if (has_next()) open(list_[std::size_t(here + 1)].folder, 0);
  } else {
    if (step_ > 0) return open(folder_, step_ - 1);
    if (has_previous()) open(list_[std::size_t(here - 1)].folder, last_step);
  }
}

void LessonPlayer::restart_step() {
  if (lesson_) enter_step(true);
}

std::string LessonPlayer::place() const {
  if (!is_open()) return {};
  const bool own = std::any_of(folders_.begin(), folders_.end(),
                               [&](const fs::path& p) { return same_place(p, folder_.parent_path()); });
  return (own ? folder_.filename().string() : fs::absolute(folder_).string()) + ":" +
         std::to_string(step_ == last_step ? 1 : step_ + 1);
}

std::optional<std::string> LessonPlayer::number(std::string_view name, const Scene& scene) const {
  return text_of_number(name, numbers_, scene);
}

// The step that step_ says; its scene is made on the opener's thread.
void LessonPlayer::enter_step(bool enter) {
  reading = {};
  enter_ = enter;
  start_.reset();
  measured_.reset();
  numbers_.clear(), tasks_.clear();
  opener_.submit([this, lesson = lesson_, step = step_](Progress&) {
    Opened out{lesson, step, {}, {}};
    try {
      out.scene = scene_of_step(*lesson, step);
    } catch (const InputError& e) {
      out.error = e;
    }
    opened_mail_.put(std::move(out));
    wake_();
  });
}

void LessonPlayer::take_version(App&, Version version) {
  if (!same_place(version.folder, folder_)) return;
  const std::shared_ptr<const Lesson> before = std::exchange(lesson_, version.lesson);
  error_ = version.error;
  if (!lesson_) return;
  if (!before) {
    step_ = std::min(step_, lesson_->steps.size() - 1);
    return enter_step(enter_);
  }
  if (before == lesson_) return;
  // The lecturer edits it: the step stays, by its name where it has moved; what its scene was is shown anew.
  const LessonStep old = before->steps[std::min(step_, before->steps.size() - 1)];
  const auto same =
      std::find_if(lesson_->steps.begin(), lesson_->steps.end(), [&](const LessonStep& s) { return s.id == old.id; });
  step_ = same == lesson_->steps.end() ? std::min(step_, lesson_->steps.size() - 1)
                                       : std::size_t(same - lesson_->steps.begin());
  const LessonStep& now = lesson_->steps[step_];
  enter_step(!(now.preset == old.preset && now.view == old.view));
}

void LessonPlayer::take_opened(App& app, Opened opened) {
  if (opened.lesson != lesson_ || opened.step != step_) return;
  if (opened.error) {
    error_ = opened.error;
    return;
  }
  start_ = std::move(*opened.scene);
  if (enter_) {
    Scene scene = *start_;
    try {
      for (const std::string& text : set_) set_parameter(scene, text);
      if (!set_.empty()) load_meshes(scene);
    } catch (const InputError& e) {  // the lesson was edited meanwhile
      say(app, e);
    }
    apply(app, scene, lesson_->steps[step_].view);
  }
  set_.clear();
  enter_ = false;
}

void LessonPlayer::take_measured(Measured measured) {
  if (measured.lesson != lesson_ || measured.step != step_) return;
  numbers_ = std::move(measured.numbers);
  tasks_ = std::move(measured.tasks);
  for (auto& [id, state] : tasks_) {
    const std::string key = place() + "#" + id;
    if (state.result && state.result->done) reached_.insert(key);
    state.done = reached_.contains(key);
  }
}

// One step of undo, whatever is being dragged.
void LessonPlayer::apply(App& app, const Scene& scene, const LessonView& view) {
  stop_measuring(app);
  app.history.end_gesture();
  app.scene = scene;
  app.history.change(app.scene);
  app.preset.clear();
  app.light = app.object = 0;
  app.turntable = false;
  Settings& s = app.settings;
  s.left = view.left, s.right = view.right, s.view = view.view;
  s.handles = view.handles, s.axes = view.axes, s.wireframe = view.wireframe, s.clamped = view.clamped;
  s.vertex_normals = view.vertex_normals, s.face_normals = view.face_normals;
  if (!view.knob.empty()) s.knob = view.knob;
  if (!view.extreme.empty()) s.extreme = view.extreme;
  if (view.patch >= 0) show_hemicube(app, view);
  choose_techniques(app);
  app.isolated = {quantity_of(view.term), view.light};
  app.peek.reset();
  app.probing = {};
}

void LessonPlayer::watch(App& app) {
  if (!is_open() || app.now < next_look_ || reader_.busy()) {
    if (is_open()) app.next_frame = std::min(app.next_frame, std::max(next_look_, app.now + 0.05));
    return;
  }
  next_look_ = app.now + 1;
  app.next_frame = std::min(app.next_frame, next_look_);
  reader_.submit([this, folder = folder_](Progress&) {
    if (!watched_ || !watched_->watcher.poll()) return;
    version_mail_.put({folder, watched_->watcher.lesson(), watched_->watcher.error()});
    wake_();
  });
}

// The step's numbers and tasks for the scene as it stands; while it is dragged, about five times a second. Work that
// takes longer is given up where the scene has become another.
void LessonPlayer::measure_scene(App& app) {
  const LessonStep* step = current();
  if (!step || !start_ || enter_ || (step->numbers.empty() && step->tasks.empty())) return;
  if (measured_ && *measured_ == app.scene) return;
  constexpr double patience = 1;  // seconds
  if (app.now < measure_after_ + (measurer_.busy() ? patience : 0)) {
    app.next_frame = std::min(app.next_frame, std::max(measure_after_, app.now + 0.05));
    return;
  }
  measured_ = app.scene;
  measure_after_ = app.now + 0.2;
  measurer_.submit(
      [this, lesson = lesson_, index = step_, scene = app.scene, start = *start_](Progress& progress) {
        const LessonStep& s = lesson->steps[index];
        Measured out{lesson, index, {}, {}};
        try {
          out.numbers =
              compute_numbers(s, preset_of(scene, lesson->folder), lesson->folder, techniques_, progress, solved_);
        } catch (const InputError&) {  // a model's file is gone: then there are no numbers
        }
        for (const LessonTask& task : s.tasks) {
          TaskState& state = out.tasks[task.id];
          try {
            state.result = check_task(task, scene, start, lesson->folder, techniques_, progress, solved_);
          } catch (const InputError& e) {
            state.problem = Text(e.message(Language::english), e.message(Language::japanese));
          }
        }
        measured_mail_.put(std::move(out));
        wake_();
      },
      true);
}

void LessonPlayer::update(App& app) {
  if (auto list = list_mail_.take()) list_ = std::move(*list);
  if (auto version = version_mail_.take()) take_version(app, std::move(*version));
  if (auto opened = opened_mail_.take()) take_opened(app, std::move(*opened));
  if (auto measured = measured_mail_.take()) take_measured(std::move(*measured));
  watch(app);
  measure_scene(app);
}

LessonPlayer& lessons_of(App& app) {
  if (!app.lessons) {
    std::vector<fs::path> folders{data_folder() / "lessons"};
    if (const auto own = data_home_folder()) folders.push_back(*own / "lessons");
    app.lessons = std::make_shared<LessonPlayer>(app.techniques, std::move(folders), app.wake);
  }
  return *app.lessons;
}

}  // namespace cg
