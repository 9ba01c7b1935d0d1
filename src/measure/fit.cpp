// Fitting a power law: linear least squares of the logarithms, and the search for the part where they are straight.
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
  double residual = 0;  // root mean square, decades
};

std::optional<Fitted> fit(std::span<const LogPoint> points) {
  const double n = double(points.size());
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, squares = 0;
  for (const LogPoint& p : points) mean_x += p.x / n, mean_y += p.y / n;
  for (const LogPoint& p : points) xx += (p.x - mean_x) * (p.x - mean_x), xy += (p.x - mean_x) * (p.y - mean_y);
  if (points.size() < 2 || !(xx > 0)) return std::nullopt;
  Fitted out;
  out.line.slope = xy / xx;
  out.line.intercept = mean_y - out.line.slope * mean_x;
  for (const LogPoint& p : points) {
    const double off = p.y - out.line.intercept - out.line.slope * p.x;
    squares += off * off;
  }
  if (points.size() > 2) out.line.standard_error = std::sqrt(squares / (n - 2) / xx);
  out.residual = std::sqrt(squares / n);
  out.line.x_low = std::pow(10, points.front().x);
  out.line.x_high = std::pow(10, points.back().x);
  out.line.points = points.size();
  return out;
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
      if (fitted && fitted->residual <= tolerance && (!best || fitted->residual < best->residual))
        best = fitted, first = begin;
    }
  if (!best) return fit_line(x, error);
  // A point belongs to a bend where it is clearly farther from the line than those that made it.
  LineFit line = best->line;
  const double clearly = 2 * tolerance;
  if (first > 0 && off_the_line(line, all[first - 1]) > clearly) line.bend_low = std::pow(10, all[first - 1].x);
  if (const std::size_t next = first + line.points; next < all.size() && off_the_line(line, all[next]) > clearly)
    line.bend_high = std::pow(10, all[next].x);
  return line;
}

}  // namespace cg
