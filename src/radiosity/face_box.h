// Where on a face of the hemicube a polygon that reaches behind the eye can be.
#pragma once
#include <optional>

#include "radiosity/hemicube.h"

namespace cg {

struct FaceBox {
  float low_s, low_t, high_s, high_t;
};

// The box of the part that lies on the face, of a convex polygon in the hemicube's frame; nothing where no part does.
std::optional<FaceBox> face_box(HemicubeFace face, const std::array<glm::vec3, 4>& corners);

}  // namespace cg
