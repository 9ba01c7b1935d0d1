// The one layout of the window: bar above, parameters to the left, pictures in the middle, panels to the right, the
// formula below. No loose windows.
#pragma once
#include <imgui.h>

#include "params/slots.h"
#include "params/words.h"
#include "ui/pane.h"

namespace cg {

struct App;

// Draws all of the window, between ImGui's NewFrame and Render, into `size` pixels (either may be 0).
// `middle` draws the pictures; a test without OpenGL gives another.
void draw_window(App& app, ImVec2 size, void (*middle)(App&, ImVec2) = draw_panes);

// Its parts, each into the child window that is open.
void draw_top_bar(App& app);
void draw_parameters(App& app);
void draw_radiosity(App& app, const Slots& all);  // of the scene, in a section of the parameters
void draw_view_bar(App& app);
void draw_side_panel(App& app);
void draw_strip(App& app);       // the equation
void draw_code_panel(App& app);  // the listing, right of it
// What the side panel shows, by Side.
void draw_lesson_panel(App& app);
void draw_world_panel(App& app);
void draw_mistakes_panel(App& app);
void draw_presets_panel(App& app);
void draw_challenge_panel(App& app);
void draw_plan_panel(App& app);
void draw_mesh_panel(App& app);
void draw_trade_panel(App& app);
bool draw_large_trade(App& app, ImVec2 size);  // its plot in place of the panes, where that was chosen
void draw_extremes_panel(App& app);
void draw_solver_panel(App& app);
bool draw_large_solver(App& app, ImVec2 size);  // its plot or matrix in place of the panes, where that was chosen
void draw_hemicube_panel(App& app);
// On top of all: what was to be said, the list of shortcuts, the dialogues.
void draw_toasts(App& app, ImVec2 size);
void draw_help(App& app);
void draw_dialogues(App& app);
// A dialogue's path, `width` wide at scale 1; true when Enter takes it, in the field or with none at work (a key may
// come in the frame in which the dialogue opens).
bool path_field(App& app, const Words& hint, float width = 520);
bool save_field(App& app, const Words& hint, float width = 520);  // with the folder under it
bool draw_picture_dialogue(App& app);                             // into the popup; true when it is done
bool draw_trade_dialogue(App& app);                               // the same
bool draw_solution_dialogue(App& app);                            // the same

}  // namespace cg
