// Each knob on a small picture: its slope inside its band, or the reason why not; the same errors in every run.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <set>

#include "gl/techniques.h"
#include "measure/plot.h"
#include "measure/verdict.h"
#include "params/input_error.h"
#include "raster/software.h"
#include "workbench/model_library.h"

namespace cg {
namespace {

std::vector<Technique> techniques() {
  std::vector<Technique> all = gl_techniques();
  all.push_back(software_technique());
  return all;
}

Trade small_trade(std::string_view knob, const std::string& model, int size = 128, int repeats = 1) {
  Progress progress;
  TradeOptions options;
  options.repeats = repeats;
  options.width = options.height = size;
  const std::vector<Technique> all = techniques();
  return run_trade(find_knob(knob), model, open_model(model), all, options, progress);
}

bool both(Words w) { return !w.en.empty() && !w.ja.empty(); }
bool both(const Text& t) { return !t.en.empty() && !t.ja.empty(); }

TEST(KnobsTest, EachPredictsWithASourceAndSpeaksBothLanguages) {
  EXPECT_GE(knobs().size(), 8u);
  std::set<std::string_view> ids;
  for (const Knob& k : knobs()) {
    EXPECT_TRUE(ids.insert(k.id).second) << k.id;
    EXPECT_EQ(&find_knob(k.id), &k);
    for (const Words w : {k.name, k.help, k.abscissa.name, k.reference, k.error, k.bend_low, k.bend_high})
      EXPECT_TRUE(both(w)) << k.id << ": " << w.en;
    EXPECT_FALSE(k.parameter.empty()) << k.id;
    ASSERT_FALSE(k.predictions.empty()) << k.id;
    for (const Series& s : k.series) EXPECT_TRUE(both(s.name)) << k.id;
    for (const Prediction& p : k.predictions) {
      ASSERT_LT(p.series, k.series.size()) << k.id;
      EXPECT_TRUE(both(p.why)) << k.id;
      EXPECT_LE(p.band, 0.15) << k.id;
      EXPECT_NE(p.law.find(k.abscissa.letter), p.law.npos) << k.id;
      // Author, title, year.
      EXPECT_TRUE(p.source.find(", 1") != p.source.npos || p.source.find(", 2") != p.source.npos) << p.source;
    }
  }
}

TEST(KnobsTest, AnUnknownOneIsAnErrorThatListsThem) {
  try {
    find_knob("shadng");
    FAIL();
  } catch (const InputError& e) {
    for (const Knob& k : knobs()) EXPECT_NE(e.message(Language::japanese).find(k.id), std::string::npos);
  }
}

struct Expected {
  const char* knob;
  const char* model;
  int size;
};
class SlopeTest : public testing::TestWithParam<Expected> {};

TEST_P(SlopeTest, TheSlopeIsInItsBand) {
  const Trade trade = small_trade(GetParam().knob, GetParam().model, GetParam().size);
  for (const PredictionCheck& c : trade.checks) {
    const Prediction& p = trade.knob->predictions[c.prediction];
    ASSERT_TRUE(c.fit) << c.verdict.en;
    EXPECT_NEAR(c.fit->slope, p.order, p.band) << text_of(trade, Language::english);
    EXPECT_TRUE(c.agrees);
    EXPECT_GE(c.fit->points, 3u);
    EXPECT_TRUE(both(c.verdict));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Small, SlopeTest,
    testing::Values(Expected{"shading", "torus", 128}, Expected{"silhouette", "torus", 1024},
                    Expected{"normals", "torus-knot", 16}, Expected{"reflection", "uv-sphere", 256},
                    Expected{"supersampling", "torus-knot", 48}, Expected{"resolution", "torus-knot", 512},
                    Expected{"near-plane", "torus", 128}, Expected{"z-fighting", "torus", 256},
                    Expected{"radiosity-positions", "closed-cube.obj", 1},
                    Expected{"radiosity-method", "closed-cube.obj", 1},
                    Expected{"radiosity-solver", "closed-cube.obj", 1},
                    Expected{"radiosity-float", "closed-cube.obj", 1}, Expected{"radiosity-rays", "closed-cube.obj", 1},
                    Expected{"radiosity-residual", "closed-cube.obj", 1}),
    [](const auto& info) {
      std::string name = info.param.knob;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

// Borders are straight: R^(-3/2) in the root mean square of all angles, and at most of them nearly R^(-2).
TEST(KnobsTest, HemicubesResolutionCountsAsForStraightBorders) {
  const Trade trade = small_trade("radiosity-resolution", "closed-cube.obj", 1);
  ASSERT_EQ(trade.checks.size(), 2u);
  EXPECT_TRUE(trade.checks[0].agrees) << trade.checks[0].verdict.en;
  EXPECT_LT(trade.checks[1].fit->slope, -1.5 + trade.knob->predictions[1].band);
  EXPECT_GT(trade.checks[1].fit->slope, -2);
}

// The order comes nearer to 2 the smaller the patches are.
TEST(KnobsTest, PatchesComeNearTheirOrderSlowly) {
  const Trade trade = small_trade("radiosity-patches", "closed-cube.obj", 1);
  double last = 1.4;
  std::vector<double> x, error;
  for (std::size_t i = trade.points.size(); i-- > 0;) {
    x.push_back(trade.ladder.settings[i].x), error.push_back(trade.points[i].errors.rmse);
    const std::size_t n = x.size();
    if (n < 2) continue;
    const double order = std::log(error[n - 2] / error[n - 1]) / std::log(x[n - 2] / x[n - 1]);
    EXPECT_GT(order, last - 0.02) << x[n - 1];
    EXPECT_LT(order, 2.1) << x[n - 1];
    last = order;
  }
  EXPECT_GT(last, 1.65);
}

// The straight part of float's errors has the predicted order, and above n = 128 the curve bends, as the sine is taken.
TEST(KnobsTest, FloatBendsWhereTheSineIsTaken) {
  const Trade trade = small_trade("precision", "uv-sphere", 256);
  double at_128 = 0, at_2048 = 0;
  for (std::size_t i = 0; i < trade.points.size(); ++i) {
    if (trade.ladder.settings[i].x == 128) at_128 = trade.points[i].errors.max;
    if (trade.ladder.settings[i].x == 2048) at_2048 = trade.points[i].errors.max;
    EXPECT_LT(trade.points[i].errors.max, trade.ladder.settings[i].x * std::exp2(-20));
  }
  EXPECT_LT(at_2048, 4 * at_128) << "16 times would follow from n 2^-24";
}

TEST(KnobsTest, MultisamplingHasAsManyStepsAsTheDriverOffers) {
  try {
    const Trade trade = small_trade("multisampling", "torus", 32);
    ASSERT_GE(trade.points.size(), 1u);
    EXPECT_FALSE(trade.machine.renderer.empty());
    for (std::size_t i = 1; i < trade.points.size(); ++i)
      EXPECT_LE(trade.points[i].errors.rmse, trade.points[i - 1].errors.rmse);
    if (trade.points.size() > 1) {
      EXPECT_LT(trade.points.back().errors.rmse, trade.points.front().errors.rmse);
    }
  } catch (const InputError& e) {
    GTEST_SKIP() << e.message(Language::english);  // no OpenGL here
  }
}

TEST(KnobsTest, TwoRunsGiveTheSameErrorsBitForBit) {
  for (const char* knob : {"shading", "supersampling", "near-plane", "precision"}) {
    const Trade a = small_trade(knob, "torus", 48), b = small_trade(knob, "torus", 48, 2);
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i) {
      EXPECT_EQ(a.points[i].errors.rmse, b.points[i].errors.rmse) << knob;
      EXPECT_EQ(a.points[i].errors.max, b.points[i].errors.max) << knob;
      EXPECT_EQ(a.points[i].errors.samples, b.points[i].errors.samples) << knob;
    }
  }
}

TEST(KnobsTest, ASceneWithoutAShapeHasNoTessellation) {
  for (const char* knob : {"shading", "silhouette", "normals"}) try {
      small_trade(knob, "cornell-box.obj");
      FAIL() << knob;
    } catch (const InputError& e) {
      EXPECT_NE(e.message(Language::english).find("torus-knot"), std::string::npos);
    }
}

TEST(KnobsTest, ACancelledTradeStops) {
  Progress progress;
  progress.cancelled = true;
  const std::vector<Technique> all = techniques();
  EXPECT_THROW(run_trade(find_knob("near-plane"), "torus", open_model("torus"), all, {}, progress), Cancelled);
}

TEST(TradeTest, WhatIsWrittenReadsBack) {
  const Trade trade = small_trade("resolution", "torus", 128, 2);
  const Tree json = parse_json(to_json(json_of(trade)), "trade");
  const Tree::List& settings = *json.find("settings")->list();
  ASSERT_EQ(settings.size(), trade.points.size());
  for (std::size_t i = 0; i < settings.size(); ++i) {
    EXPECT_EQ(*settings[i].find("rmse")->number(), trade.points[i].errors.rmse);
    EXPECT_EQ(*settings[i].find("ms")->number(), trade.points[i].ms.median);
    EXPECT_EQ(*settings[i].find("x")->number(), trade.ladder.settings[i].x);
  }
  const std::string csv = csv_of(trade);
  EXPECT_EQ(std::size_t(std::count(csv.begin(), csv.end(), '\n')), trade.points.size() + 1);
  EXPECT_NE(csv.find("," + to_json(Tree(trade.points[1].errors.rmse), 0) + ","), std::string::npos);
  EXPECT_GT(trade.points[0].ms.median, 0);
  EXPECT_LE(trade.points[0].ms.low, trade.points[0].ms.median);
  EXPECT_LE(trade.points[0].ms.median, trade.points[0].ms.high);
}

TEST(TradeTest, RoundsGoOnUntilTheSecondsAreOver) {
  Progress progress;
  TradeOptions options;
  options.repeats = 2, options.seconds = 0.5;
  options.width = options.height = 16;
  const std::vector<Technique> all = techniques();
  const auto begin = std::chrono::steady_clock::now();
  const Trade trade = run_trade(find_knob("near-plane"), "plane", open_model("plane"), all, options, progress);
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(500));
  EXPECT_GE(trade.repeats, 2);
  EXPECT_FLOAT_EQ(progress.fraction, 1);
}

TEST(TradeTest, ASettingsSceneIsAPresetWithoutMeshes) {
  const Trade trade = small_trade("shading", "torus", 32);
  for (const Setting& s : trade.ladder.settings)
    for (const Object& object : s.scene.objects) EXPECT_FALSE(object.mesh);
  Scene taken = trade.ladder.settings.front().scene;
  load_meshes(taken);
  EXPECT_TRUE(taken.objects[0].mesh);
}

TEST(TradeTest, ThePlotsOfATradeAreWellFormed) {
  const Trade trade = small_trade("reflection", "uv-sphere", 96);
  for (const Language language : {Language::english, Language::japanese}) {
    const std::string svg = svg_of(trade, language);
    EXPECT_TRUE(svg.starts_with("<svg "));
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    const auto count = [&](std::string_view what) {
      std::size_t n = 0;
      for (std::size_t at = svg.find(what); at != svg.npos; at = svg.find(what, at + 1)) ++n;
      return n;
    };
    EXPECT_EQ(count("<text"), count("</text>"));
    EXPECT_EQ(count("<tspan"), count("</tspan>"));
    EXPECT_EQ(svg.find("nan"), svg.npos);
    EXPECT_EQ(svg.find('^'), svg.npos);
  }
}

TEST(VerdictTest, NumbersArePrintedShort) {
  EXPECT_EQ(short_number(0.0123456), "0.0123");
  EXPECT_EQ(short_number(0.3), "0.3");
  EXPECT_EQ(short_number(12345.0), "12300");
  EXPECT_EQ(short_number(-2.5e-7), "-2.5e-7");
  EXPECT_EQ(short_number(0), "0");
  EXPECT_EQ(power_text("h", 1.978), "h^1.98");
  EXPECT_EQ(power_text("n", -0.0001), "n^0");
}

}  // namespace
}  // namespace cg
