#include "measure/plot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measure/plot_ticks.h"

namespace cg {
namespace {

struct Rectangle {
  float left, top, right, bottom;
};

// A text's place on the page, with letters as high as their size.
Rectangle place_of(const PlotMark& m) {
  const float w = estimated_text_width(m.text, m.size), x = m.places[0].x, y = m.places[0].y;
  if (m.upright) return {x - 0.75f * m.size, y - w, x + 0.2f * m.size, y};
  return {x, y - 0.7f * m.size, x + w, y};
}

bool touch(const Rectangle& a, const Rectangle& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

void expect_no_texts_touch(const PlotLayout& layout) {
  std::vector<const PlotMark*> texts;
  for (const PlotMark& m : layout.marks)
    if (m.kind == PlotMark::Kind::text) texts.push_back(&m);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Rectangle a = place_of(*texts[i]);
    EXPECT_GE(a.left, -1) << texts[i]->text;
    EXPECT_LE(a.right, layout.width + 1) << texts[i]->text;
    EXPECT_GE(a.top, -1) << texts[i]->text;
    EXPECT_LE(a.bottom, layout.height + 1) << texts[i]->text;
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(touch(a, place_of(*texts[k]))) << texts[i]->text << " and " << texts[k]->text;
  }
}

Plot plot_with(int points, double crowding) {
  Plot plot;
  plot.title = {"Error over time", "時間と誤差"};
  plot.x.title = {"CPU time a picture [ms]", "1 枚の CPU 時間 [ms]"};
  plot.y.title = {"RMSE of linear colour over the pixels that both cover", "両方が覆う画素での線形な色の RMSE"};
  for (int i = 0; i < points; ++i) {
    PlotPoint p{.x = 10 * std::pow(1 + crowding, i), .y = 1e-2 * std::pow(1 + crowding, -(i % 7))};
    p.x_low = 0.97 * p.x, p.x_high = 1.04 * p.x;
    p.label = {std::to_string(i * i), std::to_string(i * i)};
    p.series = std::size_t(i % 3);
    p.index = std::size_t(i);
    plot.points.push_back(p);
  }
  for (const PlotInk ink : {PlotInk::series0, PlotInk::series1, PlotInk::series2})
    plot.legend.push_back(
        {ink, Plot::Entry::Sign::line, {"Gouraud: h^1.98, predicted h^2", "グロー：h^1.98、予測 h^2"}});
  return plot;
}

TEST(PlotTest, NoTextsTouchAtAnySizeOrCrowding) {
  for (const double crowding : {0.6, 0.1, 0.02})
    for (const auto& [width, height] : {std::pair(640.f, 480.f), {360.f, 300.f}, {1200.f, 700.f}})
      for (const Language language : {Language::english, Language::japanese})
        expect_no_texts_touch(lay_out(plot_with(24, crowding), width, height, 15, language));
}

TEST(PlotTest, EveryLabelHasAPlaceWhereThereIsRoom) {
  EXPECT_EQ(lay_out(plot_with(24, 0.3), 640, 480, 15, Language::english).labels_left_out, 0u);
}

TEST(PlotTest, PointsStandWhereTheirLogarithmsSay) {
  Plot plot;
  for (const double v : {1.0, 10.0, 100.0}) plot.points.push_back({.x = v, .y = 1 / v});
  const PlotLayout layout = lay_out(plot, 600, 400, 15, Language::english);
  std::vector<PlotPlace> places;
  for (const PlotMark& m : layout.marks)
    if (m.point >= 0) places.push_back(m.places[0]);
  ASSERT_EQ(places.size(), 3u);
  EXPECT_NEAR(places[1].x - places[0].x, places[2].x - places[1].x, 0.01);
  EXPECT_NEAR(places[1].y - places[0].y, places[2].y - places[1].y, 0.01);
  EXPECT_LT(places[0].x, places[1].x);
  EXPECT_LT(places[0].y, places[1].y);  // a smaller error stands lower
  EXPECT_GT(places[0].x, layout.left);
  EXPECT_LT(places[2].y, layout.bottom);
}

TEST(PlotTest, TheMouseFindsTheNearestPoint) {
  const Plot plot = plot_with(5, 0.6);
  const PlotLayout layout = lay_out(plot, 640, 480, 15, Language::english);
  for (const PlotMark& m : layout.marks)
    if (m.point >= 0) {
      EXPECT_EQ(point_at(layout, {m.places[0].x + 1, m.places[0].y - 1}), m.point);
    }
  EXPECT_EQ(point_at(layout, {1, 1}), -1);
}

TEST(PlotTest, NothingAndOnePointAreLaidOutToo) {
  expect_no_texts_touch(lay_out(Plot{}, 640, 480, 15, Language::english));
  expect_no_texts_touch(lay_out(plot_with(1, 0.5), 640, 480, 15, Language::japanese));
}

TEST(TicksTest, TwoToNineInsideTheRange) {
  for (double low : {1e-7, 3e-3, 0.9, 12.0, 4e4})
    for (double ratio : {1.2, 1.8, 4.0, 30.0, 1e4, 1e8, 1e12}) {
      const auto ticks = log_ticks(low, low * ratio);
      EXPECT_GE(ticks.size(), 2u) << low << " " << ratio;
      EXPECT_LE(ticks.size(), 12u) << low << " " << ratio;
      for (const PlotTick& t : ticks) {
        EXPECT_GE(t.value, low * (1 - 1e-6));
        EXPECT_LE(t.value, low * ratio * (1 + 1e-6));
        EXPECT_FALSE(t.text.empty());
      }
    }
}

TEST(TicksTest, NumbersAsPeopleWriteThem) {
  const auto ticks = log_ticks(0.5e-5, 20);
  ASSERT_EQ(ticks.size(), 7u);
  EXPECT_EQ(ticks[0].text, "10^-5");
  EXPECT_EQ(ticks[2].text, "0.001");
  EXPECT_EQ(ticks[6].text, "10");
}

}  // namespace
}  // namespace cg
