#include "workbench/mistake_quiz.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "params/slots.h"
#include "workbench/open.h"

namespace cg {
namespace {

std::vector<std::string> all_mistakes() {
  Mistakes m;
  std::vector<std::string> names;
  for (const Slot& slot : slots(m)) names.push_back(slot.path);
  return names;
}

std::set<std::string_view> guilty(const Scene& scene) {
  std::set<std::string_view> found;
  for (const ListingLine& line : listing(scene).lines)
    if (line.guilty) found.insert(line.mistake);
  return found;
}

TEST(MistakeQuiz, EachMistakeHasALineOfItsOwnWhereItShows) {
  for (const char* model : {"teapot", "cube"})
    for (const std::string& name : all_mistakes()) {
      Scene scene = open_scene(model);
      let_it_show(scene, name);
      EXPECT_TRUE(guilty(scene).empty()) << name;
      set_mistake(scene, name, true);
      EXPECT_TRUE(has_mistake(scene, name));
      EXPECT_EQ(guilty(scene), std::set<std::string_view>{name}) << model;
      set_mistake(scene, name, false);
      EXPECT_EQ(scene.mistakes, Mistakes{});
    }
}

TEST(MistakeQuiz, WhatShowsAlreadyIsLeftAlone) {
  Scene scene = open_scene("teapot");
  for (const std::string& name : all_mistakes()) let_it_show(scene, name);
  for (const std::string& name : all_mistakes()) {
    if (name == "no_gate") continue;  // its light is moved wherever it stands
    Scene again = scene;
    let_it_show(again, name);
    EXPECT_EQ(again, scene) << name;
  }
}

TEST(MistakeQuiz, AsksEachOnceThenAgainAndTheSameForOneSeed) {
  const Scene scene = open_scene("cube");
  const std::size_t count = all_mistakes().size();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    MistakeQuiz quiz(scene, seed), same(scene, seed);
    std::vector<std::string_view> asked;
    for (std::size_t i = 0; i < 3 * count; ++i) {
      const Scene question = quiz.next();
      EXPECT_EQ(question, same.next());
      EXPECT_EQ(guilty(question), std::set<std::string_view>{quiz.mistake()});
      EXPECT_TRUE(asked.empty() || asked.back() != quiz.mistake());
      asked.push_back(quiz.mistake());
    }
    for (std::size_t round = 0; round < 3; ++round) {
      const auto first = asked.begin() + std::ptrdiff_t(round * count);
      EXPECT_EQ(std::set<std::string_view>(first, first + std::ptrdiff_t(count)).size(), count);
    }
  }
}

TEST(MistakeQuiz, CountsTheFirstAnswerOfEachQuestion) {
  Scene scene = open_scene("cube");
  scene.mistakes.no_depth_test = true;
  MistakeQuiz quiz(scene, 7);
  int right = 0;
  for (int i = 0; i < 10; ++i) {
    const Scene question = quiz.next();
    EXPECT_FALSE(quiz.answered());
    const Listing text = listing(question);
    const auto line = std::find_if(text.lines.begin(), text.lines.end(), [](const ListingLine& l) { return l.guilty; });
    ASSERT_NE(line, text.lines.end());
    EXPECT_EQ(quiz.is_missing_line(), line->comment);
    const bool wrong_first = i % 3 == 0;
    EXPECT_FALSE(wrong_first && quiz.answer(std::string_view("none of them")));
    const bool said = quiz.is_missing_line() ? quiz.answer_missing()
                      : i % 2                ? quiz.answer(*line)
                                             : quiz.answer(quiz.mistake());
    EXPECT_EQ(said, !wrong_first);
    right += !wrong_first;
    EXPECT_EQ(quiz.asked(), i + 1);
    EXPECT_EQ(quiz.right(), right);
  }
  EXPECT_EQ(quiz.before(), scene);
}

}  // namespace
}  // namespace cg
