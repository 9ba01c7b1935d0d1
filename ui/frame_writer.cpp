#include "ui/frame_writer.h"

#include <algorithm>
#include <cmath>

#include "image/gif_animation.h"
#include "params/file.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_queue = 30;
constexpr std::size_t largest_gif = std::size_t(512) << 20;
constexpr int gap = 8;  // pixels between two pictures

// Copies `from` into a part of `to`, as large as the part, by the nearest pixel.
void place(Picture& to, const Picture& from, int x0, int width, int height) {
  if (from.width() < 1 || from.height() < 1) return;
  for (int y = 0; y < height; ++y) {
    const glm::u8vec4* row = from.row(int(std::int64_t(y) * from.height() / height));
    glm::u8vec4* out = to.row(y) + x0;
    if (from.width() == width)
      std::copy_n(row, width, out);
    else
      for (int x = 0; x < width; ++x) out[x] = row[std::int64_t(x) * from.width() / width];
  }
}

std::string frame_name(int number) {
  const std::string digits = std::to_string(number);
  return "frame-" + std::string(5 - std::min<std::size_t>(digits.size(), 5), '0') + digits + ".png";
}

void require_free(RecordedAs as, const fs::path& path) {
  std::error_code error;
  if (as == RecordedAs::gif) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error))
      throw InputError(path.string(), {"there is no such folder", "そのようなフォルダはない"},
                       {"name a folder that exists", "あるフォルダを指定する"});
    return;
  }
  if (fs::exists(path, error) && !(fs::is_directory(path, error) && fs::is_empty(path, error)))
    throw InputError(path.string(), {"there is something here already", "すでに何かがある"},
                     {"name a new folder", "新しいフォルダの名前を書く"});
  if (!fs::create_directories(path, error) && error)
    throw InputError(path.string(), {"the folder cannot be made", "フォルダを作れない"}, system_text(error.value()));
}

}  // namespace

FrameWriter::FrameWriter(RecordedAs as, fs::path path, double per_second, std::function<void()> wake)
    : as_(as), path_(std::move(path)), per_second_(per_second), wake_(std::move(wake)) {
  require_free(as_, path_);
  thread_ = std::thread([this] { run(); });
}

FrameWriter::~FrameWriter() {
  {
    const std::lock_guard lock(mutex_);
    abandoned_ = true;
  }
  wake_thread_.notify_all();
  thread_.join();
}

bool FrameWriter::put(RecordedFrame frame) {
  {
    const std::lock_guard lock(mutex_);
    if (finishing_ || ended_ || queue_.size() >= longest_queue) return false;
    queue_.push_back(std::move(frame));
  }
  wake_thread_.notify_all();
  return true;
}

void FrameWriter::finish() {
  {
    const std::lock_guard lock(mutex_);
    finishing_ = true;
  }
  wake_thread_.notify_all();
}

bool FrameWriter::ended() const {
  const std::lock_guard lock(mutex_);
  return ended_;
}

Text FrameWriter::report() const {
  const std::string n = std::to_string(written_), where = path_.string();
  return {"Recorded " + n + (written_ == 1 ? " frame: " : " frames: ") + where,
          n + " フレームを録画しました: " + where};
}

void FrameWriter::run() {
  std::optional<InputError> error;
  try {
    for (;;) {
      RecordedFrame frame;
      {
        std::unique_lock lock(mutex_);
        wake_thread_.wait(lock, [&] { return abandoned_ || finishing_ || !queue_.empty(); });
        if (abandoned_ || queue_.empty()) break;
        frame = std::move(queue_.front());
        queue_.pop_front();
      }
      write(frame);
    }
  } catch (const InputError& e) {
    error = e;
  } catch (const std::bad_alloc&) {
    error = InputError(path_.string(), {"not enough memory", "メモリが足りない"});
  }
  bool whole = false;
  {
    const std::lock_guard lock(mutex_);
    whole = finishing_ && !abandoned_ && !error;
  }
  try {
    if (whole) close();
  } catch (const InputError& e) {
    error = e;
  }
  std::error_code none;
  if (as_ == RecordedAs::png && written_ == 0) fs::remove(path_, none);  // only if it is empty
  {
    const std::lock_guard lock(mutex_);
    error_ = error;
    ended_ = true;
  }
  wake_();
}

void FrameWriter::write(const RecordedFrame& frame) {
  const bool repeated = written_ > 0 && frame.left == last_.left && frame.right == last_.right;
  if (width_ == 0) {
    width_ = frame.left->width() + (frame.right ? gap + frame.right->width() : 0);
    height_ = frame.left->height();
  }
  const bool two = frame.right != nullptr;
  if (repeated || (!two && frame.left->width() == width_ && frame.left->height() == height_)) {
    as_ == RecordedAs::gif ? write_gif(*frame.left, repeated, frame.ticks)
                           : write_png(*frame.left, repeated, frame.ticks);
  } else {
    Picture whole(width_, height_);
    for (int y = 0; y < height_; ++y) std::fill_n(whole.row(y), width_, glm::u8vec4(0, 0, 0, 255));
    const int half = two ? (width_ - gap) / 2 : width_;
    place(whole, *frame.left, 0, half, height_);
    if (two) place(whole, *frame.right, width_ - half, half, height_);
    as_ == RecordedAs::gif ? write_gif(whole, false, frame.ticks) : write_png(whole, false, frame.ticks);
  }
  last_ = frame;
}

void FrameWriter::write_gif(const Picture& picture, bool repeated, int ticks) {
  if (!gif_) gif_ = std::make_unique<GifAnimation>(path_, width_, height_);
  // The time up to this frame belongs to the one before; what rounds off goes to the next.
  const auto hundredths = [&](long t) { return long(std::lround(100.0 * double(t) / per_second_)); };
  const long before = ticks_;
  ticks_ += ticks;
  if (repeated) return gif_->hold(int(hundredths(ticks_) - hundredths(before)));
  if (ticks > 1) gif_->hold(int(hundredths(ticks_ - 1) - hundredths(before)));
  gif_->add(picture, int(hundredths(ticks_) - hundredths(ticks_ - 1)), program_);
  ++written_;
  if (gif_->size() > largest_gif) {
    const std::lock_guard lock(mutex_);
    finishing_ = true;
    queue_.clear();
  }
}

void FrameWriter::write_png(const Picture& picture, bool repeated, int ticks) {
  // Ticks without a frame show the one before.
  for (int i = 1; i < ticks && written_ > 0; ++i) save_file(path_ / frame_name(++written_), png_);
  if (!repeated) png_ = encode_image(path_ / frame_name(written_ + 1), ImageFormat::png, picture, program_);
  save_file(path_ / frame_name(written_ + 1), png_);
  ++written_;
}

void FrameWriter::close() {
  if (gif_) gif_->save();
}

}  // namespace cg
