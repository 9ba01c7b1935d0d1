// Two techniques draw one scene, timed, and their pictures are compared.
#pragma once
#include <string>

#include "image/difference.h"
#include "params/tree.h"
#include "scene/technique.h"

namespace cg {

struct TimedFrame {
  Frame frame;
  double ms = 0;  // on the clock, without what a first picture costs (a context, shaders, buffers)
};

// Draws a small picture first, untimed: it pays for what is made once. Throws InputError and Cancelled.
TimedFrame draw_timed(const Technique& technique, const Scene& scene, const View& view, Progress& progress);

struct Comparison {
  std::string left, right;  // ids of the techniques
  int width = 0, height = 0;
  TimedFrame left_frame, right_frame;
  Difference difference;
};

// `progress` runs once through each.
Comparison compare(const Technique& left, const Technique& right, const Scene& scene, const View& view,
                   Progress& progress);

// left, right, width, height, coverage_mismatch, covered, max_error, rmse, over_1_255, psnr (null where nothing
// differs), left_ms, right_ms.
Tree json_of(const Comparison& comparison);

// The same for a person: lines, each ended.
std::string text_of(const Comparison& comparison, Language language);

}  // namespace cg
