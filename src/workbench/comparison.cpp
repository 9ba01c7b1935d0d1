#include "workbench/comparison.h"

#include <chrono>
#include <cstdio>

namespace cg {

namespace {

// `v` with that many digits behind the point, whatever the locale.
std::string fixed(double v, int digits) {
  std::string text(64, '\0');
  const double scale = std::pow(10.0, digits);
  const long long whole = std::llround(std::abs(v) * scale);
  const long long unit = std::llround(scale);
  std::string fraction = std::to_string(whole % unit);
  fraction.insert(0, std::size_t(digits) - std::min(fraction.size(), std::size_t(digits)), '0');
  return (v < 0 && whole ? "-" : "") + std::to_string(whole / unit) + (digits ? "." + fraction : "");
}

}  // namespace

TimedFrame draw_timed(const Technique& technique, const Scene& scene, const View& view, Progress& progress) {
  using Clock = std::chrono::steady_clock;
  Progress untold;
  const View small{std::min(view.width, 16), std::min(view.height, 16), view.threads};
  technique.render(scene, technique.plan(scene, small), small, untold);
  const Plan plan = technique.plan(scene, view);
  const auto start = Clock::now();
  TimedFrame out{technique.render(scene, plan, view, progress)};
  out.ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  return out;
}

Comparison compare(const Technique& left, const Technique& right, const Scene& scene, const View& view,
                   Progress& progress) {
  Comparison out{left.id, right.id, view.width, view.height, draw_timed(left, scene, view, progress), {}, {}};
  out.right_frame = draw_timed(right, scene, view, progress);
  out.difference = difference(out.left_frame.frame.colour, out.right_frame.frame.colour, out.left_frame.frame.covered,
                              out.right_frame.frame.covered, scene.display);
  return out;
}

Tree json_of(const Comparison& c) {
  return Tree::Members{{"left", c.left},
                       {"right", c.right},
                       {"width", c.width},
                       {"height", c.height},
                       {"coverage_mismatch", c.difference.coverage_mismatch},
                       {"covered", c.difference.covered},
                       {"max_error", c.difference.max_error},
                       {"rmse", c.difference.rmse},
                       {"over_1_255", c.difference.over_1_255},
                       {"psnr", c.difference.psnr},
                       {"left_ms", c.left_frame.ms},
                       {"right_ms", c.right_frame.ms}};
}

std::string text_of(const Comparison& c, Language language) {
  const Difference& d = c.difference;
  const auto say = [&](Words words) { return std::string(words.in(language)); };
  const auto row = [&](const std::string& name, const std::string& value) { return "  " + name + ": " + value + "\n"; };
  std::string out = c.left + say({" against ", " と "}) + c.right + say({"", " の比較"}) + ", " +
                    std::to_string(c.width) + "×" + std::to_string(c.height) + "\n";
  out += row(say({"largest error", "最大誤差"}),
             fixed(d.max_error * 255, 2) + "/255" +
                 (d.worst_x < 0 ? "" : " (x " + std::to_string(d.worst_x) + ", y " + std::to_string(d.worst_y) + ")"));
  out += row(say({"root mean square", "二乗平均平方根"}), fixed(d.rmse * 255, 4) + "/255");
  out += row("PSNR", std::isfinite(d.psnr) ? fixed(d.psnr, 1) + " dB" : "∞");
  out += row(say({"pixels over 1/255", "1/255 を超える画素"}),
             std::to_string(d.over_1_255) + " / " + std::to_string(d.covered));
  out += row(say({"covered by one alone", "片方だけが描いた画素"}), std::to_string(d.coverage_mismatch));
  out += row(c.left, fixed(c.left_frame.ms, 1) + " ms");
  out += row(c.right, fixed(c.right_frame.ms, 1) + " ms");
  return out;
}

}  // namespace cg
