// The matrix as an image: every entry is the one it should be, and however small the image is nothing vanishes.
#include "radiosity/matrix_picture.h"

#include "tests/radiosity/systems.h"

namespace cg {
namespace {

TEST(MatrixPicture, HoldsEveryEntryWhereThereIsRoom) {
  RadiositySystem system = cube_system(std::vector<double>(6, 1), {.1, .2, .3, .4, .5, .6});
  system.reflectance[2] = {.9, 0, .3};
  const Progress progress;
  for (const auto& [channel, rho2] : {std::pair{MatrixChannel::mean, .4},
                                      {MatrixChannel::red, .9},
                                      {MatrixChannel::green, 0.},
                                      {MatrixChannel::blue, .3}}) {
    const MatrixPicture p = matrix_picture(system, 100, channel, progress);
    ASSERT_EQ(p.side, 6);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) {
        const double rho = i == 2 ? rho2 : .1 * (i + 1), f = i == j           ? 0
                                                             : i / 2 == j / 2 ? cube_opposite
                                                                              : cube_adjacent;
        EXPECT_FLOAT_EQ(p.at(j, i).value, float((i == j) - rho * f)) << i << ' ' << j;
        EXPECT_EQ(p.at(j, i).i, std::uint32_t(i));
        EXPECT_EQ(p.at(j, i).j, std::uint32_t(j));
      }
    EXPECT_FLOAT_EQ(p.least, float(.1 * cube_opposite));
  }
}

TEST(MatrixPicture, ACellShowsItsLargestEntry) {
  const std::size_t n = 45;
  const RadiositySystem system = sphere_system(n);
  const Progress progress;
  for (const int side : {1, 7, 20, 44}) {
    const MatrixPicture p = matrix_picture(system, side, MatrixChannel::mean, progress);
    std::vector<float> most(std::size_t(side * side), 0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const double v = (i == j) - system.reflectance[i].x * system.matrix->at(i, j);
        float& cell = most[std::size_t(p.cell_of(i) * side + p.cell_of(j))];
        cell = std::max(cell, float(std::abs(v)));
      }
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const MatrixCell& cell = p.at(x, y);
        EXPECT_FLOAT_EQ(std::abs(cell.value), most[std::size_t(y * side + x)]);
        EXPECT_EQ(p.cell_of(cell.i), y);
        EXPECT_EQ(p.cell_of(cell.j), x);
      }
    for (int c = 0; c < side; ++c) {
      EXPECT_EQ(p.cell_of(p.first_of(c)), c);
      if (c > 0) {
        EXPECT_EQ(p.cell_of(p.first_of(c) - 1), c - 1);
      }
    }
  }
}

TEST(MatrixPicture, OneFaintEntryAmongManyIsSeen) {
  const std::size_t n = 300;
  std::vector<double> factors(n * n, 0);
  factors[17 * n + 251] = 1e-6;
  const RadiositySystem system =
      system_with(factors, std::vector<double>(n, 1), std::vector<double>(n, 1), std::vector<double>(n, .5));
  const Progress progress;
  const MatrixPicture p = matrix_picture(system, 20, MatrixChannel::mean, progress);
  const MatrixColours colours{{0, 0, 0}, {255, 128, 0}, {0, 128, 255}, {64, 64, 64}};
  const Picture picture = picture_of(p, colours);
  const auto lit = [&](int x, int y) { return picture.at(x, y) != glm::u8vec4(0, 0, 0, 255); };
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) EXPECT_EQ(lit(x, y), x == y || (y == 1 && x == 16)) << x << ' ' << y;
  EXPECT_GT(picture.at(16, 1).z, 20);
  EXPECT_EQ(picture.at(16, 1).x, 0);
  EXPECT_EQ(picture.at(3, 3), glm::u8vec4(255, 128, 0, 255));
}

TEST(MatrixPicture, RowsThatAreNotKeptAreMarked) {
  const std::size_t n = 600;
  const FormFactorMethod method{[](std::uint32_t i, const Progress&) {
                                  FormFactorRow row;
                                  for (std::uint32_t j = 0; j < n; ++j)
                                    if (j != i) row.factors.push_back({j, 1.f / n});
                                  row.sum = 1;
                                  return row;
                                },
                                {}};
  Progress progress;
  MatrixPlan plan = plan_matrix(n, method, 1, progress);
  plan.kept_rows = 200;
  const auto matrix = FormFactorMatrix::make(plan, method, std::vector<double>(n, 1), {}, 1, progress);
  ASSERT_EQ(matrix->kept_rows(), 200u);
  const RadiositySystem system{matrix, std::vector<glm::dvec3>(n), std::vector<glm::dvec3>(n, glm::dvec3(.5))};
  const MatrixPicture p = matrix_picture(system, 30, MatrixChannel::mean, progress);
  EXPECT_EQ(p.known, 200u);
  const MatrixColours colours{{0, 0, 0}, {255, 128, 0}, {0, 128, 255}, {64, 64, 64}};
  const Picture picture = picture_of(p, colours);
  EXPECT_NE(picture.at(4, 9), glm::u8vec4(64, 64, 64, 255));
  EXPECT_EQ(picture.at(4, 10), glm::u8vec4(64, 64, 64, 255));
  EXPECT_EQ(picture.at(29, 29), glm::u8vec4(64, 64, 64, 255));
  progress.cancelled = true;
  EXPECT_THROW(matrix_picture(system, 30, MatrixChannel::mean, progress), Cancelled);
}

TEST(MatrixPicture, BrightnessGrowsWithTheLogarithm) {
  EXPECT_EQ(matrix_brightness(0, 1e-5f), 0);
  EXPECT_GT(matrix_brightness(1e-5f, 1e-5f), 0.1f);
  EXPECT_FLOAT_EQ(matrix_brightness(1, 1e-5f), 1);
  const float a = matrix_brightness(1e-4f, 1e-6f), b = matrix_brightness(1e-3f, 1e-6f),
              c = matrix_brightness(1e-2f, 1e-6f);
  EXPECT_NEAR(b - a, c - b, 1e-6);
  EXPECT_GT(b, a);
  EXPECT_EQ(matrix_brightness(1, 1), 1);  // one patch
}

}  // namespace
}  // namespace cg
