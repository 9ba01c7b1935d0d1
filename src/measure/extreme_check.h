// What a picture of an extreme scene is compared with: the picture of an ordinary one, the slow reference, or a colour
// in closed form.
#pragma once
#include "measure/extreme.h"

namespace cg {

using Change = std::function<void(Scene&)>;

// The technique's own picture of `start` after `change`, an ordinary scene. The error is the largest difference of a
// channel where both cover the pixel, relative where it is over 1; 1 where more than 3 pixels at the edge differ.
PictureCheck same_as(std::function<Scene()> start, Change change);

// reference_colour() of every 7th covered pixel, of which there must be one, and the coverage of the software in
// double.
PictureCheck as_reference();

// Every covered pixel has the colour that `closed_form` gives for the scene before clamping, and some are covered.
PictureCheck colour_is(std::function<glm::dvec3(const Scene&)> closed_form);

// Nothing is seen.
PictureCheck nothing_covered();

// `fixed` for gl-fixed, `others` for the others.
PictureCheck by_technique(PictureCheck fixed, PictureCheck others);

// Both: the worse counts.
PictureCheck both_checks(PictureCheck a, PictureCheck b);

// How far two pictures are apart, as same_as.
ExtremeError frame_error(const Frame& frame, const Frame& right);

void apply(const ExtremeVariant& variant, Scene& scene);
Frame draw(const Technique& technique, const Scene& scene, const View& view, Progress& progress);

}  // namespace cg
