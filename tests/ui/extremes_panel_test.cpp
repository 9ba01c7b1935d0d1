// The panel of extremes: a case is applied with a click, checked in the background, and every one of them is drawn.
#include <algorithm>
#include <thread>

#include "raster/software.h"
#include "tests/ui/imgui_fixture.h"
#include "ui/extremes_desk.h"
#include "ui/verdict_mark.h"
#include "workbench/open.h"

namespace cg {
namespace {

class ExtremesPanel : public ImGuiTest {
 protected:
  ExtremesPanel() {
    app.techniques = {software_technique()};
    app.settings.side = Side::extremes;
    app.scene = open_scene("cube");
    app.history.restart(app.scene);
  }
  template <class Holds>
  void wait(Holds holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!holds() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    ASSERT_TRUE(holds());
  }
  void finish_errands() {
    while (app.errands->busy()) std::this_thread::yield();
    app.errands->finish(app);
  }
  static const ExtremeCase& first_with(bool (*has)(const ExtremeCase&)) {
    const auto cases = extreme_cases();
    return *std::find_if(cases.begin(), cases.end(), has);
  }
};

bool draws(const ExtremeCase& c) { return c.scene.has_value() && !c.driver_fault; }

TEST_F(ExtremesPanel, ACaseIsAppliedAsOneStepOfUndo) {
  const Scene before = app.scene;
  const ExtremeCase& subject = first_with(draws);
  extremes_of(app).apply(app, subject);
  finish_errands();
  window_frame();
  EXPECT_NE(app.scene, before);
  EXPECT_FALSE(app.scene.objects.empty());
  EXPECT_EQ(app.history.undo(), before);
}

TEST_F(ExtremesPanel, TheSessionKeepsASceneThatCanBeOpenedAgain) {
  const Scene before = app.scene;
  for (const ExtremeCase& subject : extreme_cases()) {
    if (!subject.scene) continue;
    extremes_of(app).apply(app, subject);
    finish_errands();
    if (can_be_kept(app.scene)) continue;
    ASSERT_TRUE(extremes_of(app).before);
    EXPECT_TRUE(can_be_kept(*extremes_of(app).before)) << subject.id;
    return;
  }
}

TEST_F(ExtremesPanel, ACaseIsCheckedWithEachTechniqueThereIs) {
  const ExtremeCase& subject = first_with(draws);
  EXPECT_FALSE(extremes_of(app).verdict(subject));
  extremes_of(app).check(app, subject);
  wait([&] { return extremes_of(app).verdict(subject).has_value(); });
  EXPECT_EQ(extremes_of(app).verdict(subject), Verdict::right);
  EXPECT_FALSE(extremes_of(app).of(subject).empty());
}

TEST_F(ExtremesPanel, AllAreCheckedUntilItIsStopped) {
  ExtremesDesk& desk = extremes_of(app);
  desk.check_all(app);
  EXPECT_TRUE(desk.checking_all());
  wait([&] { return desk.fraction() > 0; });
  desk.stop();
  EXPECT_FALSE(desk.checking_all());
  const float reached = desk.fraction();
  EXPECT_GT(reached, 0);
  desk.check_all(app);  // goes on
  wait([&] { return desk.fraction() > reached || !desk.checking_all(); });
}

TEST_F(ExtremesPanel, EveryCaseIsDrawnInBothLanguages) {
  for (const ExtremeCase& subject : extreme_cases()) {
    app.settings.extreme = subject.id;
    if (subject.naive) wait([&] { return extremes_of(app).rows(subject) != nullptr; });
    for (const Language language : {Language::english, Language::japanese}) {
      app.settings.language = language;
      EXPECT_FALSE(subject.name.in(language).empty()) << subject.id;
      EXPECT_FALSE(subject.right.in(language).empty()) << subject.id;
      window_frame();
    }
  }
}

TEST(Verdicts, AFailureIsToldBeforeAllElse) {
  const ExtremeCase& c = extreme_cases().front();
  const auto worst = [&](std::initializer_list<Verdict> verdicts) {
    std::vector<ExtremeResult> results;
    for (const Verdict v : verdicts) results.push_back({&c, "software", v, 0, {}, 0});
    return worst_of(results);
  };
  EXPECT_EQ(worst({}), std::nullopt);
  EXPECT_EQ(worst({Verdict::right, Verdict::off, Verdict::driver}), Verdict::off);
  EXPECT_EQ(worst({Verdict::broken, Verdict::off}), Verdict::broken);
  EXPECT_EQ(worst({Verdict::right, Verdict::driver}), Verdict::driver);
  EXPECT_EQ(worst({Verdict::not_drawn, Verdict::right, Verdict::unavailable}), Verdict::right);
}

}  // namespace
}  // namespace cg
