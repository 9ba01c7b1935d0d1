// The lesson that is open in the window: read, watched and measured on threads of its own, so that the window never
// waits for a file, a mesh or a measurement.
#pragma once
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "params/input_error.h"
#include "ui/mailbox.h"
#include "workbench/lesson.h"
#include "workbench/lesson_numbers.h"
#include "workbench/worker.h"

namespace cg {

struct App;

// A lesson in the list.
struct LessonEntry {
  std::filesystem::path folder;
  std::string id;         // the folder's name
  Text title;             // the id where the lesson cannot be read
  std::size_t steps = 0;  // 0 where it cannot be read
  std::optional<InputError> error;
};

// What the reader did with a question.
struct Answer {
  int chosen = -1;
  bool revealed = false;
};

// How much of the step's text is seen.
struct Reading {
  float at = 0, most = 0, page = 0;  // pixels: where it is scrolled to, how far it can be, what is seen at once
  int turn = 0;                      // pages to be turned in the next frame
};

// A task of the step, as the scene stands.
struct TaskState {
  std::optional<TaskResult> result;
  std::optional<Text> problem;
  bool done = false;  // it was reached once
};

class LessonPlayer {
 public:
  // `techniques` may be used by other threads too (ui/one_at_a_time.h). `folders`: where lessons stand, each with a
  // folder a lesson. `wake` is called on other threads when there is something new.
  LessonPlayer(std::vector<Technique> techniques, std::vector<std::filesystem::path> folders,
               std::function<void()> wake);

  const std::vector<LessonEntry>& list() const { return list_; }
  void refresh_list();

  // Opens the lesson in `folder` at a step (from 0; beyond the last is the last). `enter`: its scene, techniques and
  // view come with it; else the window stays as it is. `set`: what is set in the scene of that step when it comes,
  // "path=value", known to be possible there.
  void open(const std::filesystem::path& folder, std::size_t step = 0, bool enter = true,
            std::vector<std::string> set = {});
  // The one that `name` says, as place() wrote it. Nothing happens where it is not there.
  void resume(const std::string& name, bool enter);
  void close();
  // One step on (1) or back (-1), past a lesson's ends into the next and the one before. Without a lesson: the first.
  void go(int by);
  // The step's scene, techniques and view again, as they were at its beginning.
  void restart_step();

  bool is_open() const { return !folder_.empty(); }
  bool loading() const { return is_open() && !lesson_; }
  const std::shared_ptr<const Lesson>& lesson() const { return lesson_; }  // null while it is read
  std::size_t step() const { return step_; }
  const LessonStep* current() const { return lesson_ ? &lesson_->steps[step_] : nullptr; }
  const std::filesystem::path& folder() const { return folder_; }
  bool has_next() const;
  bool has_previous() const;
  // "03-shading:2", for the session; empty: none is open.
  std::string place() const;

  // What is wrong with the lesson's files as they are now; the lesson is the last good version then.
  const std::optional<InputError>& error() const { return error_; }
  // The step's text with its numbers, for the scene as it stands.
  std::optional<std::string> number(std::string_view name, const Scene& scene) const;
  const TaskState& task(const std::string& id) { return tasks_[id]; }
  Reading reading;  // of the presentation
  Answer& answer(std::size_t question) { return answers_[{place(), question}]; }

  // Once a frame: takes what is new, and gives work away.
  void update(App& app);
  // Something is being read or measured.
  bool busy() const { return reader_.busy() || opener_.busy() || measurer_.busy(); }

 private:
  struct Version {
    std::filesystem::path folder;
    std::shared_ptr<const Lesson> lesson;
    std::optional<InputError> error;
  };
  struct Opened {
    std::shared_ptr<const Lesson> lesson;
    std::size_t step = 0;
    std::optional<Scene> scene;
    std::optional<InputError> error;
  };
  struct Measured {
    std::shared_ptr<const Lesson> lesson;
    std::size_t step = 0;
    std::vector<NumberResult> numbers;
    std::map<std::string, TaskState> tasks;
  };
  class Watched;  // the files, on the reader's thread

  void take_version(App& app, Version version);
  void take_opened(App& app, Opened opened);
  void take_measured(Measured measured);
  void enter_step(bool enter);
  void apply(App& app, const Scene& scene, const LessonView& view);
  void watch(App& app);
  void measure_scene(App& app);
  std::ptrdiff_t index_in_list() const;

  std::vector<Technique> techniques_;
  SolvedScenes solved_;  // on the measurer's thread
  std::vector<std::filesystem::path> folders_;
  std::function<void()> wake_;

  std::vector<LessonEntry> list_;
  std::filesystem::path folder_;
  std::shared_ptr<const Lesson> lesson_;
  std::optional<InputError> error_;
  std::size_t step_ = 0;
  bool enter_ = false;            // when the scene of the step is there
  std::vector<std::string> set_;  // in that scene
  double next_look_ = 0;          // at the files
  std::optional<Scene> start_;    // of the step
  std::vector<NumberResult> numbers_;
  std::map<std::string, TaskState> tasks_;
  std::map<std::pair<std::string, std::size_t>, Answer> answers_;
  std::set<std::string> reached_;  // tasks that were once done: place and id
  std::optional<Scene> measured_;  // the scene that the numbers are of
  double measure_after_ = 0;

  std::shared_ptr<Watched> watched_;
  Mailbox<std::vector<LessonEntry>> list_mail_;
  Mailbox<Version> version_mail_;
  Mailbox<Opened> opened_mail_;
  Mailbox<Measured> measured_mail_;
  Worker lister_, reader_, opener_, measurer_;  // last: they use the mailboxes
};

// The window's own player, made at the first call.
LessonPlayer& lessons_of(App& app);

}  // namespace cg
