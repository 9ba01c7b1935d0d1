#include "ui/state_dump.h"

#include <algorithm>

#include "params/file.h"
#include "ui/app.h"
#include "ui/challenge_game.h"
#include "ui/extremes_desk.h"
#include "ui/hemicube_desk.h"
#include "ui/lesson_player.h"
#include "ui/recording.h"
#include "ui/solver_panel.h"
#include "ui/trade_desk.h"
#include "workbench/preset.h"

namespace cg {
namespace {

Tree lesson_state(App& app) {
  Tree out;
  LessonPlayer& player = lessons_of(app);
  out.at("place") = player.place();
  out.at("ready") = player.current() != nullptr && !player.busy();
  out.at("error") = player.error() ? player.error()->message(Language::english) : std::string();
  Tree::List known;
  for (const LessonEntry& entry : player.list()) known.emplace_back(entry.id);
  out.at("list") = std::move(known);
  Tree tasks{Tree::Members{}};
  if (const LessonStep* step = player.current())
    for (const LessonTask& task : step->tasks) tasks.at(task.id) = player.task(task.id).done;
  out.at("tasks") = std::move(tasks);
  return out;
}

Tree probe_state(const App& app) {
  Tree out;
  out.at("side") = app.probing.side;
  if (const auto& probed = app.probing.results[std::size_t(app.probing.side)]) {
    const glm::ivec2 pixel = probed->probe.pixel;
    out.at("pixel") = Tree::List{pixel.x, pixel.y};
  }
  return out;
}

Tree challenge_state(const App& app) {
  Tree out;
  out.at("playing") = app.challenge && app.challenge->playing();
  out.at("given_up") = app.challenge && app.challenge->given_up();
  if (app.challenge && app.challenge->score()) out.at("score") = app.challenge->score()->value;
  return out;
}

Tree trade_state(const App& app) {
  Tree out;
  const std::span<const Knob> all = knobs();
  const auto knob = std::find_if(all.begin(), all.end(), [&](const Knob& k) { return k.id == app.settings.knob; });
  out.at("measuring") = app.trades && app.trades->running();
  if (!app.trades || knob == all.end()) return out;
  if (const auto measured = app.trades->of(*knob)) out.at("points") = int(measured->trade.points.size());
  const auto chosen = app.trades->chosen.find(app.settings.knob);
  if (chosen != app.trades->chosen.end()) out.at("chosen") = int(chosen->second);
  return out;
}

Tree solver_state(const App& app) {
  Tree out;
  out.at("busy") = solver_at_work(app);
  if (!app.solver) return out;
  out.at("playing") = app.solver->desk.playing();
  const SolverStateHandle now = app.solver->desk.state().newest;
  if (!now) return out;
  out.at("solver") = std::string(names_of<RadiositySolver>[std::size_t(now->task->options.solver)].id);
  out.at("step") = double(now->step);
  out.at("patches") = double(now->task->solution->patches->patches.size());
  out.at("ended") = now->end != SolverEnd::none;
  return out;
}

Tree extremes_state(const App& app) {
  Tree out;
  out.at("checking") = app.extremes && app.extremes->checking_all();
  for (const ExtremeCase& c : extreme_cases())
    if (c.id == app.settings.extreme && app.extremes)
      if (const auto verdict = app.extremes->verdict(c))
        out.at("verdict") = std::string(names_of<Verdict>[std::size_t(*verdict)].id);
  return out;
}

Tree hemicube_state(const App& app) {
  Tree out;
  out.at("busy") = looks_at_hemicube(app);
  if (!app.hemicube) return out;
  const HemicubeDesk::State& s = app.hemicube->state();
  if (s.ground) out.at("patches") = int(s.ground->patches.patches.size());
  if (s.sight) out.at("shown") = int(s.sight->patch), out.at("resolution") = s.sight->view.resolution;
  if (s.row) out.at("sum") = s.row->row.sum, out.at("samples") = s.row->options.samples;
  if (s.pair) out.at("other") = int(s.pair->other());
  if (s.pair && s.pair->whole) out.at("factor") = s.pair->whole->there, out.at("exact") = s.pair->whole->known.value;
  return out;
}

Tree pointer_state() {
  const ImGuiIO& io = ImGui::GetIO();
  Tree out;
  out.at("x") = double(io.MousePos.x), out.at("y") = double(io.MousePos.y);
  out.at("down") = io.MouseDown[0];
  return out;
}

}  // namespace

void StateDump::place(std::string_view name, ImVec2 low, ImVec2 high) {
  places_[std::string(name)] =
      Tree::List{Tree(double(low.x)), Tree(double(low.y)), Tree(double(high.x)), Tree(double(high.y))};
}

const Tree::List* StateDump::placed(std::string_view name) const {
  const auto found = places_.find(std::string(name));
  return found != places_.end() ? found->second.list() : nullptr;
}

void StateDump::write(App& app, bool busy) {
  Tree out;
  out.at("settings") = values_of(slots(app.settings));
  try {
    out.at("scene") = preset_of(app.scene);
  } catch (const InputError&) {  // its model's file has gone
  }
  out.at("lesson") = lesson_state(app);
  out.at("probe") = probe_state(app);
  out.at("challenge") = challenge_state(app);
  out.at("trade") = trade_state(app);
  out.at("extremes") = extremes_state(app);
  out.at("solver") = solver_state(app);
  out.at("hemicube") = hemicube_state(app);
  out.at("presenting") = app.presenter.on;
  out.at("black") = app.presenter.black;
  out.at("sweeping") = app.sweep.item != 0;
  out.at("recording") = recorder_of(app).recording();
  out.at("can_undo") = app.history.can_undo();
  out.at("can_redo") = app.history.can_redo();
  out.at("full_screen") = app.presenter.full;
  out.at("calm") = app.figures.valid && !solver_at_work(app) && !looks_at_hemicube(app) && !busy && !app.gesture &&
                   !ImGui::IsAnyMouseDown() && !app.errands->busy() && !app.look.glyphs.changed &&
                   !lessons_of(app).busy() && !lessons_of(app).loading();
  out.at("pointer") = pointer_state();
  out.at("dialogue") = int(app.dialogue.kind);
  out.at("help") = app.help;
  Tree::List said;
  for (const Toast& toast : app.toasts) said.emplace_back(toast.text.en);
  out.at("said") = std::move(said);
  Tree places{Tree::Members{}};
  for (auto& [name, corners] : places_) places.at(name) = std::move(corners);
  places_.clear();
  out.at("places") = std::move(places);
  std::string text = to_json(out, 0);
  if (text == written_) return;
  written_ = text;
  out.at("serial") = ++serial_;
  worker_.submit([file = file_, bytes = to_json(out, 1)](Progress&) {
    try {
      save_file(file, bytes);
    } catch (const InputError&) {  // the test sees that nothing comes
    }
  });
}

void note_place(const App& app, std::string_view kind, std::string_view name) {
  if (app.dump)
    app.dump->place(std::string(kind) + ":" + std::string(name), ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

}  // namespace cg
