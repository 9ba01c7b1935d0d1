// A scripted drag of a slider that measures what the window promises: that its own thread is never held up by a
// technique, and how far the pictures are behind the slider.
#pragma once
#include <chrono>
#include <deque>
#include <vector>

namespace cg {

struct App;

class WindowMeasurement {
 public:
  using Clock = std::chrono::steady_clock;

  // `seconds` of dragging; 0: no measurement, and all functions do nothing.
  explicit WindowMeasurement(double seconds) : seconds_(seconds) {}

  // Before a frame's widgets: changes k_d as its slider would, once both pictures are there.
  void change(App& app);
  // After the frame's drawing commands, before they are swapped onto the screen.
  void drawn(App& app);
  // After the swap: the pictures that the frame showed are on the screen.
  void shown(App& app);
  bool finished() const { return seconds_ > 0 && state_ == State::over; }
  // One line a figure, on stdout.
  void print(const App& app) const;

 private:
  enum class State { waiting, dragging, over };
  struct Change {
    Clock::time_point when;
    std::uint64_t serial;
  };

  double seconds_;
  State state_ = State::waiting;
  Clock::time_point start_, frame_start_, drawn_at_;
  double cpu_start_ = 0;
  std::deque<Change> pending_[2];  // of each side: changes whose picture is not on the screen yet
  std::uint64_t last_serial_[2] = {0, 0};
  std::vector<double> lag_[2], frame_, frame_cpu_, swap_, panes_;
  int pictures_[2] = {0, 0};
  std::uint64_t on_screen_[2] = {0, 0};
};

}  // namespace cg
