#include "measure/extreme_check.h"

#include <cmath>

#include "math/vec.h"
#include "measure/extreme_reference.h"

namespace cg {

namespace {

constexpr int edge_pixels = 3;  // at an outline rounding decides
constexpr Words nothing_was_drawn = {"nothing was drawn", "何も描かれていない"};

Text at_pixel(int x, int y) {
  const std::string place = std::to_string(x) + "," + std::to_string(y);
  return {"at pixel " + place, "画素 " + place};
}

int coverage_mismatch(const Frame& a, const Frame& b) {
  int n = 0;
  for (std::size_t i = 0; i < a.covered.size(); ++i) n += a.covered.pixels()[i] != b.covered.pixels()[i];
  return n;
}

ExtremeError wrong_coverage(int pixels) {
  const std::string n = std::to_string(pixels);
  return {1, {n + " pixels are covered in only one of the two pictures", n + " 画素は一方の画像だけで覆われている"}};
}

// The worst of every pixel that `right` has a colour for.
template <class Right>
ExtremeError worst_pixel(const Frame& frame, const Right& right) {
  ExtremeError worst;
  for (int y = 0; y < frame.colour.height(); ++y)
    for (int x = 0; x < frame.colour.width(); ++x) {
      const std::optional<glm::dvec3> wanted = right(x, y);
      if (!wanted) continue;
      const double error = colour_error(glm::dvec3(frame.colour.at(x, y)), *wanted);
      if (is_worse(error, worst.error)) worst = {error, at_pixel(x, y)};
    }
  return worst;
}

}  // namespace

void apply(const ExtremeVariant& variant, Scene& scene) {
  scene.shading.mode = variant.mode, scene.shading.clamp = variant.clamp, scene.shading.precision = variant.precision;
}

Frame draw(const Technique& technique, const Scene& scene, const View& view, Progress& progress) {
  return technique.render(scene, technique.plan(scene, view), view, progress);
}

ExtremeError frame_error(const Frame& frame, const Frame& right) {
  if (frame.colour.width() != right.colour.width() || frame.colour.height() != right.colour.height())
    return {1, Words{"the pictures are not of one size", "二つの画像の大きさが違う"}};
  if (const int n = coverage_mismatch(frame, right); n > edge_pixels) return wrong_coverage(n);
  return worst_pixel(frame, [&](int x, int y) -> std::optional<glm::dvec3> {
    if (!frame.covered.at(x, y) || !right.covered.at(x, y)) return std::nullopt;
    return glm::dvec3(right.colour.at(x, y));
  });
}

PictureCheck same_as(std::function<Scene()> start, Change change) {
  return [=](const ExtremePicture& p) {
    Scene other = start();
    change(other);
    apply(p.variant, other);
    return frame_error(p.frame, draw(p.technique, other, p.view, p.progress));
  };
}

PictureCheck as_reference() {
  return [](const ExtremePicture& p) -> ExtremeError {
    Scene in_double = p.scene;
    in_double.shading.precision = Precision::double_precision;
    if (&p.reference != &p.technique || p.variant.precision == Precision::single_precision)
      if (const int n = coverage_mismatch(p.frame, draw(p.reference, in_double, p.view, p.progress)); n > edge_pixels)
        return wrong_coverage(n);
    const ReferenceError e = against_reference(p.scene, p.frame);
    if (e.pixels == 0) return {1, nothing_was_drawn};
    return {e.largest, e.x < 0 ? Text{} : at_pixel(e.x, e.y)};
  };
}

PictureCheck colour_is(std::function<glm::dvec3(const Scene&)> closed_form) {
  return [=](const ExtremePicture& p) -> ExtremeError {
    glm::dvec3 right = closed_form(p.scene);
    if (p.scene.shading.clamp) right = saturate(right);
    int covered = 0;
    for (const std::uint8_t c : p.frame.covered.pixels()) covered += c;
    if (covered == 0) return {1, nothing_was_drawn};
    return worst_pixel(p.frame, [&](int x, int y) -> std::optional<glm::dvec3> {
      return p.frame.covered.at(x, y) ? std::optional(right) : std::nullopt;
    });
  };
}

PictureCheck nothing_covered() {
  return [](const ExtremePicture& p) -> ExtremeError {
    int covered = 0;
    for (const std::uint8_t c : p.frame.covered.pixels()) covered += c;
    return {covered == 0 ? 0.0 : 1.0, covered == 0 ? Text{} : wrong_coverage(covered).said};
  };
}

PictureCheck by_technique(PictureCheck fixed, PictureCheck others) {
  return [=](const ExtremePicture& p) { return p.technique.id == "gl-fixed" ? fixed(p) : others(p); };
}

PictureCheck both_checks(PictureCheck a, PictureCheck b) {
  return [=](const ExtremePicture& p) {
    const ExtremeError first = a(p), second = b(p);
    return first.error >= second.error || std::isnan(first.error) ? first : second;
  };
}

}  // namespace cg
