// A plan beside what really ran: each line with the bytes that it held and the milliseconds that it took.
#pragma once
#include <vector>

#include "scene/technique.h"

namespace cg {

struct MeasuredPass {
  Pass planned;
  bool ran = false;
  double ms = 0, first_ms = 0;  // CPU time: the median of the pictures after the first; of the first
  std::size_t held = 0;         // bytes
  bool kept = false;            // in the last picture: it was there from one before
};

struct MeasuredPlan {
  Plan plan;
  int pictures = 0;                  // that were drawn; 0: nothing is measured
  std::vector<MeasuredPass> passes;  // as in the plan
  std::vector<CodeRun> code;         // as the first picture had it
  double ms = 0;                     // of all passes
  std::vector<Text> differences;     // between the plan and what ran; none where all is well

  std::size_t held() const;
};

// What ran and was not in the plan, what was in the plan and did not run, and whose bytes are others.
std::vector<Text> differences(const Plan& plan, const Frame& frame);

// The plan beside one picture that was drawn by it.
MeasuredPlan measured(const Plan& plan, const Frame& frame);

// Draws the scene once, and `repeats` times more. Throws InputError and Cancelled.
MeasuredPlan measure_plan(const Technique& technique, const Scene& scene, const View& view, int repeats,
                          Progress& progress);

std::string size_text(std::size_t bytes);  // "12 KiB"
std::string ms_text(double ms);            // "0.042 ms"

}  // namespace cg
