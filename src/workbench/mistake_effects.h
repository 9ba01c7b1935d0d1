// What a mistake made on purpose does to this scene, as a number.
#pragma once
#include <optional>

#include "scene/frame.h"
#include "scene/scene.h"

namespace cg {

struct MistakeEffect {
  bool shows = true;  // false: the scene hides it, and `text` says what would show it
  double value = 0;   // the number, in the unit that the table below gives; as if nothing were hidden
  Text text;          // a sentence or two with the number
};

// `mistake` is the name of a member of Mistakes; nothing for another name. Whether the mistake is switched on makes no
// difference, and neither do the scene's other mistakes. The numbers:
//   light_before_view   angle between the light as drawn and as meant, seen from the camera's target, degrees
//   directional_w       largest angle between L as drawn and as meant at the corners of the objects' boxes, degrees
//   no_normalize        length of the normals in eye coordinates, the one farthest from 1
//   no_color_material   largest difference of a reflectance as drawn and as meant
//   flipped_normals     share of the vertices with N·L > 0, by mistake, 0..1
//   no_normals          N·L of the normal (0, 0, 1), in the middle of the first object
//   no_gate             largest highlight (the term, one channel) at a vertex that faces the eye, not the light
//   long_light_vector   length of L in the middle of the first object, metres
//   no_depth_test       share of the covered pixels that show what is hidden, 0..1
//   swapped_front_face  share of the triangles in the picture that are front faces, 0..1
// Angles and lengths are those of the light that has the largest; the other numbers with L are of the first light.
// Looks at every vertex, so up to 100 ms for a million of them. Pixels are counted in a picture of `view`'s size.
// Meshes are loaded.
std::optional<MistakeEffect> mistake_effect(const Scene& scene, std::string_view mistake, const View& view);

}  // namespace cg
