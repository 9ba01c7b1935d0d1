// An animated GIF from its frames: each is encoded by shadebench-images as a GIF of its own, and these are joined in
// one container (CompuServe, Graphics Interchange Format, version 89a, 1990) that plays for ever.
#pragma once
#include <string>

#include "image/image_file.h"

namespace cg {

class GifAnimation {
 public:
  // All frames have this size; a side is at most 65535. Throws InputError that names `file` where it is larger.
  GifAnimation(std::filesystem::path file, int width, int height);

  // Adds a picture that is shown for `centiseconds` (at least 2: what is shorter most programs play slowly). Throws
  // InputError.
  void add(const Picture& picture, int centiseconds, ImageProgram& program = ImageProgram::shared());
  // The last picture stays longer by so much.
  void hold(int centiseconds);

  int frames() const { return frames_; }
  std::size_t size() const { return bytes_.size(); }
  // The whole file.
  std::string bytes() const;
  // Saves it, whole or not at all. Throws InputError.
  void save() const;

 private:
  std::filesystem::path file_;
  int width_, height_;
  int frames_ = 0;
  int last_delay_ = 0;
  std::size_t last_delay_at_ = 0;  // in bytes_
  std::string bytes_;
};

}  // namespace cg
