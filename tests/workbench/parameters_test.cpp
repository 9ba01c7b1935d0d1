// Every parameter that is described: round trips, both ends of its range, refusals, both languages, other locales.
#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <locale>

#include "params/input_error.h"
#include "tests/temporary_folder.h"
#include "tests/workbench/random_scene.h"

namespace cg {
namespace {

Scene full_scene() {
  Scene scene;
  scene.objects.resize(2);
  scene.lights.resize(2);
  return scene;
}

std::string bits(const Slot& slot) { return to_json(slot_tree(slot), 0); }

// The text that --set takes.
std::string typed(const Slot& slot) {
  const Tree tree = slot_tree(slot);
  if (const std::string* text = tree.string()) return *text;
  std::string text = bits(slot);
  std::erase_if(text, [](char c) { return c == '[' || c == ']'; });
  return text;
}

TEST(Parameters, RandomValuesRoundTripThroughJsonAndText) {
  std::mt19937_64 random(11);
  Scene from = full_scene(), by_json = full_scene(), by_text = full_scene();
  const Slots a = slots(from), b = slots(by_json), c = slots(by_text);
  for (int round = 0; round < 200; ++round) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      randomize(random, a[i]);
      assign(b[i], parse_json(to_json(slot_tree(a[i])), ""));
      assign_text(c[i], typed(a[i]));
      ASSERT_EQ(bits(b[i]), bits(a[i])) << a[i].path;
      ASSERT_EQ(bits(c[i]), bits(a[i])) << a[i].path;
    }
    ASSERT_EQ(by_json, from);
    ASSERT_EQ(by_text, from);
  }
}

TEST(Parameters, EndsOfTheRangeAreTakenAndBeyondIsRefused) {
  Scene scene = full_scene();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Slot& slot : slots(scene)) {
    const bool vector = std::holds_alternative<glm::dvec3*>(slot.value);
    const bool whole = std::holds_alternative<int*>(slot.value);
    if (!vector && !whole && !std::holds_alternative<double*>(slot.value)) continue;
    const auto set = [&](double v) { assign(slot, vector ? Tree(Tree::List{0.0, 0.0, v}) : Tree(v)); };
    const Range range = slot.about->range;
    EXPECT_NO_THROW(set(range.min)) << slot.path;
    EXPECT_NO_THROW(set(range.max)) << slot.path;
    EXPECT_NO_THROW(set(slot.about->also.value_or(range.min))) << slot.path;
    const std::string before = bits(slot);
    for (const double bad :
         {std::nextafter(range.min, -infinity), std::nextafter(range.max, infinity), infinity, -infinity, std::nan("")})
      EXPECT_THROW(set(bad), InputError) << slot.path << " " << bad;
    EXPECT_THROW(assign_text(slot, "nan"), InputError);
    EXPECT_THROW(assign_text(slot, "1,5"), InputError);
    EXPECT_EQ(bits(slot), before) << slot.path;
  }
}

TEST(Parameters, WrongTypesAreRefusedInBothLanguages) {
  Scene scene = full_scene();
  for (const Slot& slot : slots(scene))
    for (const Tree& wrong : {Tree(), Tree(Tree::Members{}), Tree(Tree::List{true})}) try {
        assign(slot, wrong);
        ADD_FAILURE() << slot.path << " took " << to_json(wrong, 0);
      } catch (const InputError& e) {
        for (const Language l : {Language::english, Language::japanese}) {
          EXPECT_EQ(e.message(l).find('\n'), std::string::npos);
          EXPECT_EQ(e.message(l).find(slot.path), 0u);
          EXPECT_FALSE(e.accepted.in(l).empty()) << slot.path;
        }
      }
}

TEST(Parameters, BothLanguagesAreThere) {
  Scene scene = full_scene();
  for (const Slot& slot : slots(scene)) {
    const About& about = *slot.about;
    EXPECT_FALSE(about.label.en.empty() || about.label.ja.empty()) << slot.path;
    EXPECT_EQ(about.help.en.empty(), about.help.ja.empty()) << slot.path;
    if (const auto* choice = std::get_if<Choice>(&slot.value)) {
      for (const Name& name : choice->names) EXPECT_FALSE(name.label.en.empty() || name.label.ja.empty()) << slot.path;
    }
    // Widgets abort on ranges over half of float's; NaN is not within either.
    constexpr double half = std::numeric_limits<float>::max() / 2;
    for (const Range range : {slot.about->range, slot.about->slider_range()}) {
      EXPECT_TRUE(range.min >= -half && range.max <= half && range.min < range.max) << slot.path;
      EXPECT_LE(range.max - range.min, half) << slot.path;
    }
    EXPECT_TRUE(is_initial(slot) || slot.path.starts_with("objects")) << slot.path;
  }
}

TEST(Parameters, UnknownPathsListTheKnown) {
  Scene scene = full_scene();
  const Slots all = slots(scene);
  try {
    find_slot(all, "material.kd");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(e.message(Language::english).find("known are: material.k_d, "), std::string::npos);
    EXPECT_NE(e.message(Language::japanese).find("material.k_d"), std::string::npos);
  }
}

TEST(Parameters, ResetAndEqualityAgree) {
  std::mt19937_64 random(2);
  Scene scene;
  for (int round = 0; round < 20; ++round) {
    for (const Slot& slot : slots(scene)) randomize(random, slot);
    for (const Slot& slot : slots(scene)) reset(slot);
    ASSERT_EQ(scene, Scene{});
  }
}

// A decimal comma and dots between thousands, as in German.
struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

// Whether the C library is now in German: Debian installs the sources of locales, so the test makes its own.
bool speak_german(const TemporaryFolder& folder) {
  if (std::setlocale(LC_ALL, "de_DE.UTF-8")) return true;
  const std::string make = "localedef -i de_DE -f UTF-8 '" + (folder / "de_DE.UTF-8").string() + "' >/dev/null 2>&1";
  ::setenv("LOCPATH", folder.path().c_str(), 1);
  return std::system(make.c_str()) == 0 && std::setlocale(LC_ALL, "de_DE.UTF-8");
}

TEST(Parameters, TheLocaleChangesNothing) {
  const TemporaryFolder folder;
  const Tree tree(Tree::List{1234.5, 1e-7, 1e21, -0.25});
  const std::string plain = to_json(tree);
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const bool german = speak_german(folder);
  EXPECT_EQ(to_json(tree), plain);
  EXPECT_EQ(parse_json(plain, ""), tree);
  Scene scene;
  const Slots all = slots(scene);
  assign_text(find_slot(all, "material.n"), "1234.5");
  EXPECT_EQ(scene.material.n, 1234.5);
  EXPECT_EQ(bits(find_slot(all, "material.n")), "1234.5");
  EXPECT_THROW(assign_text(find_slot(all, "material.n"), "0,5"), InputError);
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
  if (!german) GTEST_SKIP() << "de_DE.UTF-8 is not installed: only std::locale was tried";
}

}  // namespace
}  // namespace cg
