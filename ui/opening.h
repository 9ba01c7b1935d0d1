// Files in and out, on a thread of their own: the window never waits for a disk.
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "params/words.h"
#include "workbench/worker.h"

namespace cg {

struct App;

// Runs a task on its thread, then what the task returned on the window's thread.
class Errands {
 public:
  using Done = std::function<void(App&)>;
  // `task` may throw InputError, which the user is told.
  void run(App& app, std::function<Done()> task);
  // Call once a frame.
  void finish(App& app);
  bool busy() const { return worker_.busy(); }

 private:
  std::mutex mutex_;
  std::vector<Done> done_;
  Worker worker_;  // last: it uses what stands above
};

// That the file was saved, and where.
void say_saved(App& app, const std::filesystem::path& file, const Text& more = {});

// Opens a shape, a model file or a preset in place of the scene; if that fails, nothing changes.
void open_in_window(App& app, std::string what);

// Saves to the preset the scene came from or was saved to last; asks where there is none.
void save_or_ask(App& app);
void save_as(App& app, std::filesystem::path file);

// Writes the picture of the side that the settings say, or of both.
void save_picture(App& app, std::filesystem::path file);

}  // namespace cg
