// The pixels of a texture with its mipmaps, never changed after they are made.
// This work is based on: Lance Williams, Pyramidal Parametrics, 1983.
#pragma once
#include <glm/gtc/type_precision.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <variant>
#include <vector>

#include "image/image.h"
#include "params/field.h"

namespace cg {

// What the numbers of an image mean. The lecture's slides and OpenGL's fixed function take them for light as they are.
enum class Encoding { as_stored, srgb };
template <>
inline constexpr std::array<Name, 2> names_of<Encoding>{
    {{"as-stored", {"As stored", "そのままの値"}}, {"srgb", {"sRGB", "sRGB"}}}};

// Row 0 is the lowest, as uv count: texel (0, 0) begins at uv (0, 0). Red, green, blue, alpha; integers stand for 0..1.
using Texels = std::variant<Image<glm::u8vec4>, Image<glm::u16vec4>, Image<glm::vec4>>;

class TextureImage {
 public:
  // `texels`: level 0, as encoded, at least one. An sRGB image is averaged, and read, in linear light; alpha is linear
  // always, and so is an image of floats. Numbers that are not finite become 0.
  static std::shared_ptr<const TextureImage> make(Texels texels, Encoding encoding);
  // What is shown in the place of an image that cannot be read: 8 x 8, to be noticed.
  static std::shared_ptr<const TextureImage> placeholder();

  Encoding encoding() const { return encoding_; }
  int width() const { return width(0); }
  int height() const { return height(0); }
  // Of a level: half of the one before, rounded down, 1 at least; the last is 1 x 1.
  int levels() const { return int(levels_.size()); }
  int width(int level) const;
  int height(int level) const;
  // As stored: level 0 as it was given; the others in 16 bits where that has 8, so that their means lose nothing.
  const Texels& texels(int level) const { return levels_[std::size_t(level)]; }
  // 0 <= i < width, 0 <= j < height. Decoded: linear light where the image is sRGB.
  glm::vec4 texel(int level, int i, int j) const;
  std::size_t bytes() const;  // of all levels

 private:
  TextureImage() = default;
  Encoding encoding_ = Encoding::as_stored;
  std::vector<Texels> levels_;
};

using TextureHandle = std::shared_ptr<const TextureImage>;

// The mean of the texels that each texel of the smaller picture covers, in parts where it covers parts, so that the
// mean of the whole stays the same. width and height: 1 .. those of `texels`.
Image<glm::vec4> boxed_down(const Image<glm::vec4>& texels, int width, int height);

}  // namespace cg
