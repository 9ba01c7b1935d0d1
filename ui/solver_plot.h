// The error bound of all five solvers as one plot.
#pragma once
#include "measure/plot.h"
#include "ui/solver_desk.h"
#include "ui/solver_race.h"

namespace cg {

// A solver's name where there is little room.
const Words& short_name(RadiositySolver solver);

// Why LU is not drawn over sweeps, and how long it took; nothing before it is done.
std::optional<Text> lu_note(const SolverRace::Entries& entries);

// Over sweeps (linear, and LU has none) or over the seconds that the steps took (logarithmic). The line of `active` is
// thick; where `now` is not null its place is a point with the index `place_index`. A dashed line is the residual where
// it stops.
inline constexpr std::size_t place_index = 1;
Plot residual_plot(const SolverRace::Entries& entries, RadiositySolver active, const SolverState* now, double residual,
                   bool over_time);

}  // namespace cg
