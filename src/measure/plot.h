// A plot as a plain description, and its layout as marks that anything can paint: an SVG file, a window. Axes are
// logarithmic unless they say otherwise.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "measure/trade.h"

namespace cg {

// What a mark is, for its painter to choose the colour.
enum class PlotInk {
  text,  // letters and points' labels
  dim,   // axes, ticks' labels, what is said less loudly
  grid,
  front,  // the Pareto front
  series0,
  series1,
  series2,
  series3,
  series4  // series by series, then from the first again
};

constexpr PlotInk ink_of_series(std::size_t series) { return PlotInk(int(PlotInk::series0) + int(series % 5)); }

struct PlotPoint {
  double x = 1, y = 1;           // > 0
  double x_low = 0, x_high = 0;  // the spread; 0: none
  double y_low = 0, y_high = 0;
  std::size_t series = 0;
  Text label = {};
  bool strong = true;     // on the front; else drawn open
  std::size_t index = 0;  // of Trade::points: what a click takes
};

struct PlotLine {
  std::vector<double> x, y;
  PlotInk ink = PlotInk::front;
  bool dashed = false;
  float weight = 1;  // of its thickness
};

struct PlotAxis {
  Text title;             // with its unit
  bool reversed = false;  // falls from left to right
  bool linear = false;    // and begins at 0
};

struct Plot {
  Text title;
  PlotAxis x, y;
  std::vector<PlotPoint> points;
  std::vector<PlotLine> lines;
  struct Entry {
    PlotInk ink;
    enum class Sign { none, dot, line, dashes } sign;
    Text text;
  };
  std::vector<Entry> legend;
};

// Error over time: the front, the spread of the repeats, each setting named; and error over the knob's abscissa: the
// fitted and the predicted slopes.
Plot speed_plot(const Trade& trade);
Plot convergence_plot(const Trade& trade);

struct PlotPlace {
  float x = 0, y = 0;
};

struct PlotMark {
  enum class Kind { line, dot, circle, text } kind = Kind::line;
  PlotInk ink = PlotInk::text;
  std::vector<PlotPlace> places;  // line: its corners; else one: the centre, or where the text begins, at its baseline
  float size = 1;                 // line: thickness; dot, circle: radius; text: of the letters, in pixels
  bool dashed = false;
  bool upright = false;  // text that reads upwards, turned a quarter to the left
  std::string text = {};
  int point = -1;  // index into Plot::points: what the mouse is over
};

struct PlotLayout {
  float width = 0, height = 0;
  std::vector<PlotMark> marks;      // in the order of painting
  float left, top, right, bottom;   // of the field between the axes
  std::size_t labels_left_out = 0;  // of points, for want of room
};

// The width of a text in letters of `size` pixels.
using TextWidth = std::function<float(const std::string& text, float size)>;
// Good to a tenth for the sans-serif faces of a browser.
float estimated_text_width(const std::string& text, float size);

// No two texts touch. `letters`: the size of the type in pixels.
PlotLayout lay_out(const Plot& plot, float width, float height, float letters, Language language,
                   const TextWidth& text_width = estimated_text_width);

// Which point lies under a place, if one does.
int point_at(const PlotLayout& layout, PlotPlace place);

// Both plots of a trade side by side, with the machine's name: a whole SVG file.
std::string svg_of(const Trade& trade, Language language);

}  // namespace cg
