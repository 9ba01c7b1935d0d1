// The radiosity parameters in the order of the lecture, and how far their solution has come.
#include "ui/layout.h"
#include "ui/lines.h"
#include "ui/parameter.h"
#include "ui/radiosity_desk.h"
#include "ui/widgets.h"

namespace cg {
namespace {

// Nothing where no solution was asked for.
void draw_state(App& app) {
  const RadiosityDesk::State state = desk_of(app).state();
  const Language l = app.language();
  const Palette& p = app.look.palette;
  if (!wants_radiosity(app.scene))
    return small_text(
        app,
        Words{"Solved where the ambient term comes from radiosity.", "環境光項をラジオシティにすると計算する。"}.in(l),
        p.dim);
  if (state.busy) {
    const std::string percent = std::to_string(int(100 * state.fraction)) + " %";
    small_pair_line(app, Words{"Solving", "計算中"}.in(l), percent, p.accent);
    app.next_frame = std::min(app.next_frame, app.now + 0.1);
  }
  if (state.message) return small_text(app, state.message->in(l), p.error);
  if (!state.newest.solution) return;
  small_text(app, state.newest.field->summary.in(l), p.text);
  for (const Text& line : report_of(*state.newest.solution)) small_text(app, line.in(l), p.dim);
}

}  // namespace

void draw_radiosity(App& app, const Slots& all) {
  const Radiosity& r = app.scene.radiosity;
  // What the chosen method does not use is left out.
  const auto rows = [&](std::initializer_list<std::string_view> names) { parameters(app, all, "radiosity.", names); };
  draw_state(app);
  rows({"patch_size", "adaptive_levels"});
  if (r.adaptive_levels > 0) rows({"gradient"});
  rows({"form_factors"});
  const bool hemicube = r.form_factors == FormFactors::hemicube, rays = r.form_factors == FormFactors::monte_carlo;
  if (hemicube) rows({"item_buffer", "resolution", "weight"});
  if (rays) rows({"rays"});
  if (hemicube || r.form_factors == FormFactors::nusselt) rows({"samples", "placement"});
  rows({"normalise", "solver"});
  if (r.solver != RadiositySolver::lu) rows({"residual"});
  rows({"memory"});
}

}  // namespace cg
