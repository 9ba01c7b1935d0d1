#include "measure/resample.h"

#include <algorithm>
#include <cmath>

namespace cg {

namespace {

// Weights of the samples of one row or column that count for pixel i: samples first .. first + weight.size() - 1.
struct Taps {
  int first = 0;
  std::vector<double> weight;  // sum 1
};

Taps taps(Resampling how, int factor, int pixel, int samples) {
  const double reach = how == Resampling::tent ? 1.0 : 0.5;  // pixels
  Taps out;
  const int begin = int(std::floor((pixel + 0.5 - reach) * factor)),
            end = int(std::ceil((pixel + 0.5 + reach) * factor));
  out.first = std::max(begin, 0);
  double sum = 0;
  for (int s = out.first; s < std::min(end, samples); ++s) {
    const double away = std::abs((s + 0.5) / factor - (pixel + 0.5));
    out.weight.push_back(how == Resampling::tent ? std::max(0.0, 1 - away) : 1.0);
    sum += out.weight.back();
  }
  for (double& w : out.weight) w /= sum;  // at the picture's edge only half a tent has samples
  return out;
}

template <class Pixel>
Image<Pixel> repeated(const Image<Pixel>& image, int factor) {
  Image<Pixel> out(image.width() * factor, image.height() * factor);
  for (int y = 0; y < out.height(); ++y)
    for (int x = 0; x < out.width(); ++x) out.at(x, y) = image.at(x / factor, y / factor);
  return out;
}

}  // namespace

ColourImage resampled(const ColourImage& image, Resampling how, int factor) {
  if (how == Resampling::nearest) return repeated(image, factor);
  if (how == Resampling::none || (factor <= 1 && how == Resampling::box)) return image;
  const int width = image.width() / factor, height = image.height() / factor;
  std::vector<Taps> across;
  for (int x = 0; x < width; ++x) across.push_back(taps(how, factor, x, image.width()));
  ColourImage out(width, height);
  std::vector<glm::dvec3> row(std::size_t(image.width()));  // the samples of a column, weighted
  for (int y = 0; y < height; ++y) {
    const Taps down = taps(how, factor, y, image.height());
    std::fill(row.begin(), row.end(), glm::dvec3(0));
    for (std::size_t k = 0; k < down.weight.size(); ++k) {
      const glm::vec3* samples = image.row(down.first + int(k));
      for (std::size_t s = 0; s < row.size(); ++s) row[s] += down.weight[k] * glm::dvec3(samples[s]);
    }
    for (int x = 0; x < width; ++x) {
      const Taps& t = across[std::size_t(x)];
      glm::dvec3 sum(0);
      for (std::size_t k = 0; k < t.weight.size(); ++k) sum += t.weight[k] * row[std::size_t(t.first) + k];
      out.at(x, y) = glm::vec3(sum);
    }
  }
  return out;
}

Image<std::uint8_t> resampled_coverage(const Image<std::uint8_t>& covered, Resampling how, int factor) {
  if (how == Resampling::nearest) return repeated(covered, factor);
  if (how == Resampling::none || factor <= 1) return covered;
  Image<std::uint8_t> out(covered.width() / factor, covered.height() / factor);
  for (int y = 0; y < out.height() * factor; ++y)
    for (int x = 0; x < out.width() * factor; ++x)
      if (covered.at(x, y)) out.at(x / factor, y / factor) = 1;
  return out;
}

}  // namespace cg
