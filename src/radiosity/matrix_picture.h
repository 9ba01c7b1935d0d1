// The matrix 1 - rho F of a radiosity system as an image: what each row gathers from, and what each column lights.
#pragma once
#include "image/display.h"
#include "radiosity/solver.h"

namespace cg {

// Which reflectance stands for rho: the mean of the channels, or one of them.
enum class MatrixChannel { mean, red, green, blue };
double reflectance_of(const glm::dvec3& rho, MatrixChannel channel);

// The entry of 1 - rho F that is the largest in magnitude among those that fall into a cell, so that nothing vanishes.
struct MatrixCell {
  float value = 0;
  std::uint32_t i = 0, j = 0;  // its row and column
};

struct MatrixPicture {
  std::size_t rows = 0;   // of the matrix
  std::size_t known = 0;  // the first so many are in the picture: those that the matrix keeps
  int side = 0;           // cells a row and a column
  std::vector<MatrixCell> cells;
  float least = 0;  // the smallest magnitude of a cell that is not 0

  const MatrixCell& at(int x, int y) const { return cells[std::size_t(y) * std::size_t(side) + std::size_t(x)]; }
  // The cell that row (or column) i falls into, and the first row of a cell.
  int cell_of(std::size_t i) const { return int(i * std::size_t(side) / rows); }
  std::size_t first_of(int cell) const {
    return (std::size_t(cell) * rows + std::size_t(side) - 1) / std::size_t(side);
  }
};

// At most `most_side` (> 0) cells a side; one an entry where there are no more. Throws Cancelled.
MatrixPicture matrix_picture(const RadiositySystem& system, int most_side, MatrixChannel channel,
                             const Progress& progress);

// Brightness by the logarithm of the magnitude: `none` is 0, full colour is 1.
struct MatrixColours {
  glm::u8vec3 none, positive, negative, unknown;
};
// 0..1 for a magnitude, `least` > 0 being the smallest that is told apart from 0.
float matrix_brightness(float magnitude, float least);
Picture picture_of(const MatrixPicture& matrix, const MatrixColours& colours);

}  // namespace cg
