// Every question of the quiz can be seen: gl-fixed draws it visibly otherwise than the same scene without the mistake.
#include <gtest/gtest.h>

#include "gl_scenes.h"
#include "image/difference.h"
#include "workbench/mistake_quiz.h"
#include "workbench/open.h"

namespace cg {
namespace {

TEST(MistakeQuizPictures, EachQuestionIsSeen) {
  const std::vector<Technique> all = gl_techniques();
  const Technique& fixed = find(all, "gl-fixed");
  const View view = view_of(128, 128);
  for (const char* model : {"teapot", "torus", "uv-sphere"}) {
    MistakeQuiz quiz(open_scene(model), 1);
    for (int i = 0; i < 10; ++i) {
      Scene scene = quiz.next();
      const Frame wrong = draw(fixed, scene, view);
      scene.mistakes = {};
      const Frame right = draw(fixed, scene, view);
      const Difference d = difference(wrong.colour, right.colour, {}, {}, scene.display);
      EXPECT_GT(d.rmse, 1.0 / 255) << model << ' ' << quiz.mistake();
    }
  }
}

}  // namespace
}  // namespace cg
