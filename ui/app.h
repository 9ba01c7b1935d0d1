// The state that the whole window edits: a scene, two techniques beside each other, and how they are looked at.
// Panels and panes read and change it in the one thread of the window; a change is found by comparing values.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "params/input_error.h"
#include "scene/technique.h"
#include "ui/code_view.h"
#include "ui/look.h"
#include "ui/opening.h"
#include "ui/presenter.h"
#include "ui/presets.h"
#include "ui/probe_jobs.h"
#include "ui/settings.h"
#include "ui/sweep.h"
#include "workbench/history.h"
#include "workbench/job.h"
#include "workbench/overlay.h"

namespace cg {

// What is drawn alone: one term of the light model, of one light or of all. Quantity::none is everything.
struct Isolated {
  Quantity term = Quantity::none;
  int light = -1;  // index into Scene::lights; -1: all
  friend bool operator==(const Isolated&, const Isolated&) = default;
};

// The pixel that is asked about, the same in both pictures.
struct Probing {
  std::optional<glm::dvec2> at;  // a part of the picture's width and height, from the top-left corner; nothing: none
  int side = 0;                  // the picture whose numbers are shown: where it was clicked
  int vertex = -1;               // with Gouraud shading: whose factors are shown; -1: the interpolated terms
  std::array<std::shared_ptr<const Probed>, 2> results;  // filled by the panes; null before they are there
};

// What the panes know about the two newest pictures of the same scene.
struct Figures {
  bool valid = false;    // both pictures are there and belong together
  double max_error = 0;  // 0..1, after the display transform, over pixels that both cover
  double rmse = 0;       // the same
  long coverage_mismatch = 0;
  long over_1_255 = 0;
  double left_ms = 0, right_ms = 0;
};

struct Toast {
  Text text;
  bool error = false;
  double until = 0;  // in seconds of the window's clock
};

// The one value that is being typed.
struct Editing {
  ImGuiID item = 0;  // 0: none
  std::string text;
  bool fresh = false;  // the field takes the keyboard at the next frame
};

// The dialogue that is open, over all else.
struct Dialogue {
  enum Kind { none, open, save, picture, export_scene, trade, save_solution, open_solution } kind = none;
  std::string text;
  bool fresh = false;        // it opens in this frame
  int format = 2;            // of an export: an ExportFormat; of a trade: CSV, JSON, SVG
  std::string subject = {};  // of a trade: the knob's id
};

class ChallengeGame;
class ExtremesDesk;
class HemicubeDesk;
struct LectureDesk;
class LessonPlayer;
class MistakeJobs;
class Panes;
class RadiosityDesk;
class Recorder;
struct SolverPanel;
class StateDump;
class TradeDesk;
class WorldView;
struct QuizGame;

struct App {
  Scene scene;  // meshes loaded; the panes draw a copy of it with `isolated` applied
  History<Scene> history{Scene{}};
  std::string preset;                // the file that the scene came from or was saved to; empty: none
  std::vector<std::string> bundled;  // names of the models that come with the program
  std::vector<std::string> recent;   // what was opened, the newest first
  std::shared_ptr<Errands> errands = std::make_shared<Errands>();

  std::vector<Technique> techniques;  // at least one; those unavailable stay in the list, with their reason
  int left = 0, right = 0;            // indices into techniques

  Settings settings;
  Look look;
  Isolated isolated;
  std::optional<Isolated> peek;  // drawn in its place while the mouse rests on a term; the probe stays as it was
  Probing probing;
  int light = 0, object = 0;  // selected: indices into the scene's lists; the list may be empty
  bool fit_asked = false;     // the panes fit the camera at the next frame, then clear it
  bool turntable = false;

  std::shared_ptr<LessonPlayer> lessons;     // through lessons_of()
  std::shared_ptr<LectureDesk> lecture;      // what was changed since the window opened; null before the first frame
  std::shared_ptr<ChallengeGame> challenge;  // through game_of()
  std::shared_ptr<Recorder> recorder;        // through recorder_of()
  std::shared_ptr<StateDump> dump;           // null unless a test asked for it
  Sweep sweep;
  Presenter presenter;

  // The pictures' own affairs. Made in the first frame; let go while the window's OpenGL context is still there.
  std::shared_ptr<Panes> panes;
  std::shared_ptr<WorldView> world;          // the same of the view from outside
  std::shared_ptr<RadiosityDesk> radiosity;  // through desk_of()
  // Filled by the panes.
  Figures figures;
  DrawingHandle drawings[2];  // the newest of the left and the right technique; null before the first
  std::vector<Toast> toasts;

  // Hovering a quantity in one place lights it in all: widgets read `lit` and write `lit_next`.
  Quantity lit = Quantity::none, lit_next = Quantity::none;
  // What a panel points at, over the pictures: panels write `pointed_next` in every frame.
  std::vector<Lines> pointed, pointed_next;

  CodeView code;
  PresetShelf presets;
  std::shared_ptr<MistakeJobs> mistake_jobs;  // null before the panel was shown
  std::shared_ptr<QuizGame> quiz;             // null: none is going on
  std::shared_ptr<TradeDesk> trades;          // through trades_of()
  std::shared_ptr<ExtremesDesk> extremes;     // through extremes_of()
  std::shared_ptr<SolverPanel> solver;        // through solver_of(); let go with the panes
  std::shared_ptr<HemicubeDesk> hemicube;     // through hemicube_of()

  double content_scale = 1;  // of the monitor
  Editing editing;
  Dialogue dialogue;
  bool help = false;
  double now = 0;              // seconds of the window's clock at this frame
  bool gesture = false;        // a drag in the panes is one step of undo: set by them while it lasts
  bool animating = false;      // set in a frame by whoever needs the next frame at once (a drag, a turntable)
  double next_frame = 0;       // the time by which there must be a frame though nothing happens
  double scrolled_at = -1;     // when a panel was last scrolled: then the wheel turns no value
  std::function<void()> wake;  // asks for a frame; may be called from any thread

  Language language() const { return settings.language; }
};

// After a frame: what changed in the scene becomes a step of undo; a drag is one.
void keep_history(App& app);

// Writes a text at ImGui's cursor, in the window's language, its glyphs made sure of.
void write(App& app, std::string_view text);
void write(App& app, const Words& words);
void write(App& app, const Text& text);

// The same for a draw list: the text, its glyphs made sure of.
inline std::string_view noted(App& app, std::string_view text) { return app.look.glyphs.note(text); }
inline std::string_view noted(App& app, const Words& words) { return noted(app, words.in(app.language())); }
inline std::string_view noted(App& app, const Text& text) { return noted(app, text.in(app.language())); }

// The last item of ImGui's is the control of that name: for a test that asked where controls are.
void note_place(const App& app, std::string_view kind, std::string_view name);

// Tells the user; an error stays longer.
void say(App& app, Text text);
void say(App& app, const InputError& error);

}  // namespace cg
