#include "image/gif_animation.h"

#include <algorithm>
#include <cassert>
#include <optional>

#include "params/file.h"
#include "params/input_error.h"

namespace cg {

namespace {

// The blocks of the format: section 23 and Appendix A.
constexpr unsigned char extension = 0x21, descriptor = 0x2c, trailer = 0x3b;
constexpr unsigned char control_label = 0xf9, application_label = 0xff;
constexpr std::size_t head_size = 13, descriptor_size = 10;

std::size_t table_bytes(unsigned char packed) { return packed & 0x80 ? std::size_t(3) << ((packed & 7) + 1) : 0; }

unsigned char byte_at(std::string_view b, std::size_t at) {
  return at < b.size() ? static_cast<unsigned char>(b[at]) : 0;
}

// Behind the data sub-blocks that begin at `at`.
std::size_t behind_blocks(std::string_view b, std::size_t at) {
  while (at < b.size() && byte_at(b, at) != 0) at += 1 + byte_at(b, at);
  return at + 1;
}

// The one image in a GIF: its table of colours and its compressed indices.
struct Frame {
  unsigned char packed = 0;  // of its descriptor, with the table's size
  std::string_view table, data;
};

std::optional<Frame> frame_in(std::string_view gif, int width, int height) {
  if (!gif.starts_with("GIF8")) return {};
  const std::size_t global = table_bytes(byte_at(gif, 10));
  std::size_t at = head_size + global;
  while (byte_at(gif, at) == extension) at = behind_blocks(gif, at + 2);
  if (byte_at(gif, at) != descriptor) return {};
  const auto word = [&](std::size_t i) { return byte_at(gif, at + i) | byte_at(gif, at + i + 1) << 8; };
  if (word(1) != 0 || word(3) != 0 || word(5) != width || word(7) != height) return {};
  const unsigned char packed = byte_at(gif, at + 9);
  const std::size_t own = table_bytes(packed), data = at + descriptor_size + own;
  const std::size_t end = behind_blocks(gif, data + 1);
  if (end > gif.size() || (own == 0 && global == 0)) return {};
  Frame out;
  out.table = own ? gif.substr(at + descriptor_size, own) : gif.substr(head_size, global);
  out.packed = static_cast<unsigned char>((packed & 0x40) | 0x80 | ((own ? packed : byte_at(gif, 10)) & 7));
  out.data = gif.substr(data, end - data);
  return out;
}

void add_word(std::string& out, int word) {
  out += char(word & 255);
  out += char(word >> 8 & 255);
}

}  // namespace

GifAnimation::GifAnimation(std::filesystem::path file, int width, int height)
    : file_(std::move(file)), width_(width), height_(height) {
  if (width < 1 || height < 1 || std::max(width, height) > 65535)
    throw InputError(file_.string(), {"a GIF has 1 to 65535 pixels a side", "GIF の一辺は 1～65535 画素まで"},
                     {"record a smaller picture", "小さい画像を録画する"});
  bytes_ = "GIF89a";
  add_word(bytes_, width);
  add_word(bytes_, height);
  bytes_ += std::string("\x70\0\0", 3);  // 8 bits a primary, no table for all
  bytes_ += char(extension);
  bytes_ += char(application_label);
  bytes_ += "\x0bNETSCAPE2.0";
  bytes_ += std::string("\x03\x01\0\0\0", 5);  // for ever
}

void GifAnimation::add(const Picture& picture, int centiseconds, ImageProgram& program) {
  assert(picture.width() == width_ && picture.height() == height_);
  const std::string one = encode_image(file_, ImageFormat::gif, picture, program);
  const std::optional<Frame> frame = frame_in(one, width_, height_);
  if (!frame)
    throw InputError(file_.string(), {"a frame could not be encoded", "フレームを符号化できない"},
                     {"try it again", "もう一度試す"});
  bytes_ += char(extension);
  bytes_ += char(control_label);
  bytes_ += "\x04\x04";  // four bytes; leave it where it is
  last_delay_at_ = bytes_.size();
  last_delay_ = 0;
  add_word(bytes_, 0);
  bytes_ += std::string("\0\0", 2);  // no transparency; end
  bytes_ += char(descriptor);
  add_word(bytes_, 0);
  add_word(bytes_, 0);
  add_word(bytes_, width_);
  add_word(bytes_, height_);
  bytes_ += char(frame->packed);
  bytes_ += frame->table;
  bytes_ += frame->data;
  ++frames_;
  hold(std::max(centiseconds, 2));
}

void GifAnimation::hold(int centiseconds) {
  if (frames_ == 0) return;
  last_delay_ = std::clamp(last_delay_ + centiseconds, 0, 65535);
  bytes_[last_delay_at_] = char(last_delay_ & 255);
  bytes_[last_delay_at_ + 1] = char(last_delay_ >> 8 & 255);
}

std::string GifAnimation::bytes() const { return bytes_ + char(trailer); }

void GifAnimation::save() const { save_file(file_, bytes()); }

}  // namespace cg
