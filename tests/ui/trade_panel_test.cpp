// The panel of trades: measured in the background, stopped, its points asked about and taken.
#include <atomic>
#include <thread>

#include "params/file.h"
#include "raster/software.h"
#include "tests/temporary_folder.h"
#include "tests/ui/imgui_fixture.h"
#include "ui/layout.h"
#include "ui/plot_view.h"
#include "ui/trade_desk.h"
#include "workbench/open.h"

namespace cg {
namespace {

// Three shininesses against a fourth, small and quick.
Ladder shininesses(const TradeRequest& request) {
  Ladder ladder;
  for (const double n : {8.0, 16.0, 32.0, 64.0}) {
    Setting s;
    s.id = "n-" + std::to_string(int(n));
    s.label = Text(std::to_string(int(n)), std::to_string(int(n)));
    s.x = n;
    s.scene = request.scene;
    s.scene.material.n = n;
    s.technique = "software";
    s.view.width = s.view.height = 32;
    (n < 64 ? ladder.settings : ladder.references).push_back(std::move(s));
  }
  return ladder;
}

class TradePanel : public ImGuiTest {
 protected:
  TradePanel() : knob(knobs().front()) {
    app.techniques = {software_technique()};
    app.settings.side = Side::trade;
    app.settings.knob = std::string(knob.id);
    app.scene = open_scene("cube");
    app.history.restart(app.scene);
    // In place of the knob of that name, so that the panel shows it.
    knob.ladder = shininesses;
    knob.draw = nullptr, knob.errors = nullptr;
    knob.series = {{"one", {"One", "一"}}};
    knob.predictions.clear();
  }
  std::shared_ptr<const MeasuredTrade> measure() {
    trades_of(app).measure(app, knob);
    wait([&] { return !trades_of(app).running(); });
    return trades_of(app).of(knob);
  }
  template <class Holds>
  void wait(Holds holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!holds() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    ASSERT_TRUE(holds());
  }

  Knob knob;
};

TEST_F(TradePanel, MeasuresTheSceneThatStands) {
  const auto measured = measure();
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->trade.points.size(), 3u);
  EXPECT_EQ(measured->paths, std::vector<std::string>{"material.n"});
  EXPECT_GT(measured->trade.points[0].errors.rmse, measured->trade.points[2].errors.rmse);
  EXPECT_FALSE(trades_of(app).problem(knob));
}

TEST_F(TradePanel, APointIsTakenAsOneStepOfUndoAndTheRestOfTheSceneStays) {
  const auto measured = measure();
  ASSERT_TRUE(measured);
  app.scene.camera.position = {4, 3, 2};  // since it was measured
  app.scene.material.n = 5;
  window_frame();
  const Scene before = app.scene;
  take_setting(app, *measured, 1);
  window_frame();
  EXPECT_EQ(app.scene.material.n, 16);
  EXPECT_EQ(app.scene.camera, before.camera);
  EXPECT_EQ(app.history.undo(), before);
  EXPECT_EQ(app.techniques[std::size_t(app.left)].id, "software");
}

TEST_F(TradePanel, ThePicturesOfAPointComeWithItsDifference) {
  const auto measured = measure();
  ASSERT_TRUE(measured);
  std::shared_ptr<const SettingPicture> picture;
  wait([&] { return (picture = trades_of(app).picture(app, knob, 2)) != nullptr; });
  EXPECT_EQ(picture->shown.width(), 32);
  EXPECT_EQ(picture->difference.width(), 32);
  EXPECT_GE(picture->gain, 1);
}

TEST_F(TradePanel, EachPointIsUnderTheMouseWhereItIsPainted) {
  const auto measured = measure();
  ASSERT_TRUE(measured);
  PlotView view;
  PlotMouse mouse;
  ImVec2 origin;
  const auto draw = [&] {
    origin = ImGui::GetCursorScreenPos();
    mouse = draw_plot(app, view, "plot", measured->speed, {600, 400}, -1);
  };
  frame(draw);
  int seen = 0;
  for (const PlotMark& mark : std::vector<PlotMark>(view.layout.marks)) {
    if (mark.point < 0 || mark.kind == PlotMark::Kind::line || mark.kind == PlotMark::Kind::text) continue;
    ImGui::GetIO().MousePos = {origin.x + mark.places[0].x, origin.y + mark.places[0].y - view.head};
    frame(draw), frame(draw);
    EXPECT_EQ(mouse.hovered, mark.point);
    ImGui::GetIO().MouseDown[0] = true;
    frame(draw);
    ImGui::GetIO().MouseDown[0] = false;
    frame(draw);
    EXPECT_TRUE(mouse.clicked);
    ++seen;
  }
  EXPECT_EQ(seen, 3);
}

TEST_F(TradePanel, TheLargePlotStandsInPlaceOfThePictures) {
  ASSERT_TRUE(measure());
  TradeDesk& desk = trades_of(app);
  bool drawn = false;
  ImVec2 origin, size{600, 400};
  const auto draw = [&] {
    origin = ImGui::GetCursorScreenPos();
    drawn = draw_large_trade(app, size);
  };
  frame(draw);
  EXPECT_FALSE(drawn);  // not asked for
  desk.large = true;
  frame(draw);
  EXPECT_TRUE(drawn);
  EXPECT_EQ(desk.pointed, -1);
  for (const PlotMark& mark : std::vector<PlotMark>(desk.speed_view.layout.marks)) {
    if (mark.point < 0 || mark.kind == PlotMark::Kind::line || mark.kind == PlotMark::Kind::text) continue;
    ImGui::GetIO().MousePos = {origin.x + mark.places[0].x, origin.y + mark.places[0].y - desk.speed_view.head};
    frame(draw), frame(draw);
    EXPECT_EQ(desk.pointed, int(desk.speed_view.plot->points[std::size_t(mark.point)].index));
  }
  size = {90, 90};  // no room: the pictures stay
  frame(draw);
  EXPECT_FALSE(drawn);
  size = {600, 400};
  app.settings.side = Side::plan;
  frame(draw);
  EXPECT_FALSE(drawn);
  EXPECT_EQ(desk.pointed, -1);
}

TEST_F(TradePanel, IsDrawnInEverySizeAndBothLanguages) {
  for (const bool measured : {false, true}) {
    if (measured) {
      ASSERT_TRUE(measure());
    }
    for (const bool time : {true, false})
      for (const Language language : {Language::english, Language::japanese})
        for (const ImVec2 size : {ImVec2{320, 240}, {1280, 720}, {3840, 2160}}) {
          trades_of(app).against_time = time;
          app.settings.language = language;
          ImGui::GetIO().DisplaySize = size;
          window_frame(), window_frame();
        }
  }
}

std::atomic<int> drawings{0};

// Draws without end, until it is told to stop.
Technique endless() {
  Technique t = software_technique();
  t.id = "endless";
  t.render = [](const Scene&, const Plan&, const View&, Progress& progress) -> Frame {
    ++drawings;
    while (!progress.cancelled) std::this_thread::yield();
    throw Cancelled{};
  };
  return t;
}

Ladder endless_ladder(const TradeRequest& request) {
  Ladder ladder = shininesses(request);
  ladder.references[0].technique = "endless";
  return ladder;
}

TEST_F(TradePanel, IsStoppedByTheButtonByAnotherSceneAndByTheWindowsEnd) {
  app.techniques.push_back(endless());
  knob.ladder = endless_ladder;
  const auto begin = [&] {
    drawings = 0;
    trades_of(app).measure(app, knob);
    wait([&] { return drawings > 0; });
    ASSERT_TRUE(trades_of(app).running());
  };
  begin();
  trades_of(app).stop();
  EXPECT_FALSE(trades_of(app).running());
  begin();
  open_in_window(app, "torus");
  while (app.errands->busy()) std::this_thread::yield();
  app.errands->finish(app);
  EXPECT_EQ(app.scene.objects[0].model, "torus");
  EXPECT_FALSE(trades_of(app).running());
  begin();
  app.trades.reset();  // waits for its thread
  EXPECT_FALSE(trades_of(app).of(knob));
}

Ladder refusing(const TradeRequest&) { throw InputError("cube", {"has no curve", "曲面がない"}); }

TEST_F(TradePanel, SaysWhyItCannotMeasure) {
  knob.ladder = refusing;
  EXPECT_FALSE(measure());
  ASSERT_TRUE(trades_of(app).problem(knob));
  EXPECT_NE(trades_of(app).problem(knob)->en.find("has no curve"), std::string::npos);
  window_frame();
}

TEST_F(TradePanel, IsSavedAsEachFormat) {
  const auto measured = measure();
  ASSERT_TRUE(measured);
  const TemporaryFolder folder;
  int format = 0;
  for (const char* name : {"trade.csv", "trade.json", "trade.svg"}) {
    app.dialogue = {Dialogue::trade, (folder / name).string(), true, format++, std::string(knob.id)};
    window_frame(), window_frame();
    ImGui::GetIO().KeysDown[GLFW_KEY_ENTER] = true;
    window_frame();
    ImGui::GetIO().KeysDown[GLFW_KEY_ENTER] = false;
    window_frame();
    while (app.errands->busy()) std::this_thread::yield();
    EXPECT_EQ(app.dialogue.kind, Dialogue::none);
  }
  EXPECT_EQ(read_file(folder / "trade.csv"), csv_of(measured->trade));
  EXPECT_EQ(read_file(folder / "trade.json"), to_json(json_of(measured->trade), 1) + "\n");
  EXPECT_EQ(read_file(folder / "trade.svg"), svg_of(measured->trade, Language::english));
}

}  // namespace
}  // namespace cg
