#include "radiosity/matrix_picture.h"

#include <cmath>

#include "radiosity/matrix_rows.h"

namespace cg {

double reflectance_of(const glm::dvec3& rho, MatrixChannel channel) {
  return channel == MatrixChannel::mean ? (rho.x + rho.y + rho.z) / 3 : rho[int(channel) - int(MatrixChannel::red)];
}

MatrixPicture matrix_picture(const RadiositySystem& system, int most_side, MatrixChannel channel,
                             const Progress& progress) {
  const FormFactorMatrix& f = *system.matrix;
  MatrixPicture out;
  out.rows = f.size(), out.known = f.kept_rows();
  out.side = int(std::min(out.rows, std::size_t(most_side)));
  const auto side = std::size_t(out.side);
  out.cells.resize(side * side);
  std::vector<std::uint32_t> cell_of(out.rows);
  for (std::size_t i = 0; i < out.rows; ++i) cell_of[i] = std::uint32_t(out.cell_of(i));
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x)
      out.cells[y * side + x] = {0, std::uint32_t(out.first_of(int(y))), std::uint32_t(out.first_of(int(x)))};
  for (std::size_t i = 0; i < out.known; ++i) {
    if (i % 64 == 0 && progress.cancelled.load(std::memory_order_relaxed)) throw Cancelled{};
    MatrixCell* row = out.cells.data() + cell_of[i] * side;
    const auto enter = [&](std::size_t j, double value) {
      MatrixCell& cell = row[cell_of[j]];
      if (std::abs(value) > std::abs(double(cell.value))) cell = {float(value), std::uint32_t(i), std::uint32_t(j)};
    };
    const double rho = reflectance_of(system.reflectance[i], channel);
    double own = 0;
    f.visit(i, [&](std::size_t j, double factor) { j == i ? void(own = factor) : enter(j, -rho * factor); });
    enter(i, 1 - rho * own);
  }
  for (const MatrixCell& cell : out.cells)
    if (const float v = std::abs(cell.value); v > 0 && (out.least == 0 || v < out.least)) out.least = v;
  return out;
}

float matrix_brightness(float magnitude, float least) {
  constexpr float faintest = 0.12f;  // so that it is told apart from nothing
  if (!(magnitude > 0)) return 0;
  const float decades = std::max(-std::log10(least), 1e-3f), t = 1 + std::log10(magnitude) / decades;
  return faintest + (1 - faintest) * std::clamp(t, 0.0f, 1.0f);
}

Picture picture_of(const MatrixPicture& matrix, const MatrixColours& colours) {
  Picture out(matrix.side, matrix.side, glm::u8vec4(colours.unknown, 255));
  for (int y = 0; y < matrix.side && matrix.first_of(y) < matrix.known; ++y)
    for (int x = 0; x < matrix.side; ++x) {
      const float v = matrix.at(x, y).value, t = matrix_brightness(std::abs(v), matrix.least);
      const glm::vec3 full(v > 0 ? colours.positive : colours.negative), none(colours.none);
      out.at(x, y) = glm::u8vec4(glm::u8vec3(none + t * (full - none) + 0.5f), 255);
    }
  return out;
}

}  // namespace cg
