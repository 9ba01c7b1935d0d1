// A power law through measured points: least squares of log(error) over log(x), in the part of the curve where it is
// straight.
#pragma once
#include <optional>
#include <span>

namespace cg {

// log10(error) = intercept + slope log10(x) for x_low <= x <= x_high.
struct LineFit {
  double slope = 0, intercept = 0;
  double standard_error = 0;  // of the slope; 0 where only two points carry the line
  double x_low = 0, x_high = 0;
  std::size_t points = 0;  // on the line
  // Whether there are points beyond an end that leave the line, and the x of the first that does.
  std::optional<double> bend_low, bend_high;
  double at(double x) const;  // the line's error
};

// By all points. x and error > 0; at least two different x, or nothing.
std::optional<LineFit> fit_line(std::span<const double> x, std::span<const double> error);

// By the longest run of neighbouring points, at least three, that is straight; of runs of one length the straightest.
// Straight: a line meets three or four points to within `tolerance` (root mean square, decades), more of them to within
// four times that if a parabola is not significantly better and they scatter about it; or all to within a quarter of
// it. Where there is no such run: by all points. Points whose error is not above 0 are left out. The prediction has no
// say in it.
std::optional<LineFit> fit_straight_part(std::span<const double> x, std::span<const double> error,
                                         double tolerance = 0.04);

}  // namespace cg
