#include "ui/quiz.h"

#include <algorithm>

#include "ui/app.h"

namespace cg {
namespace {

int index_of(const App& app, std::string_view id) {
  for (std::size_t i = 0; i < app.techniques.size(); ++i)
    if (app.techniques[i].id == id && !app.techniques[i].unavailable) return int(i);
  return -1;
}

}  // namespace

bool show_gl_fixed(App& app) {
  const int fixed = index_of(app, "gl-fixed");
  if (fixed < 0) return false;
  if (app.left != fixed && app.right != fixed) app.left = fixed;
  if (app.left == fixed && app.right == fixed)
    if (const int other = index_of(app, "software"); other >= 0) app.right = other;
  return true;
}

void begin_quiz(App& app, std::uint64_t seed) {
  if (app.quiz) return;
  app.isolated = {};
  app.quiz = std::make_shared<QuizGame>(QuizGame{MistakeQuiz(app.scene, seed), app.history, {}, app.settings.code});
  app.settings.code = app.settings.code_in_front = true;
  show_gl_fixed(app);
  next_question(app);
}

void next_question(App& app) {
  app.scene = app.quiz->quiz.next();
  app.history.restart(app.scene);
  app.quiz->chosen.clear();
  app.code.jump = 0;
}

void answer_line(App& app, const ListingLine& line) {
  app.quiz->chosen = line.text;
  if (!app.quiz->quiz.answer(line)) show_guilty_line(app, app.quiz->quiz.mistake());
}

void answer_name(App& app, std::string_view mistake) {
  app.quiz->quiz.answer(mistake);
  show_guilty_line(app, app.quiz->quiz.mistake());
}

void answer_missing(App& app) {
  app.quiz->quiz.answer_missing();
  show_guilty_line(app, app.quiz->quiz.mistake());
}

void show_guilty_line(App& app, std::string_view mistake) {
  app.settings.code = app.settings.code_in_front = true;
  const std::vector<ListingLine> lines = listing(app.scene, app.language()).lines;  // as the next frame has it
  const auto guilty =
      std::find_if(lines.begin(), lines.end(), [&](const ListingLine& line) { return line.mistake == mistake; });
  if (guilty != lines.end()) app.code.jump = std::max(0, int(guilty - lines.begin()) - 2);
}

void leave_quiz(App& app) {
  if (!app.quiz) return;
  const std::shared_ptr<QuizGame> game = std::move(app.quiz);
  app.scene = game->quiz.before();
  app.history = game->history;
  app.settings.code = game->code;
  app.code.jump = 0;
}

void keep_quiz(App& app) {
  if (!app.quiz) return;
  if (app.settings.side != Side::mistakes) return leave_quiz(app);
  if (has_mistake(app.scene, app.quiz->quiz.mistake())) return;
  app.scene.mistakes = {};
  set_mistake(app.scene, app.quiz->quiz.mistake(), true);
}

bool quiz_asks(const App& app) { return app.quiz && !app.quiz->quiz.answered(); }

}  // namespace cg
