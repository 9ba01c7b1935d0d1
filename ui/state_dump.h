// What the window shows, as JSON in a file that a test reads: what is set, what is open, and where the controls are.
#pragma once
#include <imgui.h>

#include <filesystem>
#include <map>
#include <string>

#include "params/tree.h"
#include "workbench/worker.h"

namespace cg {

struct App;

class StateDump {
 public:
  explicit StateDump(std::filesystem::path file) : file_(std::move(file)) {}

  // A control of this frame: its name, and its corners in pixels.
  void place(std::string_view name, ImVec2 low, ImVec2 high);
  // The left, upper, right and lower edge of one of this frame's controls; null where it is not there.
  const Tree::List* placed(std::string_view name) const;
  // After a frame: the file is written, on a thread of its own, where something differs. `busy`: what the frame does
  // not know is still being made.
  void write(App& app, bool busy);

 private:
  std::filesystem::path file_;
  std::map<std::string, Tree> places_;
  std::string written_;
  double serial_ = 0;
  Worker worker_;
};

}  // namespace cg
