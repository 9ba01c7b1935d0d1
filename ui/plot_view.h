// A plot in a panel, painted from the same description and the same layout as its SVG file.
#pragma once
#include <imgui.h>

#include <memory>

#include "measure/plot.h"

namespace cg {

struct App;

// What was laid out last, so that a plot is laid out only when something about it has changed.
struct PlotView {
  std::shared_ptr<const Plot> plot;
  ImVec2 size{0, 0};
  Language language = Language::english;
  ImFont* font = nullptr;
  PlotLayout layout;  // higher than `size` by `head` pixels, which are cut off
  float head = 0;     // the line of the title, where there is none
};

struct PlotMouse {
  int hovered = -1;      // index into Plot::points
  bool clicked = false;  // on that point
};

// `plot`, not null, at ImGui's cursor as an item of `size` pixels. `chosen`: the PlotPoint::index that is marked; -1:
// none. Each point is a place "point:" + its label in a test's dump.
PlotMouse draw_plot(App& app, PlotView& view, const char* id, std::shared_ptr<const Plot> plot, ImVec2 size,
                    int chosen);

}  // namespace cg
