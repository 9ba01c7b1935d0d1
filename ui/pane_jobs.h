// The work behind the two pictures: one job for each technique that is looked at, and one thread that compares
// what they drew. No widgets and no OpenGL, so the same code runs in the window and in a measurement.
#pragma once
#include <array>
#include <deque>
#include <memory>
#include <vector>

#include "ui/settings.h"
#include "workbench/job.h"
#include "workbench/overlay.h"

namespace cg {

// One of the two pictures.
struct PaneState {
  int technique = -1;
  DrawingHandle drawing;  // the newest of this technique; null before the first
  std::optional<Text> message;
  bool busy = false;
  float fraction = 1;
  double ms = 0;  // median of the last full pictures; 0 before the first
};

// How two drawings of one scene differ.
struct Compared {
  DrawingHandle left, right;
  Difference difference;
  Picture picture;  // as `view` shows it; empty where no picture of it was asked for
  ViewMode view = ViewMode::two;
  double gain = 1;
};

class PaneJobs {
 public:
  // `wake` is called on other threads when there is something new. Techniques are copied.
  PaneJobs(std::vector<Technique> techniques, std::function<void()> wake);

  // Gives `wanted` to the jobs of both techniques if it is not what they have already, and takes what is there.
  // Never blocks. `left` and `right` are indices into the techniques. `together`: neither gets a new scene before
  // both have drawn the last one (or 0.15 s are over), so that their drawings can be compared while a slider moves.
  void update(const Request& wanted, int left, int right, bool together);
  // Keeps the comparison of the two drawings up to date, as `view` needs it.
  void compare(ViewMode view, double gain);
  // Keeps the lines over the objects of `drawn` up to date; null while there are none yet.
  void outline(const Scene& drawn, const OverlayChoice& choice);

  const PaneState& pane(int side) const { return panes_[std::size_t(side)]; }
  const std::shared_ptr<const Compared>& compared() const { return compared_; }
  const std::shared_ptr<const MeshOverlay>& overlay() const { return overlay_; }
  // Whether both pictures are full and of the same scene.
  bool pictures_match() const;
  bool busy() const;
  // Serial of the newest request of a side's job, to be compared with its drawing's.
  std::uint64_t submitted(int side) const;

 private:
  struct Runner {
    std::unique_ptr<Job> job;
    Request request;  // the newest that was submitted
    std::uint64_t serial = 0;
    std::uint64_t timed = 0;  // serial of the newest drawing in `times`
    std::deque<double> times;
  };
  // What a worker finished, until the window takes it.
  template <class T>
  struct Mailbox {
    std::mutex mutex;
    std::shared_ptr<const T> newest;
    void put(std::shared_ptr<const T> value) {
      const std::lock_guard lock(mutex);
      newest.swap(value);
    }
    std::shared_ptr<const T> take() {
      const std::lock_guard lock(mutex);
      return newest;
    }
  };

  Runner& runner(int technique);
  bool still_drawing(int left, int right);
  static void time(Runner& runner, const DrawingHandle& drawing, PaneState& pane);

  using Clock = std::chrono::steady_clock;
  std::vector<Technique> techniques_;
  std::function<void()> wake_;
  std::array<PaneState, 2> panes_;
  Clock::time_point submitted_at_;
  std::shared_ptr<const Compared> compared_;
  std::shared_ptr<const MeshOverlay> overlay_;

  // What the helpers were last asked for.
  struct Comparison {
    DrawingHandle left, right;
    ViewMode view = ViewMode::two;
    double gain = 0;
    friend bool operator==(const Comparison&, const Comparison&) = default;
  } comparison_;
  struct Outline {
    std::vector<Object> objects;
    Shading shading;
    OverlayChoice choice;
    friend bool operator==(const Outline&, const Outline&) = default;
  } outline_;

  Mailbox<Compared> compared_mail_;
  Mailbox<MeshOverlay> overlay_mail_;
  std::vector<std::unique_ptr<Runner>> runners_;  // by technique; null until it is looked at
  Worker comparer_, outliner_;                    // last: they use the mailboxes
};

}  // namespace cg
