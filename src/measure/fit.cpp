// Fitting a power law: linear least squares of the logarithms, and the search for the part where they are straight. The
// residuals' test is that of James Durbin and Geoffrey Watson, Testing for Serial Correlation in Least Squares
// Regression, 1950.
#include "measure/fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cg {

namespace {

struct LogPoint {
  double x, y;  // decades
};

std::vector<LogPoint> log_points(std::span<const double> x, std::span<const double> error) {
  std::vector<LogPoint> out;
  for (std::size_t i = 0; i < std::min(x.size(), error.size()); ++i)
    if (x[i] > 0 && error[i] > 0 && std::isfinite(x[i]) && std::isfinite(error[i]))
      out.push_back({std::log10(x[i]), std::log10(error[i])});
  std::sort(out.begin(), out.end(), [](const LogPoint& a, const LogPoint& b) { return a.x < b.x; });
  return out;
}

struct Fitted {
  LineFit line;
  double residual = 0;   // root mean square, decades
  double curvature = 0;  // Fisher's F of a quadratic term: how much better a parabola meets the points
  double scatter = 2;    // Durbin and Watson's d of the residuals: about 2 where neighbours have nothing in common
};

// Of the residuals `off` of a line: what a parabola takes away, held against what it leaves.
double f_of_parabola(std::span<const LogPoint> points, const std::vector<double>& off, double mean_x, double xx) {
  const double n = double(points.size());
  double third = 0;
  for (const LogPoint& p : points) third += std::pow(p.x - mean_x, 3);
  double square = 0, with_off = 0, all = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double d = points[i].x - mean_x, parabola = d * d - xx / n - third / xx * d;  // orthogonal to lines
    square += parabola * parabola;
    with_off += parabola * off[i];
    all += off[i] * off[i];
  }
  const double taken = square > 0 ? with_off * with_off / square : 0, left = std::max(all - taken, 1e-30);
  return points.size() > 3 ? taken / (left / (n - 3)) : 0;
}

std::optional<Fitted> fit(std::span<const LogPoint> points) {
  const double n = double(points.size());
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, squares = 0;
  for (const LogPoint& p : points) mean_x += p.x / n, mean_y += p.y / n;
  for (const LogPoint& p : points) xx += (p.x - mean_x) * (p.x - mean_x), xy += (p.x - mean_x) * (p.y - mean_y);
  if (points.size() < 2 || !(xx > 0)) return std::nullopt;
  Fitted out;
  out.line.slope = xy / xx;
  out.line.intercept = mean_y - out.line.slope * mean_x;
  std::vector<double> off;
  for (const LogPoint& p : points) {
    off.push_back(p.y - out.line.intercept - out.line.slope * p.x);
    squares += off.back() * off.back();
  }
  out.curvature = f_of_parabola(points, off, mean_x, xx);
  double steps = 0;
  for (std::size_t i = 1; i < off.size(); ++i) steps += (off[i] - off[i - 1]) * (off[i] - off[i - 1]);
  if (squares > 0) out.scatter = steps / squares;
  if (points.size() > 2) out.line.standard_error = std::sqrt(squares / (n - 2) / xx);
  out.residual = std::sqrt(squares / n);
  out.line.x_low = std::pow(10, points.front().x);
  out.line.x_high = std::pow(10, points.back().x);
  out.line.points = points.size();
  return out;
}

// Met so closely that no bend would matter; or by few points; or loosely by enough points that show no bend.
bool is_straight(const Fitted& f, double tolerance) {
  constexpr double bent = 4;         // F of 4: one chance in ten, or less, for six points and more
  constexpr double wandering = 1.3;  // d below: neighbours lie on the same side (5 % for ten points)
  if (f.residual <= tolerance / 4) return true;
  if (f.line.points < 5) return f.residual <= tolerance;
  return f.residual <= 4 * tolerance && f.curvature < bent && f.scatter > wandering;
}

double off_the_line(const LineFit& line, const LogPoint& p) {
  return std::abs(p.y - line.intercept - line.slope * p.x);
}

}  // namespace

double LineFit::at(double x) const { return std::pow(10, intercept + slope * std::log10(x)); }

std::optional<LineFit> fit_line(std::span<const double> x, std::span<const double> error) {
  const auto fitted = fit(log_points(x, error));
  return fitted ? std::optional(fitted->line) : std::nullopt;
}

std::optional<LineFit> fit_straight_part(std::span<const double> x, std::span<const double> error, double tolerance) {
  const std::vector<LogPoint> all = log_points(x, error);
  std::optional<Fitted> best;
  std::size_t first = 0;
  for (std::size_t length = all.size(); length >= 3 && !best; --length)
    for (std::size_t begin = 0; begin + length <= all.size(); ++begin) {
      const auto fitted = fit(std::span(all).subspan(begin, length));
      if (fitted && is_straight(*fitted, tolerance) && (!best || fitted->residual < best->residual))
        best = fitted, first = begin;
    }
  if (!best) return fit_line(x, error);
  // A point belongs to a bend where it is clearly farther from the line than those that made it.
  LineFit line = best->line;
  const double clearly = std::max(2 * tolerance, 3 * best->residual);
  for (std::size_t i = first; i > 0 && !line.bend_low; --i)
    if (off_the_line(line, all[i - 1]) > clearly) line.bend_low = std::pow(10, all[i - 1].x);
  for (std::size_t i = first + line.points; i < all.size() && !line.bend_high; ++i)
    if (off_the_line(line, all[i]) > clearly) line.bend_high = std::pow(10, all[i].x);
  return line;
}

}  // namespace cg
