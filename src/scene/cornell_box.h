// The Cornell box as it was measured: Cornell University Program of Computer Graphics, Cornell Box Data,
// https://www.graphics.cornell.edu/online/box/data.html; the box of Cohen and Greenberg, The Hemi-Cube, 1985.
#pragma once
#include <vector>

#include "scene/bundled_scene.h"

namespace cg {

// Parts: floor, ceiling, back-wall, left-wall, right-wall, short-block, tall-block, light; the open side towards +z,
// normals into the box and out of the blocks.
std::vector<BundledPart> cornell_parts();

// White, red and green from the published spectra (400 to 700 nm, 4 nm): the reflectance of a channel is the mean of
// the spectrum, weighted by the channel's matching function under light of equal energy, so that a perfect white has
// (1, 1, 1). The matching functions are those of linear sRGB (IEC 61966-2-1) from the CIE 1931 observer in the form of
// Wyman, Sloan and Shirley, Simple Analytic Approximations to the CIE XYZ Color Matching Functions, 2013. The light's
// emission is the same mean of its spectrum, in its unit; its reflectance is the published 0.78. Rounded to three
// decimals.
std::vector<BundledMaterial> cornell_materials();

}  // namespace cg
