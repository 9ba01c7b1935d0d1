#include "image/image_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>

#include "image/blocks.h"
#include "params/file.h"
#include "params/input_error.h"

namespace cg {

using namespace image_protocol;

namespace {

namespace fs = std::filesystem;

ImageFormat checked_format(const fs::path& file, std::string_view bytes) {
  const FormatFound found = format_of_content(bytes);
  if (!found.format) throw InputError(file.string(), found.refused, found.accepted);
  return *found.format;
}

// The answer is not trusted: a file may have taken the program over.
PictureHeader receive_picture(ImageConversation& conversation) {
  PictureHeader picture{};
  const Header header = conversation.receive();
  if (header.kind != Kind::picture || header.size != sizeof picture) conversation.misunderstood();
  conversation.receive_body(&picture, sizeof picture);
  if (!size_allowed(picture.width, picture.height) || (picture.channels != 3 && picture.channels != 4))
    conversation.misunderstood();
  return picture;
}

ImageInfo info_of(const PictureHeader& p) { return {p.width, p.height, p.file_channels, p.bits, p.floating != 0}; }

void receive_rows(ImageConversation& conversation, const PictureHeader& picture, FileImage& image) {
  const std::size_t channels = std::size_t(picture.channels), width = std::size_t(picture.width);
  const std::size_t row_bytes = width * channels * sizeof(float);
  const std::size_t most = row_bytes * std::size_t(rows_at_once(row_bytes));
  std::vector<float> rows(image.alpha.empty() ? 0 : most / sizeof(float));
  for (int y = 0; y < picture.height;) {
    const Header header = conversation.receive();
    const std::size_t n = header.size / row_bytes;
    if (header.kind != Kind::rows || header.value != std::uint32_t(y) || n == 0 || n * row_bytes != header.size ||
        header.size > most || n > std::size_t(picture.height - y))
      conversation.misunderstood();
    glm::vec3* colour = image.colour.row(y);
    conversation.receive_body(rows.empty() ? &colour->x : rows.data(), n * row_bytes);
    for (std::size_t i = 0; i < rows.size() / 4 && i < n * width; ++i) {
      const float* p = rows.data() + i * 4;
      colour[i] = {p[0], p[1], p[2]};
      image.alpha.row(y)[i] = p[3];
    }
    y += int(n);
  }
}

// The end of the answer; returns how many pixels were bad.
std::size_t receive_tail(ImageConversation& conversation) {
  const Header header = conversation.receive();
  DoneTail tail{};
  if (header.kind != Kind::done || header.size != sizeof tail) conversation.misunderstood();
  conversation.receive_body(&tail, sizeof tail);
  conversation.finish();
  return std::size_t(tail.bad_pixels);
}

// The bytes of the file: rows(y, n) gives n rows from y on, in the order's sample type.
template <class Rows>
std::string encode(const fs::path& file, const EncodeOrder& order, std::size_t row_bytes, ImageProgram& program,
                   Rows rows) {
  if (!size_allowed(order.width, order.height))
    throw InputError(
        file.string(),
        {"not saved: a picture of this size is not written", "保存できません：この大きさの画像は書けません"},
        {"1 to 256 megapixels, at most 1048576 a side", "1～256 メガピクセル、一辺 1048576 まで"});
  constexpr int jpeg_side = 65500;  // libjpeg's JPEG_MAX_DIMENSION
  if (order.format == ImageFormat::jpeg && std::max(order.width, order.height) > jpeg_side)
    throw InputError(
        file.string(),
        {"not saved: a JPEG has at most 65500 pixels a side", "保存できません：JPEG は一辺 65500 画素までです"},
        {"use .png", ".png を使ってください"});
  ImageConversation conversation(program, file.string(), std::int64_t(order.width) * order.height);
  conversation.send(Kind::encode, 0, &order, sizeof order);
  const int at_once = rows_at_once(row_bytes);
  for (int y = 0; y < order.height; y += at_once) {
    const int n = std::min(at_once, order.height - y);
    conversation.send(Kind::rows, std::uint32_t(y), rows(y, n), row_bytes * std::size_t(n));
  }
  conversation.send(Kind::end, 0, nullptr, 0);
  const Header header = conversation.receive();
  if (header.kind != Kind::encoded || header.size == 0 || header.size > max_encoded) conversation.misunderstood();
  std::string bytes(std::size_t(header.size), '\0');
  conversation.receive_body(bytes.data(), bytes.size());
  conversation.finish();
  return bytes;
}

// Turns what the standard library throws when memory ends into the user's message.
template <class F>
auto with_memory(const fs::path& file, F f) {
  try {
    return f();
  } catch (const std::bad_alloc&) {
    throw InputError(file.string(), {"not enough memory for this picture", "この画像にはメモリが足りません"});
  }
}

}  // namespace

FileImage read_image(const fs::path& file, ImageProgram& program) {
  return with_memory(file, [&] {
    const std::string bytes = read_file(file, max_file);
    const ImageFormat format = checked_format(file, bytes);
    ImageConversation conversation(program, file.string());
    conversation.send(Kind::decode, std::uint32_t(format), bytes.data(), bytes.size());
    const PictureHeader picture = receive_picture(conversation);
    FileImage image;
    image.info = info_of(picture);
    image.colour = ColourImage(picture.width, picture.height);
    if (picture.channels == 4) image.alpha = Image<float>(picture.width, picture.height);
    receive_rows(conversation, picture, image);
    image.bad_pixels = receive_tail(conversation);
    return image;
  });
}

ImageInfo inspect_image(const fs::path& file, ImageProgram& program) {
  return with_memory(file, [&] {
    const std::string bytes = read_file(file, max_file);
    const ImageFormat format = checked_format(file, bytes);
    ImageConversation conversation(program, file.string());
    conversation.send(Kind::inspect, std::uint32_t(format), bytes.data(), bytes.size());
    const PictureHeader picture = receive_picture(conversation);
    receive_tail(conversation);
    return info_of(picture);
  });
}

void write_image(const fs::path& file, const ColourImage& linear, const Display& display, Depth depth,
                 ImageProgram& program) {
  const ImageFormat format = format_to_write(file);
  if (format == ImageFormat::jpeg || (format == ImageFormat::png && depth == Depth::standard))
    return write_image(file, with_memory(file, [&] { return picture(display, linear); }), program);
  const bool shown = format == ImageFormat::png;
  const Sample sample = shown                                                    ? Sample::u16
                        : format == ImageFormat::exr && depth == Depth::standard ? Sample::half
                                                                                 : Sample::real;
  // Half ends at 65504; beyond it would be an infinity in the file.
  const float largest = sample == Sample::half ? 65504.0f : std::numeric_limits<float>::max();
  const std::size_t row = 3 * std::size_t(linear.width());
  std::vector<float> rows;
  with_memory(file, [&] {
    const EncodeOrder order{linear.width(), linear.height(), 3, format, sample};
    const std::string bytes = encode(file, order, row * sizeof(float), program, [&](int y, int n) {
      rows.resize(row * std::size_t(n));
      const float* from = channels(linear) + row * std::size_t(y);
      if (shown)
        display_channels(display, from, rows.data(), rows.size());
      else
        map_values(from, rows.data(), rows.size(),
                   [largest](float x) { return std::isnan(x) ? 0.0f : std::clamp(x, -largest, largest); });
      return rows.data();
    });
    save_file(file, bytes);
  });
}

namespace {

// `channels`: 3 or 4.
std::string encode_picture(const fs::path& file, ImageFormat format, const Picture& picture, int channels,
                           ImageProgram& program) {
  const std::size_t row = std::size_t(channels) * std::size_t(picture.width());
  std::vector<std::uint8_t> rows;
  return with_memory(file, [&] {
    const EncodeOrder order{picture.width(), picture.height(), channels, format, Sample::u8};
    return encode(file, order, row, program, [&](int y, int n) {
      rows.resize(row * std::size_t(n));
      std::uint8_t* to = rows.data();
      const glm::u8vec4* from = picture.row(y);
      for (std::size_t i = 0; i < std::size_t(picture.width()) * std::size_t(n); ++i, to += channels)
        std::memcpy(to, &from[i], std::size_t(channels));
      return rows.data();
    });
  });
}

}  // namespace

void write_image(const fs::path& file, const Picture& picture, ImageProgram& program) {
  const std::string bytes = encode_image(file, format_to_write(file), picture, program);
  with_memory(file, [&] { save_file(file, bytes); });
}

void write_image_with_alpha(const fs::path& file, const Picture& picture, ImageProgram& program) {
  if (format_to_write(file) != ImageFormat::png)
    throw InputError(file.string(), {"only a PNG is written with alpha", "アルファつきで書けるのは PNG だけ"},
                     {"use .png", ".png を使う"});
  const std::string bytes = encode_picture(file, ImageFormat::png, picture, 4, program);
  with_memory(file, [&] { save_file(file, bytes); });
}

std::string encode_image(const fs::path& file, ImageFormat format, const Picture& picture, ImageProgram& program) {
  if (format == ImageFormat::exr || format == ImageFormat::hdr)
    throw InputError(file.string(), {"this picture has 8 bits a channel", "8 ビットの画像です"},
                     {"use .png or .jpg", ".png か .jpg を使ってください"});
  return encode_picture(file, format, picture, 3, program);
}

}  // namespace cg
