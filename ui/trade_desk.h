// Trades measured beside the window: one knob at a time on a thread of its own, then the pictures of its settings. The
// window never waits; what is measured stays until it is measured again.
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "measure/plot.h"
#include "ui/plot_view.h"
#include "ui/texture.h"
#include "workbench/worker.h"

namespace cg {

struct App;

// A trade and what the panel needs of it.
struct MeasuredTrade {
  Trade trade;
  std::vector<std::string> paths;  // the scene's parameters that the settings differ in
  std::shared_ptr<const Plot> speed, convergence;
};

// A setting as it is drawn, and its difference to the reference, times `gain`.
struct SettingPicture {
  Picture shown, difference;
  double gain = 1;
};

class TradeDesk {
 public:
  // `wake` is called on another thread when there is something new.
  explicit TradeDesk(std::function<void()> wake);
  // Stops what runs and waits for it.
  ~TradeDesk();

  // Measures the scene as it stands; what runs is stopped.
  void measure(const App& app, const Knob& knob);
  // What runs is of no use any more: it ends soon.
  void stop();

  // The knob that is being measured; null: none.
  const Knob* running() const;
  float fraction() const { return worker_.fraction(); }
  // The newest of that knob; null before the first.
  std::shared_ptr<const MeasuredTrade> of(const Knob& knob) const;
  // Why the newest measurement of that knob came to nothing, if so.
  std::optional<Text> problem(const Knob& knob) const;

  // The pictures of a point of the knob's newest trade, drawn soon where they are not there yet (null then).
  std::shared_ptr<const SettingPicture> picture(const App& app, const Knob& knob, std::size_t point);

  // The same as textures; needs the window's OpenGL context, and shows one setting at a time. Empty before `update`.
  const Texture& shown() const { return shown_; }
  const Texture& difference() const { return difference_; }
  bool shows(const std::shared_ptr<const SettingPicture>& picture) const { return picture && picture == uploaded_; }
  // Once a frame, with the window's OpenGL context: what picture() gave last becomes the textures.
  void update(App& app);

  std::map<std::string, std::size_t> chosen;  // by knob: the point that was clicked
  bool against_time = true;                   // which of the two plots is seen
  bool large = false;                         // in place of the panes
  int pointed = -1;                           // the point under the mouse in the large plot
  PlotView speed_view, convergence_view;      // as they are laid out

 private:
  struct Entry {
    std::shared_ptr<const MeasuredTrade> measured;
    std::optional<Text> problem;
    std::map<std::size_t, std::shared_ptr<const SettingPicture>> pictures;
    std::map<std::size_t, std::shared_ptr<const Frame>> references;
  };
  std::vector<Technique> own_techniques(const App& app, std::shared_ptr<Progress> link) const;
  void draw_pictures(const std::string& id, const std::shared_ptr<const MeasuredTrade>& measured,
                     const std::vector<Technique>& techniques, Progress& progress);
  std::shared_ptr<const SettingPicture> draw_picture(const std::string& id, const Trade& trade, std::size_t point,
                                                     const std::vector<Technique>& techniques, Progress& progress);
  std::optional<std::size_t> next_picture(const std::string& id, std::size_t count) const;

  std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards what follows
  std::map<std::string, Entry> entries_;
  const Knob* running_ = nullptr;
  std::optional<std::size_t> wanted_;  // the point that the mouse is on
  std::string drawing_;                // the knob whose pictures are being drawn
  // Of the window's thread alone.
  std::shared_ptr<Progress> link_;  // stops the drawing that goes on, whatever its own progress says
  std::shared_ptr<const SettingPicture> asked_, uploaded_;
  Texture shown_, difference_;
  Worker worker_;  // last: it uses what stands above
};

// The window's own, made at the first call. It must go while the window's OpenGL context is there.
TradeDesk& trades_of(App& app);

// Another scene comes in place of the one in hand.
void stop_measuring(App& app);

// The scene takes the point's setting, as one step of undo, and a pane its technique.
void take_setting(App& app, const MeasuredTrade& measured, std::size_t point);

}  // namespace cg
