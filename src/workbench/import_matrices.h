// The matrices of a program that is read, kept as the calls that make them, so that the numbers a student wrote come
// back as they were written.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "scene/camera.h"
#include "scene/transform.h"

namespace cg {

struct MatrixCall {
  enum Kind { look_at, translate, rotate, scale, matrix };
  Kind kind = matrix;
  std::vector<double> numbers;  // of the call: 9, 3, 4 (degrees, axis), 3, 16 (column by column)
  long line = 0;
  friend bool operator==(const MatrixCall&, const MatrixCall&) = default;
};

using MatrixCalls = std::vector<MatrixCall>;  // from glLoadIdentity on; each is multiplied from the right

glm::dmat4 product(std::span<const MatrixCall> calls);

// How many calls of `calls` are the view: up to the last look_at; 0 where there is none.
std::size_t view_length(std::span<const MatrixCall> calls);

// The calls as one transform: the very numbers where they come in its order, T Rz Ry Rx S, else decomposed. Nothing
// where the matrix is none of that kind: sheared, or flat.
std::optional<Transform> transform_of(std::span<const MatrixCall> calls);

// Eye, target and up of a camera with that view: of a single look_at its own numbers. Nothing where the view also
// scales or shears.
bool set_view(Camera& camera, std::span<const MatrixCall> calls);

// v with what rounding adds to a short number taken away: 30.000000000000004 is 30, 1e-17 beside ones is 0.
glm::dvec3 short_numbers(glm::dvec3 v);

}  // namespace cg
