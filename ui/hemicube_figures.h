// The numbers of the panel of the hemicube.
#pragma once
#include "ui/hemicube_cross.h"

namespace cg {

struct App;

// How much smaller a text is written that is too wide for its room: down to what is read well.
float fitting_scale(ImFont* font, std::string_view text, float room);
// In about so many characters: "7.77e-5".
std::string short_number(double v, std::size_t room);
// From here on a miss, relative, is told in the colour of errors.
inline constexpr double told_miss = 0.02;
// "+0.42 %"; empty where there is nothing to compare with.
std::string miss_text(double value, double exact);

// What the pixel under the mouse counts, and what its patch's pixels add up to. As high whatever it says.
void draw_pixel_lines(App& app, const HemicubeDesk& desk, const PointedPixel& pixel);
// F_ij of the two, beside the closed form; the row's sum; the reciprocity.
void draw_pair(App& app, const HemicubeDesk& desk);
// Each way to weigh pixels, and by how much it misses; a click makes it the scene's.
void draw_weights(App& app, const HemicubeDesk& desk);
// The row, largest first.
void draw_row_bars(App& app, HemicubeDesk& desk);

}  // namespace cg
