// A quiz about the classic mistakes: one is put into the scene without a name, and the student says which line of the
// listing it is in.
#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "workbench/listing.h"

namespace cg {

// Changes the scene where the mistake would do nothing in it, as little as needed: an object is scaled for a missing
// GL_NORMALIZE, a light becomes a point light for a wrong w, a copy stands behind a single object for the depth test.
// `mistake` is the name of a member of Mistakes.
void let_it_show(Scene& scene, std::string_view mistake);

// The scene's mistakes by name, and one of them switched. Asserts that there is one of this name.
bool has_mistake(const Scene& scene, std::string_view mistake);
void set_mistake(Scene& scene, std::string_view mistake, bool on);

class MistakeQuiz {
 public:
  // About `scene` without its own mistakes. The same seed asks the same questions.
  MistakeQuiz(const Scene& scene, std::uint64_t seed);

  // The next question: the scene with one mistake. No mistake comes again before all have been asked.
  Scene next();
  // What the question is about, and whether a line that is missing is its answer.
  std::string_view mistake() const { return mistake_; }
  bool is_missing_line() const { return missing_; }

  // Each counts once for a question, and says whether it is right. Of the lines, each guilty one is.
  bool answer(const ListingLine& line) { return take(line.guilty); }
  bool answer(std::string_view mistake) { return take(mistake == mistake_); }
  bool answer_missing() { return take(missing_); }

  std::optional<bool> answered() const { return answered_; }  // right or wrong; nothing: it is still asked
  int asked() const { return asked_; }
  int right() const { return right_; }
  const Scene& before() const { return before_; }  // as it was, with its own mistakes

 private:
  bool take(bool right);
  void shuffle();

  Scene before_;
  std::uint64_t seed_, drawn_ = 0;
  std::vector<std::string_view> deck_;  // still to be asked; the last is next
  std::string_view mistake_;
  bool missing_ = false;
  std::optional<bool> answered_;
  int asked_ = 0, right_ = 0;
};

}  // namespace cg
