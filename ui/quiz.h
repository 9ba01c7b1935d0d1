// The quiz in the window: a mistake without its name in the scene, the listing to click on, and all as it was before
// when it is over.
#pragma once
#include <string>

#include "workbench/history.h"
#include "workbench/mistake_quiz.h"

namespace cg {

struct App;

struct QuizGame {
  MistakeQuiz quiz;
  History<Scene> history;  // of the scene before
  std::string chosen;      // the text of the line that was clicked; empty: none
  bool code = true;        // whether the listing was shown before
};

void begin_quiz(App& app, std::uint64_t seed);
void next_question(App& app);
// After each the guilty line is shown.
void answer_line(App& app, const ListingLine& line);
void answer_name(App& app, std::string_view mistake);
void answer_missing(App& app);
// Brings the scene back with its steps of undo.
void leave_quiz(App& app);
// Once a frame: the question's mistake stays in the scene, and the quiz ends where its panel is no longer shown.
void keep_quiz(App& app);

// Whether a question waits for its answer: then the listing hides what would tell it.
bool quiz_asks(const App& app);

// The guilty line of the listing comes to the top.
void show_guilty_line(App& app, std::string_view mistake);

// gl-fixed at the left, where no picture is drawn by it: only there a mistake is seen. False where it cannot work here.
bool show_gl_fixed(App& app);

}  // namespace cg
