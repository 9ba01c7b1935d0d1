// The session: what comes back at the next start.
#pragma once
#include "workbench/session.h"

namespace cg {

struct App;

// The window's size, as the session keeps it.
struct WindowPlacement {
  int width = 0, height = 0;  // 0: what fits the monitor
};
template <>
inline constexpr auto fields_of<WindowPlacement> = std::tuple{
    field(&WindowPlacement::width, {.name = "width", .range = {0, 16384}, .label = {"Width", "幅"}}),
    field(&WindowPlacement::height, {.name = "height", .range = {0, 16384}, .label = {"Height", "高さ"}}),
};

// Takes settings, recent files and, where `with_scene`, the scene of the last session.
void restore(App& app, WindowPlacement& placement, SessionStore& store, bool with_scene);

// Remembers what stands now; the store saves it every two seconds. Tells the user what the store has to say.
void keep(App& app, const WindowPlacement& placement, SessionStore& store);

// app.left and app.right from the ids in the settings. Techniques that cannot work here are passed over.
void choose_techniques(App& app);

}  // namespace cg
