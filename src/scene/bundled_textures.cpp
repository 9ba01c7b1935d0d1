#include "scene/bundled_textures.h"

#include <cmath>

#include "scene/texture_makers.h"

namespace cg {

namespace {

glm::u8vec4 stored(const glm::dvec4& c) { return glm::u8vec4(glm::clamp(c, 0.0, 1.0) * 255.0 + 0.5); }

// at(u, v) at the middles of the texels; 4 x 4 of them are averaged where `smooth`, colour weighted by alpha.
template <class At>
Picture made(int width, int height, bool smooth, const At& at) {
  Picture out(width, height);
  const int n = smooth ? 4 : 1;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      glm::dvec3 plain(0), covered(0);
      double alpha = 0;
      for (int k = 0; k < n * n; ++k) {
        const double u = (x + (k % n + 0.5) / n) / width, v = 1 - (y + (k / n + 0.5) / n) / height;
        const glm::dvec4 c = at(u, v);
        plain += glm::dvec3(c), covered += glm::dvec3(c) * c.w, alpha += c.w;
      }
      const glm::dvec3 colour = alpha > 0 ? covered / alpha : plain / double(n * n);
      out.at(x, y) = stored(glm::dvec4(colour, alpha / (n * n)));
    }
  return out;
}

glm::dvec4 grey(double v) { return glm::dvec4(glm::dvec3(v), 1); }

// The normal of the brick's height, one brick's height being 1/8 and its relief a tenth of that; blue is along N.
glm::dvec4 brick_normal(double u, double v) {
  constexpr double h = 1.0 / 512, relief = 0.0125;
  const auto at = [](double a, double b) { return brick_height(a - std::floor(a), b - std::floor(b)); };
  const glm::dvec3 n = glm::normalize(glm::dvec3(relief * (at(u - h, v) - at(u + h, v)) / (2 * h),
                                                 relief * (at(u, v - h) - at(u, v + h)) / (2 * h), 1));
  return glm::dvec4(n * 0.5 + 0.5, 1);
}

// GL 3.3, table 3.17, backwards.
glm::dvec3 face_direction(int face, double s, double t) {
  const double a = 2 * s - 1, b = 2 * t - 1;
  const glm::dvec3 directions[] = {{1, -b, -a}, {-1, -b, a}, {a, 1, b}, {a, -1, -b}, {a, -b, 1}, {-a, -b, -1}};
  return directions[face];
}

void add_room(std::vector<BundledTexture>& out) {
  const char* const names[] = {"right", "left", "top", "bottom", "near", "far"};
  const char* const signs[] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  for (int f = 0; f < 6; ++f)
    out.push_back({std::string("room-") + names[f] + ".png",
                   made(128, 128, true,
                        [&](double u, double v) { return room(face_direction(f, u, 1 - v), signs[f], u, 1 - v); }),
                   false, "A room from its middle, the face " + std::string(signs[f]) + " of a cube map."});
}

}  // namespace

std::vector<BundledTexture> bundled_textures_made() {
  std::vector<BundledTexture> out{
      {"uv-grid.png", made(512, 512, true, uv_grid), false, "Columns A to H along u, rows 1 to 8 along v."},
      {"checker.png", made(64, 64, false, checker), false, "Eight by eight squares, 0 and 255."},
      {"brick-colour.png", made(256, 256, true, brick_colour), false, "A running bond."},
      {"brick-height.png", made(256, 256, true, [](double u, double v) { return grey(brick_height(u, v)); }), false,
       "Its height, to be bumped."},
      {"brick-normal.png", made(256, 256, true, brick_normal), false, "The normals of that height, in tangent space."},
      {"wood.png", made(256, 256, true, wood), false, "Rings of a trunk, as Peachey (1985) has them."},
      {"marble.png", made(256, 256, true, marble), false, "Disturbed veins, as Perlin (1985) has them."},
      {"globe.png", made(512, 256, true, globe), false,
       "A planet that nobody knows, in longitude and latitude, with its graticule."},
      {"hair-card.png", made(256, 256, true, hair_card), true, "Strands of hair, with alpha."},
      {"torn-cloth.png", made(256, 256, true, torn_cloth), true, "A woven cloth with holes, with alpha."},
      {"rust-mask.png", made(256, 256, true, [](double u, double v) { return grey(rust_mask(u, v)); }), false,
       "White where metal is bare, black where it rusts: for k_s and k_r."},
      {"sky.png", made(512, 256, true, sky), false, "A sky in longitude and latitude."}};
  add_room(out);
  return out;
}

std::string texture_sources(const std::vector<BundledTexture>& textures) {
  std::string out =
      "# Where the textures come from\n\nAll files here are written by `shadebench-textures` "
      "(`src/scene/textures_main.cpp`); a test checks that they are\nwhat it writes. They carry no licence beyond that "
      "of this project.\n\n| file | what it shows |\n|---|---|\n";
  for (const BundledTexture& t : textures) out += "| `" + t.name + "` | " + t.origin + " |\n";
  return out;
}

}  // namespace cg
