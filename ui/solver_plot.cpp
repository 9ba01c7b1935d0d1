#include "ui/solver_plot.h"

#include <algorithm>
#include <cmath>

#include "measure/verdict.h"

namespace cg {

namespace {

constexpr std::size_t most_points = 160;  // of a line: more cannot be told apart
// What lies below is drawn there: LU ends far under all that the others are asked for.
constexpr double floor_below = 0.1;
constexpr double ceiling_above = 1e3;  // of one that diverges, over where it began

class Builder {
 public:
  // `start`: the seconds that stand for 0, which a logarithm has no place for.
  Builder(double residual, bool over_time, double start)
      : over_time_(over_time), least_(residual * floor_below), start_(start) {}

  void add(RadiositySolver kind, const std::vector<ResidualPoint>& curve, bool active) {
    if (curve.empty() || (kind == RadiositySolver::lu && !over_time_)) return;
    PlotLine line;
    line.ink = ink_of_series(std::size_t(kind));
    line.weight = active ? 2 : 1;
    const std::size_t stride = (curve.size() + most_points - 1) / most_points;
    for (std::size_t i = 0; i < curve.size(); ++i)
      if (i % stride == 0 || i + 1 == curve.size()) enter(line, curve[i], kind);
    if (line.x.empty()) return;
    PlotPoint end;
    end.x = line.x.back(), end.y = line.y.back();
    end.series = std::size_t(kind);
    plot.points.push_back(std::move(end));
    plot.legend.push_back({line.ink, Plot::Entry::Sign::line, short_name(kind)});
    plot.lines.push_back(std::move(line));
  }

  // Where the solver that is looked at stands, on its line.
  void add_place(const SolverState& now, const std::vector<ResidualPoint>& curve) {
    const ResidualPoint at = point_at(curve.size() > 1 && curve.back().step >= now.step ? curve : now.curve, now.step);
    PlotPoint place;
    place.series = std::size_t(now.task->options.solver);
    place.index = place_index;
    place.x = over_time_ ? std::max(at.seconds, start_) : now.sweeps;
    place.y = value(at.error_bound);
    if (!over_time_ && now.task->options.solver == RadiositySolver::lu) return;
    plot.points.push_back(std::move(place));
  }

  void add_stop(double residual) {
    double low = over_time_ ? 1e300 : 0, high = 0;
    for (const PlotLine& l : plot.lines)
      for (const double x : l.x) low = std::min(low, x), high = std::max(high, x);
    if (high > 0) plot.lines.push_back({{low, high}, {residual, residual}, PlotInk::dim, true});
  }

  Plot plot;

 private:
  double value(double bound) const { return std::clamp(bound, least_, ceiling_above); }

  void enter(PlotLine& line, const ResidualPoint& p, RadiositySolver kind) const {
    const double x = over_time_ ? std::max(p.seconds, start_) : p.sweeps;
    // LU knows nothing before its end: straight down.
    if (kind == RadiositySolver::lu && !line.x.empty()) line.x.push_back(x), line.y.push_back(line.y.back());
    line.x.push_back(x), line.y.push_back(value(p.error_bound));
  }

  // On the line between two points of the curve.
  static ResidualPoint point_at(const std::vector<ResidualPoint>& curve, std::size_t step) {
    for (std::size_t i = 1; i < curve.size(); ++i) {
      if (curve[i].step < step) continue;
      const ResidualPoint &a = curve[i - 1], &b = curve[i];
      const double t = b.step > a.step ? double(step - a.step) / double(b.step - a.step) : 1;
      ResidualPoint out = b;
      out.seconds = a.seconds + t * (b.seconds - a.seconds);
      if (a.error_bound > 0 && b.error_bound > 0)
        out.error_bound = a.error_bound * std::pow(b.error_bound / a.error_bound, t);
      return out;
    }
    return curve.empty() ? ResidualPoint{} : curve.back();
  }

  bool over_time_;
  double least_, start_;
};

// Half of the shortest time that there is.
double start_of(const SolverRace::Entries& entries) {
  double shortest = 1e300;
  for (const SolverRace::Entry& e : entries)
    for (const ResidualPoint& p : e.curve)
      if (p.seconds > 0) shortest = std::min(shortest, p.seconds);
  return shortest < 1e300 ? shortest / 2 : 1e-6;
}

}  // namespace

const Words& short_name(RadiositySolver solver) {
  static constexpr std::array<Words, solver_count> names{{{"Jacobi", "ヤコビ"},
                                                          {"Gauss–Seidel", "ガウス・ザイデル"},
                                                          {"Southwell", "サウスウェル"},
                                                          {"Progressive", "漸進法"},
                                                          {"LU", "LU"}}};
  return names[std::size_t(solver)];
}

std::optional<Text> lu_note(const SolverRace::Entries& entries) {
  const SolverRace::Entry& lu = entries[std::size_t(RadiositySolver::lu)];
  if (lu.curve.empty() || lu.end == SolverEnd::none) return std::nullopt;
  const std::string seconds = short_number(lu.curve.back().seconds, 2) + " s";
  return Text("LU takes no sweeps, but " + seconds + ".", "LU はスイープなし：" + seconds);
}

Plot residual_plot(const SolverRace::Entries& entries, RadiositySolver active, const SolverState* now, double residual,
                   bool over_time) {
  Builder out(residual, over_time, start_of(entries));
  const auto curve_of = [&](std::size_t k) -> const std::vector<ResidualPoint>& {
    // Of one that did not run beside the window: as far as it was stepped.
    const bool own = entries[k].curve.empty() && now && std::size_t(now->task->options.solver) == k;
    return own ? now->curve : entries[k].curve;
  };
  for (std::size_t k = 0; k < solver_count; ++k) out.add(RadiositySolver(k), curve_of(k), RadiositySolver(k) == active);
  out.add_stop(residual);
  if (now) out.add_place(*now, curve_of(std::size_t(now->task->options.solver)));
  out.plot.x = over_time ? PlotAxis{Words{"Time of the steps (s)", "ステップの計算時間 (s)"}, false, false}
                         : PlotAxis{Words{"Sweeps (n steps each)", "スイープ（n ステップずつ）"}, false, true};
  out.plot.y = {Words{"Error bound / brightest B", "誤差の上限 ÷ B の最大値"}};
  return std::move(out.plot);
}

}  // namespace cg
