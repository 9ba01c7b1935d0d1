// OpenGL's own cube map beside shading/environment_lookup.h: the face and the texel of many directions.
#include <gtest/gtest.h>

#include <random>

#include "gl/check.h"
#include "gl/offscreen_context.h"
#include "shading/environment_lookup.h"
#include "tests/gl/whole_picture.h"

namespace cg {
namespace {

constexpr int side = 320, texels = 64;

constexpr const char* fragment = R"(#version 330 core
uniform samplerCube image;
uniform sampler2D directions;
out vec4 colour;
void main() { colour = textureLod(image, texelFetch(directions, ivec2(gl_FragCoord.xy), 0).xyz, 0.0); }
)";

TEST(EnvironmentReads, SameFaceAndTexelAsOpenGl) {
  std::optional<OffscreenContext> context;
  try {
    context.emplace(GlProfile::core);
  } catch (const NoContext& e) {
    GTEST_SKIP() << e.reason.en;
  }
  WholePicture picture(side, fragment);
  // Each texel holds its own place.
  GLuint cube;
  glGenTextures(1, &cube);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_CUBE_MAP, cube);
  for (int f = 0; f < cube_faces; ++f) {
    std::vector<glm::vec4> face;
    for (int t = 0; t < texels; ++t)
      for (int s = 0; s < texels; ++s) face.emplace_back(f, s, t, 1);
    glTexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + f), 0, GL_RGBA32F, texels, texels, 0, GL_RGBA, GL_FLOAT,
                 face.data());
  }
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_NEAREST);

  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  std::vector<glm::vec4> directions;
  for (const float x : {-1.0f, 0.0f, 1.0f})
    for (const float y : {-1.0f, 0.0f, 1.0f})
      for (const float z : {-1.0f, 0.0f, 1.0f}) directions.emplace_back(x, y, z, 0);
  while (directions.size() < std::size_t(side * side))
    directions.emplace_back(normal(random), normal(random), normal(random), 0);
  const GLuint table = picture.table(directions, 1);
  picture.use();
  glUniform1i(glGetUniformLocation(picture.program(), "directions"), 1);
  const std::vector<glm::vec4> theirs = picture.draw();
  glDeleteTextures(1, &table);

  int other_face = 0, other_texel = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto ours = cube_place<double>(glm::dvec3(directions[i]));
    other_face += int(ours.face) != int(theirs[i].x);
    if (int(ours.face) != int(theirs[i].x)) continue;
    const auto texel = [](double c) { return std::min(int(c * texels), texels - 1); };
    const int s = std::abs(texel(ours.st.x) - int(theirs[i].y)), t = std::abs(texel(ours.st.y) - int(theirs[i].z));
    EXPECT_LE(std::max(s, t), 1) << directions[i].x << " " << directions[i].y << " " << directions[i].z;
    other_texel += s + t > 0;
  }
  std::printf("%zu directions: %d on another face, %d in a neighbouring texel\n", directions.size(), other_face,
              other_texel);
  EXPECT_EQ(other_face, 0);
}

}  // namespace
}  // namespace cg
