// The dialogue "Export": the scene as a preset, C, a GLUT program or meshes, to a file or the clipboard.
#pragma once

namespace cg {

struct App;

// The part of the dialogue in the popup that is open; true when it is done.
bool draw_export_dialogue(App& app);

}  // namespace cg
