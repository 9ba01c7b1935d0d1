// Two scenes that are kept beside each other, A and B: stored, shown in turn, compared, saved.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "workbench/complaint.h"
#include "workbench/scene_differences.h"

namespace cg {

struct App;

struct PresetShelf {
  std::array<std::optional<Scene>, 2> kept;
  std::array<std::string, 2> names;  // what each was when it was stored: its file or its model

  // What could not be understood of the C file that was opened last.
  std::string imported;
  std::vector<Complaint> complaints;

  // In what they differ; B is the scene in hand where only A is kept, and the other way round. Compared again only
  // where one has changed.
  const std::vector<ParameterDifference>& differences(const Scene& in_hand);

 private:
  Scene a_, b_;
  std::vector<ParameterDifference> differences_;
};

void store_preset(App& app, int which);
void show_preset(App& app, int which);
// The other one: B while A is shown, else A.
void flip_presets(App& app);
// Gives the scene in hand the value, or the item of a list, that A (0) or B (1) has at `path`.
void take_over(App& app, const std::string& path, int which);

}  // namespace cg
