#include "scene/texture_image.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "image/display.h"

namespace cg {

namespace {

float finite(float v) { return std::isfinite(v) ? v : 0.0f; }

// The 256 steps of sRGB as linear light.
const std::array<float, 256>& srgb_table() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> t{};
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = linear_from_srgb(float(i) / 255.0f);
    return t;
  }();
  return table;
}

glm::vec4 decoded(const glm::u8vec4& t, Encoding encoding) {
  constexpr float step = 1.0f / 255.0f;
  if (encoding == Encoding::as_stored) return glm::vec4(t) * step;
  const auto& table = srgb_table();
  return {table[t.r], table[t.g], table[t.b], float(t.a) * step};
}
glm::vec4 decoded(const glm::u16vec4& t, Encoding encoding) {
  const glm::vec4 v = glm::vec4(t) * (1.0f / 65535.0f);
  if (encoding == Encoding::as_stored) return v;
  return {linear_from_srgb(v.r), linear_from_srgb(v.g), linear_from_srgb(v.b), v.a};
}
glm::vec4 decoded(const glm::vec4& t, Encoding) { return t; }

std::uint16_t to_16bit(float v) { return std::uint16_t(std::lround(std::clamp(v, 0.0f, 1.0f) * 65535.0f)); }

glm::u16vec4 encoded(const glm::vec4& t, Encoding encoding) {
  if (encoding == Encoding::as_stored) return {to_16bit(t.r), to_16bit(t.g), to_16bit(t.b), to_16bit(t.a)};
  return {to_16bit(srgb_from_linear(t.r)), to_16bit(srgb_from_linear(t.g)), to_16bit(srgb_from_linear(t.b)),
          to_16bit(t.a)};
}

Image<glm::vec4> decoded(const Texels& texels, Encoding encoding) {
  return std::visit(
      [&](const auto& image) {
        Image<glm::vec4> out = Image<glm::vec4>::unwritten(image.width(), image.height());
        std::transform(image.pixels().begin(), image.pixels().end(), out.pixels().begin(),
                       [&](const auto& t) { return decoded(t, encoding); });
        return out;
      },
      texels);
}

// One texel of the smaller row: the texels of the larger one from `first` on that it covers, with their shares.
struct Cover {
  int first = 0;
  std::vector<float> shares;  // their sum is 1
};

std::vector<Cover> covers(int larger, int smaller) {
  std::vector<Cover> out(static_cast<std::size_t>(smaller));
  const double width = double(larger) / double(smaller);
  for (int i = 0; i < smaller; ++i) {
    const double begin = double(i) * width, end = double(i + 1) * width;
    Cover& c = out[std::size_t(i)];
    c.first = std::min(int(begin), larger - 1);
    const int last = std::min(int(std::ceil(end)), larger);
    for (int k = c.first; k < last; ++k)
      c.shares.push_back(float((std::min(end, double(k + 1)) - std::max(begin, double(k))) / width));
  }
  return out;
}

}  // namespace

Image<glm::vec4> boxed_down(const Image<glm::vec4>& texels, int width, int height) {
  const std::vector<Cover> columns = covers(texels.width(), width), rows = covers(texels.height(), height);
  Image<glm::vec4> out = Image<glm::vec4>::unwritten(width, height);
  std::vector<glm::vec4> row(std::size_t(texels.width()));
  for (int y = 0; y < height; ++y) {
    const Cover& r = rows[std::size_t(y)];
    std::fill(row.begin(), row.end(), glm::vec4(0));
    for (std::size_t k = 0; k < r.shares.size(); ++k) {
      const glm::vec4* from = texels.row(r.first + int(k));
      for (std::size_t x = 0; x < row.size(); ++x) row[x] += r.shares[k] * from[x];
    }
    for (int x = 0; x < width; ++x) {
      const Cover& c = columns[std::size_t(x)];
      glm::vec4 sum(0);
      for (std::size_t k = 0; k < c.shares.size(); ++k) sum += c.shares[k] * row[std::size_t(c.first) + k];
      out.at(x, y) = sum;
    }
  }
  return out;
}

std::shared_ptr<const TextureImage> TextureImage::make(Texels texels, Encoding encoding) {
  if (std::visit([](const auto& image) { return image.empty(); }, texels))
    throw std::invalid_argument("a texture has at least one texel");
  std::shared_ptr<TextureImage> out(new TextureImage);
  const bool real = std::holds_alternative<Image<glm::vec4>>(texels);
  out->encoding_ = real ? Encoding::as_stored : encoding;
  if (real)
    for (glm::vec4& t : std::get<Image<glm::vec4>>(texels).pixels())
      t = {finite(t.r), finite(t.g), finite(t.b), finite(t.a)};
  Image<glm::vec4> level = decoded(texels, out->encoding_);
  out->levels_.push_back(std::move(texels));
  while (level.width() > 1 || level.height() > 1) {
    level = boxed_down(level, std::max(level.width() / 2, 1), std::max(level.height() / 2, 1));
    if (real) {
      out->levels_.emplace_back(level);
      continue;
    }
    Image<glm::u16vec4> stored = Image<glm::u16vec4>::unwritten(level.width(), level.height());
    std::transform(level.pixels().begin(), level.pixels().end(), stored.pixels().begin(),
                   [&](const glm::vec4& t) { return encoded(t, out->encoding_); });
    out->levels_.emplace_back(std::move(stored));
  }
  return out;
}

std::shared_ptr<const TextureImage> TextureImage::placeholder() {
  static const std::shared_ptr<const TextureImage> made = [] {
    Image<glm::u8vec4> checker(8, 8);
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x)
        checker.at(x, y) = (x + y) % 2 == 0 ? glm::u8vec4(255, 0, 255, 255) : glm::u8vec4(0, 0, 0, 255);
    return make(std::move(checker), Encoding::as_stored);
  }();
  return made;
}

int TextureImage::width(int level) const {
  return std::visit([](const auto& image) { return image.width(); }, texels(level));
}
int TextureImage::height(int level) const {
  return std::visit([](const auto& image) { return image.height(); }, texels(level));
}

glm::vec4 TextureImage::texel(int level, int i, int j) const {
  return std::visit([&](const auto& image) { return decoded(image.at(i, j), encoding_); }, texels(level));
}

std::size_t TextureImage::bytes() const {
  std::size_t sum = 0;
  for (const Texels& level : levels_)
    sum += std::visit([](const auto& image) { return image.size() * sizeof(image.pixels().front()); }, level);
  return sum;
}

}  // namespace cg
