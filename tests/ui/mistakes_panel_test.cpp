// The quiz in the window: what it hides, what a click answers, and that all is as before when it is over.
#include <algorithm>

#include "tests/ui/imgui_fixture.h"
#include "ui/quiz.h"
#include "workbench/open.h"

namespace cg {
namespace {

class Quiz : public ImGuiTest {
 protected:
  Quiz() {
    app.settings.side = Side::mistakes;
    app.scene = open_scene("cube");
    app.history.restart(app.scene);
    app.scene.material.n = 77;
    app.history.change(app.scene);
    window_frame();
  }
  void click(ImVec2 at) {
    ImGui::GetIO().MousePos = at;
    window_frame(), window_frame();
    ImGui::GetIO().MouseDown[0] = true;
    window_frame();
    ImGui::GetIO().MouseDown[0] = false;
    window_frame();
  }
  bool traces() const {
    const auto& lines = app.code.listing.lines;
    return std::any_of(lines.begin(), lines.end(), [](const ListingLine& l) { return l.guilty && l.comment; });
  }
};

TEST_F(Quiz, HidesWhatIsMissingUntilItIsAnsweredAndBringsAllBack) {
  const Scene before = app.scene;
  begin_quiz(app, 3);
  int missing = 0;
  for (int i = 0; i < 10; ++i, next_question(app)) {
    window_frame();
    EXPECT_TRUE(quiz_asks(app));
    EXPECT_FALSE(traces());
    app.scene.mistakes = {};  // as undo would
    window_frame();
    EXPECT_TRUE(has_mistake(app.scene, app.quiz->quiz.mistake()));
    answer_missing(app);
    window_frame();
    EXPECT_EQ(*app.quiz->quiz.answered(), traces());
    missing += traces();
    EXPECT_EQ(app.quiz->quiz.right(), missing);
  }
  EXPECT_GT(missing, 0);
  EXPECT_LT(missing, 10);
  leave_quiz(app);
  window_frame();
  EXPECT_EQ(app.scene, before);
  ASSERT_TRUE(app.history.can_undo());
  EXPECT_EQ(app.history.undo().material.n, 32);
}

TEST_F(Quiz, AClickOnALineAnswersAndMovesNoNumber) {
  begin_quiz(app, 5);
  window_frame();
  const Scene question = app.scene;
  for (float y = 610; y < 700 && quiz_asks(app); y += 20) click({900, y});
  EXPECT_FALSE(quiz_asks(app));
  EXPECT_EQ(app.scene, question);
  EXPECT_FALSE(app.quiz->chosen.empty());
}

TEST_F(Quiz, EndsWithItsPanel) {
  const Scene before = app.scene;
  begin_quiz(app, 5);
  window_frame();
  EXPECT_NE(app.scene, before);
  app.settings.side = Side::plan;
  window_frame();
  EXPECT_FALSE(app.quiz);
  EXPECT_EQ(app.scene, before);
}

}  // namespace
}  // namespace cg
