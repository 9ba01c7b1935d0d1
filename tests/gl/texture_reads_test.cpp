// What OpenGL reads from a texture beside what shading/texture_lookup.h says it does: random points, footprints, sizes,
// wraps and filters, and the exact borders.
#include <gtest/gtest.h>

#include <random>

#include "gl/offscreen_context.h"
#include "gl/texture_objects.h"
#include "shading/texture_lookup.h"
#include "tests/gl/whole_picture.h"

namespace cg {
namespace {

constexpr int side = 256, reads = side * side;

constexpr const char* fragment = R"(#version 330 core
uniform sampler2D image, points, footprints;
out vec4 colour;
void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  vec4 d = texelFetch(footprints, here, 0);
  colour = textureGrad(image, texelFetch(points, here, 0).xy, d.xy, d.zw);
}
)";

// The same footprint at every pixel, as the driver finds it: the difference of neighbours.
constexpr const char* affine_fragment = R"(#version 330 core
uniform sampler2D image;
uniform vec2 uv, dx, dy;
out vec4 colour;
void main() { colour = texture(image, uv + gl_FragCoord.x * dx + gl_FragCoord.y * dy); }
)";

class TextureReads : public testing::Test {
 protected:
  void SetUp() override {
    try {
      context_ = std::make_unique<OffscreenContext>(GlProfile::core);
    } catch (const NoContext& e) {
      GTEST_SKIP() << e.reason.en;
    }
    picture_.emplace(side, fragment);
    affine_ = WholePicture::make_program(affine_fragment);
  }

  std::vector<glm::vec4> draw() {
    objects_.end_frame();
    return picture_->draw();
  }

  void bind(const TextureHandle& image, const Sampling& s) {
    const GLuint name = objects_.get(image);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, name);
    set_sampling(GL_TEXTURE_2D, s);
  }

  // uv at pixel (0, 0)'s lower left corner, and on from there.
  std::vector<glm::vec4> read_affine(const TextureHandle& image, const Sampling& s, const Footprint<float>& f) {
    glUseProgram(affine_);
    bind(image, s);
    glUniform2f(glGetUniformLocation(affine_, "uv"), f.uv.x, f.uv.y);
    glUniform2f(glGetUniformLocation(affine_, "dx"), f.dx.x, f.dx.y);
    glUniform2f(glGetUniformLocation(affine_, "dy"), f.dy.x, f.dy.y);
    return draw();
  }

  std::vector<glm::vec4> read(const TextureHandle& image, const Sampling& s, const std::vector<Footprint<float>>& at) {
    std::vector<glm::vec4> points(reads), footprints(reads);
    for (std::size_t i = 0; i < at.size(); ++i)
      points[i] = glm::vec4(at[i].uv, 0, 0), footprints[i] = glm::vec4(at[i].dx, at[i].dy);
    const GLuint a = picture_->table(points, 1), b = picture_->table(footprints, 2);
    picture_->use();
    bind(image, s);
    glUniform1i(glGetUniformLocation(picture_->program(), "points"), 1);
    glUniform1i(glGetUniformLocation(picture_->program(), "footprints"), 2);
    const std::vector<glm::vec4> out = draw();
    glDeleteTextures(1, &a), glDeleteTextures(1, &b);
    return out;
  }

  std::unique_ptr<OffscreenContext> context_;
  std::optional<WholePicture> picture_;
  TextureObjects objects_;
  GLuint affine_ = 0;
};

template <class Texel>
TextureHandle noise(int width, int height, Encoding encoding, unsigned seed) {
  std::mt19937 random(seed);
  Image<Texel> texels(width, height);
  for (Texel& t : texels.pixels())
    for (int c = 0; c < 4; ++c) {
      if constexpr (std::is_same_v<Texel, glm::vec4>)
        t[c] = float(random() % 1000) / 1000.0f;
      else
        t[c] = typename Texel::value_type(random());
    }
  return TextureImage::make(std::move(texels), encoding);
}

std::vector<Sampling> samplings(std::initializer_list<MinFilter> filters) {
  std::vector<Sampling> out;
  for (const Wrap s : {Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::border})
    for (const Wrap t : {Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::border})
      for (const MagFilter mag : {MagFilter::nearest, MagFilter::linear})
        for (const MinFilter min : filters) {
          Sampling& r = out.emplace_back();
          r.wrap_s = s, r.wrap_t = t, r.mag_filter = mag, r.min_filter = min;
          r.border = {0.25, 0.5, 0.75}, r.border_alpha = 0.5;
        }
  return out;
}

// A texel's own border lies within `texels` of the point: there one ulp decides.
bool near_border(const TextureImage& image, glm::vec2 uv, double offset, double texels) {
  for (int c = 0; c < 2; ++c) {
    const double at = double(uv[c]) * (c == 0 ? image.width() : image.height()) + offset;
    if (std::abs(at - std::round(at)) < texels) return true;
  }
  return false;
}

double worst_of(const glm::vec4& a, const glm::dvec4& b) {
  double worst = 0;
  for (int c = 0; c < 4; ++c) worst = std::max(worst, std::abs(double(a[c]) - b[c]));
  return worst;
}

// Level 0 alone: the wraps and the two filters.
TEST_F(TextureReads, LevelZeroIsTheSpecifications) {
  const TextureHandle images[] = {
      noise<glm::u8vec4>(1, 1, Encoding::as_stored, 1), noise<glm::u8vec4>(3, 5, Encoding::as_stored, 2),
      noise<glm::u8vec4>(64, 32, Encoding::srgb, 3), noise<glm::vec4>(33, 17, Encoding::as_stored, 4)};
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uv(-3, 4);
  std::vector<Footprint<float>> at(reads);
  for (Footprint<float>& f : at) f.uv = {uv(random), uv(random)};
  for (const TextureHandle& image : images) {
    const bool eight = std::holds_alternative<Image<glm::u8vec4>>(image->texels(0));
    double worst = 0;
    int skipped = 0;
    for (const Sampling& s : samplings({MinFilter::nearest})) {
      const std::vector<glm::vec4> theirs = read(image, s, at);
      for (std::size_t i = 0; i < at.size(); i += 7) {
        if (s.mag_filter == MagFilter::nearest && near_border(*image, at[i].uv, 0, 1e-4)) {
          ++skipped;
          continue;
        }
        const Footprint<double> f{glm::dvec2(at[i].uv)};
        const double off = worst_of(theirs[i], texture_colour(*image, s, f));
        worst = std::max(worst, off);
        // Linear reads of 8 bits have weights of 8 bits on Mesa, and its sRGB is a polynomial.
        const bool rough = eight && (s.mag_filter == MagFilter::linear || image->encoding() == Encoding::srgb);
        ASSERT_LE(off, rough ? 2.0 / 255 : 2e-5)
            << image->width() << "x" << image->height() << " " << int(s.wrap_s) << int(s.wrap_t) << int(s.mag_filter)
            << " at " << at[i].uv.x << ", " << at[i].uv.y;
      }
    }
    std::printf("%d x %d: worst %.2g, %d left out\n", image->width(), image->height(), worst, skipped);
  }
}

// At 0, 1, between texels, far away, and at no number at all.
TEST_F(TextureReads, ExactBordersAndExtremes) {
  const TextureHandle image = noise<glm::u8vec4>(4, 8, Encoding::as_stored, 5);
  std::vector<float> numbers{0.0f, -0.0f, 1.0f, -1.0f, 2.0f, 1e4f, -1e4f, 0x1p20f};
  for (int i = -16; i <= 24; ++i) numbers.push_back(float(i) / 8.0f);
  std::vector<Footprint<float>> at;
  for (const float u : numbers)
    for (const float v : numbers) at.push_back({{u, v}});
  for (const Sampling& s : samplings({MinFilter::nearest})) {
    const std::vector<glm::vec4> theirs = read(image, s, at);
    for (std::size_t i = 0; i < at.size(); ++i)
      ASSERT_LE(worst_of(theirs[i], texture_colour<double>(*image, s, {glm::dvec2(at[i].uv)})),
                s.mag_filter == MagFilter::linear ? 2.0 / 255 : 1e-6)
          << int(s.wrap_s) << int(s.wrap_t) << int(s.mag_filter) << " at " << at[i].uv.x << ", " << at[i].uv.y;
  }
}

// Mipmaps: OpenGL's level may be off by 0.05, as drivers approximate the logarithm, and uv by what floats lose on their
// way over the picture.
TEST_F(TextureReads, MipmapsWithinTheDriversLevel) {
  const TextureHandle image = noise<glm::vec4>(64, 64, Encoding::as_stored, 6);
  std::mt19937 random(9);
  std::uniform_real_distribution<float> unit(0, 1);
  for (const MagFilter mag : {MagFilter::nearest, MagFilter::linear})
    for (const MinFilter min :
         {MinFilter::nearest, MinFilter::linear, MinFilter::nearest_mipmap_nearest, MinFilter::linear_mipmap_nearest,
          MinFilter::nearest_mipmap_linear, MinFilter::linear_mipmap_linear}) {
      Sampling s;
      s.mag_filter = mag, s.min_filter = min;
      double worst = 0;
      int compared = 0, outside = 0;
      for (int draw = 0; draw < 24; ++draw) {
        const float width = std::exp2(unit(random) * 8.5f - 1.5f) / 64, angle = unit(random) * 6.2831853f;
        const float narrow = std::exp2(-3 * unit(random)), c = std::cos(angle), d = std::sin(angle);
        const Footprint<float> f{
            {unit(random), unit(random)}, {width * c, width * d}, {-width * narrow * d, width * narrow * c}};
        const std::vector<glm::vec4> theirs = read_affine(image, s, f);
        const double lambda = level_of_detail<double>(*image, f.dx, f.dy);
        for (int i = 0; i < reads; i += 5) {
          const glm::dvec2 uv =
              glm::dvec2(f.uv) + (i % side + 0.5) * glm::dvec2(f.dx) + (i / side + 0.5) * glm::dvec2(f.dy);
          double off = 1;
          for (const double shift : {0.0, -0.05, -0.025, 0.025, 0.05})
            off = std::min(off, worst_of(theirs[std::size_t(i)], texture_at_level(*image, s, uv, lambda + shift)));
          ++compared;
          outside += off > 3.0 / 255;
          worst = std::max(worst, off);
        }
      }
      std::printf("%s, %s: worst %.3f, %d of %d beyond 3/255\n", names_of<MagFilter>[std::size_t(mag)].id.data(),
                  names_of<MinFilter>[std::size_t(min)].id.data(), worst, outside, compared);
      EXPECT_LE(outside, compared / 100) << int(mag) << int(min);
    }
}

}  // namespace
}  // namespace cg
