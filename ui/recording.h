// Records what is on the screen: the pictures or the whole window, as an animated GIF or as numbered PNG files. Frames
// go through a queue to a thread that encodes and writes them, so the window never waits for a disk.
#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include "ui/app.h"

namespace cg {

class FrameWriter;

class Recorder {
 public:
  // `wake` is called on another thread when a recording has ended.
  explicit Recorder(std::function<void()> wake);
  ~Recorder();

  // Begins. A GIF appears at `path` when it is whole; a sequence goes into the folder `path`, which must be new or
  // empty. Throws InputError.
  void start(const App& app, Recorded what, RecordedAs as, const std::filesystem::path& path);
  // Ends; what is in the queue is still written, and the user is told when all is there.
  void stop();

  bool recording() const { return recording_; }
  double seconds(const App& app) const { return app.now - began_; }
  int frames() const { return frames_; }

  // Once a frame, after its pictures were taken: puts the pictures into the queue when a frame is due, and tells what
  // the writers have to say.
  void update(App& app);
  // The window's pixels are saved to `file` once, .png or .jpg.
  void save_window(const std::filesystem::path& file);
  // Whether the window's pixels are wanted in this frame; then give them.
  bool wants_window(const App& app) const;
  void take_window(App& app, Picture picture);

 private:
  bool due(const App& app) const;
  void put(App& app, std::shared_ptr<const Picture> left, std::shared_ptr<const Picture> right);
  void tell(App& app);

  std::function<void()> wake_;
  bool recording_ = false;
  Recorded what_ = Recorded::both;
  double began_ = 0, next_ = 0;
  long ticks_ = 0;  // of the clock that the frames follow, up to the last frame
  int frames_ = 0;
  std::filesystem::path still_;
  std::vector<std::unique_ptr<FrameWriter>> writers_;  // the last one is in use while recording_
};

// The window's own recorder, made at the first call.
Recorder& recorder_of(App& app);

// Begins a recording as the settings say, at `path`, or tells why not.
void start_recording(App& app, const std::filesystem::path& path);
// The same with a name of its own in the current folder; or ends the one that goes on.
void toggle_recording(App& app);

// A red dot with the time while it records, `at` the middle of its upper edge; a click ends it.
void draw_recording_sign(App& app, ImVec2 at);

}  // namespace cg
