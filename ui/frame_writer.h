// Writes the frames of a recording on a thread of its own, from a queue that does not grow beyond its limit.
#pragma once
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "image/display.h"
#include "image/image_program.h"
#include "params/input_error.h"
#include "ui/settings.h"

namespace cg {

class GifAnimation;

// One frame: a picture, or two beside each other (right may be null).
struct RecordedFrame {
  std::shared_ptr<const Picture> left, right;
  int ticks = 1;  // of the recording's clock since the frame before
};

class FrameWriter {
 public:
  // A GIF is saved to `path` at the end, whole or not at all. PNGs frame-00001.png, ... go into the folder `path`, one
  // a tick, so that they play at `per_second`. Throws InputError where `path` cannot be used. `wake` is called when it
  // has ended.
  FrameWriter(RecordedAs as, std::filesystem::path path, double per_second, std::function<void()> wake);
  // Ends without waiting for what is still in the queue; a GIF that is not saved yet does not appear.
  ~FrameWriter();

  // False where the queue is full: the frame is left out, and the one before it stays longer.
  bool put(RecordedFrame frame);
  // No more frames come.
  void finish();

  // All is written, or an error ended it. The following are valid then.
  bool ended() const;
  const std::optional<InputError>& error() const { return error_; }
  Text report() const;

 private:
  void run();
  void write(const RecordedFrame& frame);
  void write_gif(const Picture& picture, bool repeated, int ticks);
  void write_png(const Picture& picture, bool repeated, int ticks);
  void close();

  const RecordedAs as_;
  const std::filesystem::path path_;
  const double per_second_;
  const std::function<void()> wake_;
  // The writer's thread alone:
  ImageProgram program_;  // its own, so that other images need not wait
  std::unique_ptr<GifAnimation> gif_;
  RecordedFrame last_;
  int width_ = 0, height_ = 0;  // of all frames: as the first one
  std::string png_;             // of the last frame
  int written_ = 0;
  long ticks_ = 0;

  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable wake_thread_;
  std::deque<RecordedFrame> queue_;
  bool finishing_ = false, abandoned_ = false, ended_ = false;
  std::optional<InputError> error_;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace cg
