// A plot's layout: title, legend and axes around a field, points and lines in it, and each point's label where nothing
// else is. The search for labels' places is the greedy one of Jon Christensen, Joe Marks and Stuart Shieber, An
// Empirical Study of Algorithms for Point-Feature Label Placement, 1995: eight places around the point, the preferred
// first.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "measure/plot.h"
#include "measure/plot_ticks.h"

namespace cg {

namespace {

struct Box {
  float left, top, right, bottom;
  bool meets(const Box& o) const { return left < o.right && o.left < right && top < o.bottom && o.top < bottom; }
  bool inside(const Box& o) const { return left >= o.left && right <= o.right && top >= o.top && bottom <= o.bottom; }
};

// Cohen and Sutherland's question: does the segment reach into the box?
bool crosses(const Box& box, PlotPlace a, PlotPlace b) {
  float enter = 0, leave = 1;
  const std::array<std::array<float, 2>, 4> sides{{{a.x - b.x, a.x - box.left},
                                                   {b.x - a.x, box.right - a.x},
                                                   {a.y - b.y, a.y - box.top},
                                                   {b.y - a.y, box.bottom - a.y}}};
  for (const auto& [p, q] : sides) {
    if (p == 0 && q < 0) return false;
    if (p < 0) enter = std::max(enter, q / p);
    if (p > 0) leave = std::min(leave, q / p);
  }
  return enter < leave;
}

struct Span {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  void add(double v) {
    if (v > 0 && std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  }
  // With room at both ends, and never narrower than a quarter of a decade.
  void widen(bool linear) {
    if (!(high > 0)) low = high = 1;
    if (linear) {
      high *= 1.07;
      return;
    }
    const double decades = std::log10(high / low), room = std::max(0.07 * decades, (0.25 - decades) / 2);
    low *= std::pow(10, -room), high *= std::pow(10, room);
  }
};

class Layouter {
 public:
  Layouter(const Plot& plot, float width, float height, float letters, Language language, const TextWidth& text_width)
      : plot_(plot), letters_(letters), small_(letters * 0.85f), language_(language), text_width_(text_width) {
    out_.width = width, out_.height = height;
  }

  PlotLayout lay_out() {
    find_spans();
    const auto ticks = [](const Span& s, bool linear) {
      return linear ? even_ticks(0, s.high) : log_ticks(s.low, s.high);
    };
    const std::vector<PlotTick> x_ticks = ticks(x_, plot_.x.linear), y_ticks = ticks(y_, plot_.y.linear);
    float widest = 0;
    for (const PlotTick& t : y_ticks) widest = std::max(widest, wide(t.text, small_));
    out_.left = 1.9f * letters_ + widest + 0.6f * letters_;
    out_.right = out_.width - 1.4f * letters_;
    out_.bottom = out_.height - 3.4f * letters_;
    add_head();
    add_axes(x_ticks, y_ticks);
    add_lines();
    add_points();
    add_labels();
    return std::move(out_);
  }

 private:
  float wide(const std::string& text, float size) const { return text_width_(text, size); }
  static float along(const Span& span, bool linear, double v) {
    return linear ? float(v / span.high) : float(std::log10(v / span.low) / std::log10(span.high / span.low));
  }
  float x_at(double v) const { return out_.left + along(x_, plot_.x.linear, v) * (out_.right - out_.left); }
  float y_at(double v) const { return out_.bottom - along(y_, plot_.y.linear, v) * (out_.bottom - out_.top); }
  void line(PlotInk ink, std::vector<PlotPlace> places, float thickness, bool dashed = false) {
    out_.marks.push_back(
        {.kind = PlotMark::Kind::line, .ink = ink, .places = std::move(places), .size = thickness, .dashed = dashed});
  }
  void text(PlotInk ink, const std::string& what, PlotPlace at, float size, bool upright = false) {
    out_.marks.push_back(
        {.kind = PlotMark::Kind::text, .ink = ink, .places = {at}, .size = size, .upright = upright, .text = what});
  }

  void find_spans() {
    for (const PlotPoint& p : plot_.points) {
      for (const double v : {p.x, p.x_low, p.x_high}) x_.add(v);
      for (const double v : {p.y, p.y_low, p.y_high}) y_.add(v);
    }
    for (const PlotLine& l : plot_.lines) {
      for (const double v : l.x) x_.add(v);
      for (const double v : l.y) y_.add(v);
    }
    x_.widen(plot_.x.linear), y_.widen(plot_.y.linear);
  }

  bool is_small() const { return out_.right - out_.left < 18 * letters_; }

  // As much of it as `room` holds, cut between characters (UTF-8).
  std::string shortened(std::string what, float room) const {
    if (wide(what, small_) <= room) return what;
    while (!what.empty() && wide(what + "…", small_) > room) {
      while (!what.empty() && (static_cast<unsigned char>(what.back()) & 0xc0) == 0x80) what.pop_back();
      if (!what.empty()) what.pop_back();
    }
    return what + "…";
  }

  // The title, and under it the legend in as many rows as it needs.
  void add_head() {
    float y = 1.2f * letters_;
    text(PlotInk::text, plot_.title.in(language_), {out_.left, y}, letters_);
    const float begin = is_small() ? 0.3f * letters_ : out_.left;
    float x = begin;
    y += 1.6f * letters_;
    for (const Plot::Entry& entry : plot_.legend) {
      const float sign_room = 1.6f * letters_;
      const std::string what = shortened(entry.text.in(language_), out_.right - begin - sign_room);
      const float sign = entry.sign == Plot::Entry::Sign::none ? 0 : sign_room, length = sign + wide(what, small_);
      if (x > begin && x + length > out_.right) x = begin, y += 1.35f * letters_;
      const float middle = y - 0.3f * letters_;
      if (entry.sign == Plot::Entry::Sign::dot)
        out_.marks.push_back({.kind = PlotMark::Kind::dot,
                              .ink = entry.ink,
                              .places = {{x + 0.6f * letters_, middle}},
                              .size = 0.28f * letters_});
      else if (entry.sign != Plot::Entry::Sign::none)
        line(entry.ink, {{x, middle}, {x + 1.2f * letters_, middle}}, 0.12f * letters_,
             entry.sign == Plot::Entry::Sign::dashes);
      text(sign > 0 ? PlotInk::text : PlotInk::dim, what, {x + sign, y}, small_);
      x += length + 1.4f * letters_;
    }
    out_.top = y + 0.9f * letters_;
  }

  void add_axes(const std::vector<PlotTick>& x_ticks, const std::vector<PlotTick>& y_ticks) {
    float free_from = -1e9f;  // numbers that would touch are left out
    for (const PlotTick& t : x_ticks) {
      const float x = x_at(t.value), w = wide(t.text, small_);
      line(PlotInk::grid, {{x, out_.top}, {x, out_.bottom}}, 1);
      if (x - w / 2 < free_from) continue;
      free_from = x + w / 2 + 0.5f * letters_;
      text(PlotInk::dim, t.text, {x - w / 2, out_.bottom + 1.15f * letters_}, small_);
    }
    float free_below = 1e9f;
    for (const PlotTick& t : y_ticks) {
      const float y = y_at(t.value);
      line(PlotInk::grid, {{out_.left, y}, {out_.right, y}}, 1);
      if (y + 0.5f * small_ > free_below) continue;
      free_below = y - 0.7f * small_;
      text(PlotInk::dim, t.text, {out_.left - 0.45f * letters_ - wide(t.text, small_), y + 0.33f * small_}, small_);
    }
    line(PlotInk::dim, {{out_.left, out_.top}, {out_.left, out_.bottom}, {out_.right, out_.bottom}}, 1);
    const std::string &x = plot_.x.title.in(language_), &y = plot_.y.title.in(language_);
    text(PlotInk::text, x, {centred(x, out_.left, out_.right), out_.height - 0.7f * letters_}, small_);
    const float room = out_.bottom, size = std::min(small_, small_ * room / std::max(wide(y, small_), 1.0f));
    const float middle = std::min((out_.top + out_.bottom + wide(y, size)) / 2, out_.height - 0.5f * letters_);
    text(PlotInk::text, y, {1.1f * letters_, middle}, size, true);
  }
  float centred(const std::string& what, float low, float high) const {
    return std::max(std::min((low + high - wide(what, small_)) / 2, out_.width - wide(what, small_)), 0.0f);
  }

  void add_lines() {
    for (const PlotLine& l : plot_.lines) {
      std::vector<PlotPlace> places;
      for (std::size_t i = 0; i < l.x.size(); ++i) places.push_back({x_at(l.x[i]), y_at(l.y[i])});
      for (std::size_t i = 1; i < places.size(); ++i) segments_.push_back({places[i - 1], places[i]});
      if (places.size() > 1) line(l.ink, std::move(places), l.weight * (l.dashed ? 1.2f : 1.6f), l.dashed);
    }
  }

  void add_points() {
    const float radius = 0.3f * letters_;
    for (std::size_t i = 0; i < plot_.points.size(); ++i) {
      const PlotPoint& p = plot_.points[i];
      const PlotInk ink = ink_of_series(p.series);
      const PlotPlace at{x_at(p.x), y_at(p.y)};
      Box taken{at.x - radius, at.y - radius, at.x + radius, at.y + radius};
      if (p.x_low > 0 && p.x_high > p.x_low) {
        const float low = x_at(p.x_low), high = x_at(p.x_high);
        line(ink, {{low, at.y}, {high, at.y}}, 1);
        taken.left = std::min(taken.left, low), taken.right = std::max(taken.right, high);
      }
      if (p.y_low > 0 && p.y_high > p.y_low) line(ink, {{at.x, y_at(p.y_low)}, {at.x, y_at(p.y_high)}}, 1);
      out_.marks.push_back({.kind = p.strong ? PlotMark::Kind::dot : PlotMark::Kind::circle,
                            .ink = ink,
                            .places = {at},
                            .size = radius,
                            .point = int(i)});
      taken_.push_back(taken);
    }
  }

  // The places around a point, the preferred first: right, left, above, below, then the corners.
  std::array<Box, 8> places_around(PlotPlace at, float w, float h, float away) const {
    const float r = at.x + away, l = at.x - away - w, a = at.y - away - h, b = at.y + away, cx = at.x - w / 2,
                cy = at.y - h / 2, d = 0.75f * away, x1 = at.x + d, x2 = at.x - d - w, y1 = at.y - d - h, y2 = at.y + d;
    const auto box = [&](float x, float y) { return Box{x, y, x + w, y + h}; };
    return {box(r, cy), box(l, cy), box(cx, a), box(cx, b), box(x1, y1), box(x2, y2), box(x2, y1), box(x1, y2)};
  }

  bool is_free(const Box& box, bool lines_count) const {
    if (!box.inside({out_.left, out_.top, out_.right, out_.bottom})) return false;
    for (const Box& b : taken_)
      if (box.meets(b)) return false;
    if (lines_count)
      for (const auto& [a, b] : segments_)
        if (crosses(box, a, b)) return false;
    return true;
  }

  // First beside the point and clear of the lines, then across a line, then farther off with a thin line to the point.
  void add_label(const std::string& what, std::size_t index) {
    const PlotPlace at{x_at(plot_.points[index].x), y_at(plot_.points[index].y)};
    const float w = wide(what, small_), h = 0.9f * small_, near = 0.5f * letters_;
    struct Try {
      float away;
      bool lines_count;
    };
    for (const Try t : {Try{near, true}, Try{near, false}, Try{2 * near, true}, Try{3.2f * near, false},
                        Try{5 * near, false}, Try{7 * near, false}})
      for (const Box& box : places_around(at, w, h, t.away)) {
        if (!is_free(box, t.lines_count)) continue;
        if (t.away > near)
          line(PlotInk::dim, {at, {std::clamp(at.x, box.left, box.right), std::clamp(at.y, box.top, box.bottom)}},
               0.7f);
        text(PlotInk::text, what, {box.left, box.bottom - 0.1f * small_}, small_);
        taken_.push_back(box);
        return;
      }
    ++out_.labels_left_out;
  }

  // The front's first; a small field has room for no others, which the mouse asks about.
  void add_labels() {
    for (const bool strong : {true, false})
      for (std::size_t i = 0; i < plot_.points.size(); ++i)
        if (const std::string& what = plot_.points[i].label.in(language_);
            !what.empty() && plot_.points[i].strong == strong) {
          if (strong || !is_small())
            add_label(what, i);
          else
            ++out_.labels_left_out;
        }
  }

  const Plot& plot_;
  const float letters_, small_;
  const Language language_;
  const TextWidth& text_width_;
  Span x_, y_;
  PlotLayout out_;
  std::vector<Box> taken_;  // by points and labels
  std::vector<std::pair<PlotPlace, PlotPlace>> segments_;
};

}  // namespace

float estimated_text_width(const std::string& text, float size) {
  float ems = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned char c = static_cast<unsigned char>(text[i]);
    if ((c & 0xc0) == 0x80) continue;  // a point's later bytes
    if (c >= 0xe0)
      ems += 1;  // Japanese, mostly
    else if (c == ' ' || c == '.' || c == ',' || c == ':' || c == 'i' || c == 'l' || c == '^')
      ems += 0.3f;
    else
      ems += c >= 'A' && c <= 'Z' ? 0.68f : c == 'm' || c == 'w' ? 0.85f : 0.58f;
  }
  return ems * size;
}

PlotLayout lay_out(const Plot& plot, float width, float height, float letters, Language language,
                   const TextWidth& text_width) {
  return Layouter(plot, width, height, letters, language, text_width).lay_out();
}

int point_at(const PlotLayout& layout, PlotPlace place) {
  int best = -1;
  float nearest = std::numeric_limits<float>::infinity();
  for (const PlotMark& m : layout.marks) {
    if (m.point < 0) continue;
    const float away = std::hypot(place.x - m.places[0].x, place.y - m.places[0].y);
    if (away <= 2 * m.size && away < nearest) nearest = away, best = m.point;
  }
  return best;
}

}  // namespace cg
