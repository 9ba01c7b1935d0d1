// What the lesson's panel shares with the presentation and the bar above.
#pragma once
#include <imgui.h>

namespace cg {

struct App;

// The step's text into the room there is; `presenting`, without the lesson's introduction, and below it the parameters
// that the step offers.
void draw_lesson_step(App& app, bool presenting);

// The parameters that the open step offers, a row each, grouped by what they belong to. False where no step is open or
// it offers none.
bool draw_offered_parameters(App& app);

// Where the lesson is, in one line of `room` pixels at `at` (the baseline is 21.5 units below): number, title, step,
// arrows. Returns the width that it took; 0 where no lesson is open or there is no room.
float lesson_place_width(App& app);  // that it would like
float draw_lesson_place(App& app, ImVec2 at, float room);

}  // namespace cg
