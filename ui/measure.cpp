#include "ui/measure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "ui/app.h"
#include "ui/panes.h"

namespace cg {

namespace {

double ms_between(WindowMeasurement::Clock::time_point a, WindowMeasurement::Clock::time_point b) {
  return std::chrono::duration<double, std::milli>(b - a).count();
}

// CPU time of this thread: what it worked itself, whatever else the machine did meanwhile.
double thread_cpu_ms() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

void print_figures(const char* what, std::vector<double> ms) {
  if (ms.empty()) {
    std::printf("%-34s none\n", what);
    return;
  }
  std::sort(ms.begin(), ms.end());
  const auto at = [&](double part) { return ms[std::min(ms.size() - 1, std::size_t(part * double(ms.size())))]; };
  std::printf("%-34s median %6.1f  95 %% %6.1f  worst %6.1f ms  (%zu)\n", what, at(0.5), at(0.95), ms.back(),
              ms.size());
}

}  // namespace

void WindowMeasurement::change(App& app) {
  if (seconds_ <= 0 || state_ == State::over) return;
  frame_start_ = Clock::now();
  cpu_start_ = thread_cpu_ms();
  if (state_ == State::waiting) {
    const bool there = app.panes && app.panes->jobs().pictures_match() && !app.panes->jobs().busy();
    if (!there) return;
    state_ = State::dragging;
    start_ = frame_start_;
  }
  const double t = ms_between(start_, frame_start_) / 1000;
  if (t > seconds_) {
    state_ = State::over;
    return;
  }
  app.scene.material.k_d = glm::dvec3(0.5 + 0.4 * std::sin(4 * t));
}

void WindowMeasurement::drawn(App& app) {
  if (seconds_ <= 0 || state_ != State::dragging) return;
  drawn_at_ = Clock::now();
  frame_.push_back(ms_between(frame_start_, drawn_at_));
  frame_cpu_.push_back(thread_cpu_ms() - cpu_start_);
  panes_.push_back(app.panes->exchange_ms());
  for (int side = 0; side < 2; ++side) {
    const std::uint64_t serial = app.panes->jobs().submitted(side);
    if (serial == last_serial_[side]) continue;
    last_serial_[side] = serial;
    pending_[side].push_back({frame_start_, serial});
  }
  app.animating = true;
}

void WindowMeasurement::shown(App& app) {
  if (seconds_ <= 0 || state_ != State::dragging) return;
  const Clock::time_point now = Clock::now();
  swap_.push_back(ms_between(drawn_at_, now));
  for (int side = 0; side < 2; ++side) {
    const DrawingHandle& drawing = app.panes->on_screen(side);
    if (!drawing) continue;
    if (drawing->serial != on_screen_[side]) ++pictures_[side], on_screen_[side] = drawing->serial;
    while (!pending_[side].empty() && pending_[side].front().serial <= drawing->serial) {
      lag_[side].push_back(ms_between(pending_[side].front().when, now));
      pending_[side].pop_front();
    }
  }
}

void WindowMeasurement::print(const App& app) const {
  if (seconds_ <= 0 || !app.panes) return;
  for (int side = 0; side < 2; ++side) {
    const DrawingHandle& drawing = app.panes->on_screen(side);
    const PaneState& pane = app.panes->jobs().pane(side);
    if (drawing && pane.technique >= 0)
      std::printf("%-9s %-10s %d x %d, %.1f ms a picture, %.1f pictures a second\n",
                  side ? "right:" : "left:", app.techniques[std::size_t(pane.technique)].id.c_str(),
                  drawing->view.width, drawing->view.height, pane.ms, double(pictures_[side]) / seconds_);
  }
  print_figures("waiting for techniques, a frame", panes_);
  print_figures("window's thread, a frame", frame_);
  print_figures("the same, its own CPU time", frame_cpu_);
  print_figures("swap of the frame", swap_);
  print_figures("slider to left picture on screen", lag_[0]);
  print_figures("slider to right picture on screen", lag_[1]);
}

}  // namespace cg
