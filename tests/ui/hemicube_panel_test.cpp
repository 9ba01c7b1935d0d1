// The panel of the hemicube: drawn in both languages and all its views, and what the mouse does in it.
#include <algorithm>
#include <ctime>
#include <thread>

#include "raster/software.h"
#include "tests/ui/imgui_fixture.h"
#include "ui/actions.h"
#include "ui/hemicube_desk.h"
#include "ui/hemicube_marks.h"
#include "ui/lesson_player.h"
#include "ui/state_dump.h"
#include "workbench/open.h"
#include "workbench/picking.h"

namespace cg {
namespace {

class HemicubePanel : public ImGuiTest {
 protected:
  HemicubePanel() {
    app.techniques = {software_technique()};
    app.settings.side = Side::hemicube;
    open("models/closed-cube.json");
  }
  void open(const char* scene) {
    app.scene = open_scene(scene);
    app.scene.radiosity.patch_size = 0.5, app.scene.radiosity.resolution = 32;
    app.history.restart(app.scene);
  }
  void settle() {
    for (int calm = 0; calm < 4;) {
      window_frame();
      calm = hemicube_of(app).busy() ? 0 : calm + 1;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
};

TEST_F(HemicubePanel, EveryViewInBothLanguagesOfScenesWithAndWithoutLight) {
  for (const char* scene : {"models/closed-cube.json", "torus", "models/parallel-squares.json", "plane"}) {
    open(scene);
    for (int view = 0; view < int(names_of<HemicubeShow>.size()); ++view)
      for (const Language language : {Language::english, Language::japanese}) {
        app.settings.hemicube = HemicubeShow(view), app.settings.language = language;
        settle();
        ASSERT_TRUE(hemicube_of(app).state().sight) << scene;
        EXPECT_EQ(hemicube_of(app).state().sight->show, HemicubeShow(view));
      }
  }
  app.scene.objects.clear();
  settle();
  EXPECT_TRUE(hemicube_of(app).state().message);
}

TEST_F(HemicubePanel, AKeyOpensIt) {
  app.settings.side = Side::none;
  perform(app, Do::hemicube);
  EXPECT_EQ(app.settings.side, Side::hemicube);
  perform(app, Do::hemicube);
  EXPECT_EQ(app.settings.side, Side::none);
}

// A click in a picture takes the patch there, and asks for no pixel's numbers; closed, the picture is as it was.
TEST_F(HemicubePanel, APatchIsChosenInThePicture) {
  settle();
  Place place;
  place.low = {0, 0}, place.high = {400, 400}, place.width = place.height = 400;
  const PictureProjection projector(app.scene.camera, {400, 400});
  const auto& patches = hemicube_of(app).state().ground->patches.patches;
  int hits = 0;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const auto seen = projector.project(patches[k].centre);
    if (!seen || glm::any(glm::lessThan(seen->pixel, glm::dvec2(0))) ||
        glm::any(glm::greaterThanEqual(seen->pixel, glm::dvec2(400))))
      continue;
    ASSERT_TRUE(choose_patch(app, place, seen->pixel));
    EXPECT_EQ(app.settings.patch, int(k));
    ++hits;
  }
  EXPECT_GT(hits, 4);
  settle();
  bool own = false, other = false;
  for (const Lines& lines : hemicube_lines(app))
    own |= lines.mark == Mark::patch, other |= lines.mark == Mark::other_patch;
  EXPECT_TRUE(own && other);
  app.settings.side = Side::plan;
  EXPECT_FALSE(choose_patch(app, place, {200, 200}));
  EXPECT_TRUE(hemicube_lines(app).empty());
}

TEST_F(HemicubePanel, AWrongWeightIsOneStepOfUndo) {
  settle();
  const Scene before = app.scene;
  app.scene.radiosity.weight = PixelWeight::solid_angle;
  settle();
  const HemicubeDesk::State state = hemicube_of(app).state();
  EXPECT_EQ(state.row->options.weight, PixelWeight::solid_angle);
  EXPECT_NEAR(state.row->row.sum, 1, 1e-3);
  app.scene = app.history.undo();
  EXPECT_EQ(app.scene, before);
  settle();
  EXPECT_EQ(hemicube_of(app).state().row->options.weight, PixelWeight::delta_form_factor);
}

// Presented, it stands where the lesson's text is.
TEST_F(HemicubePanel, ItIsPresented) {
  app.presenter.on = true;
  settle();
  EXPECT_TRUE(hemicube_of(app).state().pair);
  EXPECT_FALSE(hemicube_lines(app).empty());
}

double thread_cpu_ms() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

// While S moves at the largest resolution the window's thread works less than a frame of 60 Hz lasts, and what is shown
// follows.
TEST_F(HemicubePanel, SamplesMoveAtTheLargestResolution) {
  settle();
  app.scene.radiosity.resolution = 1024;
  std::vector<double> ms;
  std::size_t followed = 0;
  std::shared_ptr<const HemicubeSight> seen;
  for (int i = 0; i < 120 || (followed < 3 && i < 6000); ++i) {
    app.scene.radiosity.samples = 1 + i / 4 % 16;
    const double start = thread_cpu_ms();
    window_frame();
    ms.push_back(thread_cpu_ms() - start);
    const std::shared_ptr<const HemicubeSight>& now = hemicube_of(app).state().sight;
    followed += now != seen && now->options.resolution == 1024;
    seen = now;
    std::this_thread::sleep_for(std::chrono::milliseconds(8));
  }
  std::sort(ms.begin(), ms.end());
  std::printf("R = 1024, S = 1..16: a frame's CPU time, median %.2f ms, worst %.2f ms; %zu pictures\n",
              ms[ms.size() / 2], ms.back(), followed);
  EXPECT_LT(ms[ms.size() * 95 / 100], 16);
  EXPECT_GE(followed, 3u);
  app.scene.radiosity.resolution = 16, app.scene.radiosity.samples = 1;
  settle();
  EXPECT_EQ(hemicube_of(app).state().row->options.samples, 1);
}

TEST_F(HemicubePanel, ALessonsStepSaysWhatItShows) {
  settle();
  LessonView view;
  view.patch = 7, view.other_patch = 2, view.hemicube = HemicubeShow::nusselt;
  show_hemicube(app, view);
  settle();
  const HemicubeDesk::State state = hemicube_of(app).state();
  EXPECT_EQ(state.sight->patch, 7u);
  EXPECT_EQ(state.sight->show, HemicubeShow::nusselt);
  EXPECT_EQ(state.pair->other(), 2u);
}

}  // namespace
}  // namespace cg
