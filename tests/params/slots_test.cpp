// Parameters with their types forgotten: checked, named in errors, read from text.
#include "params/slots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "params/input_error.h"
#include "tests/refusal.h"

namespace cg {

namespace {
enum class Fruit { apple, pear };
enum class Rows { none, some, all };
struct Inner {
  double x = 0.5;
  int count = 3;
};
struct Sample {
  bool on = false;
  Fruit fruit = Fruit::pear;
  glm::dvec3 colour{1, 0.5, 0};
  glm::dvec3 place{0, 0, 0};
  double angle = 30;
  std::string name = "n";
  Rows rows = Rows::all;  // a bool once
  Inner inner;
  std::vector<Inner> list{Inner{}, Inner{}};
};
}  // namespace

template <>
inline constexpr std::array<Name, 2> names_of<Fruit>{{{"apple", {"Apple", "りんご"}}, {"pear", {"Pear", "なし"}}}};
template <>
inline constexpr std::array<Name, 3> names_of<Rows>{
    {{"none", {"None", "なし"}, "false"}, {"some", {"Some", "一部"}, "true"}, {"all", {"All", "全部"}}}};
template <>
inline constexpr auto fields_of<Inner> =
    std::tuple{field(&Inner::x, {.name = "x", .label = {"X", "X"}}),
               field(&Inner::count, {.name = "count", .range = {0, 10}, .label = {"Count", "数"}})};
template <>
inline constexpr auto fields_of<Sample> =
    std::tuple{field(&Sample::on, {.name = "on", .label = {"On", "オン"}}),
               field(&Sample::fruit, {.name = "fruit", .label = {"Fruit", "果物"}}),
               field(&Sample::colour, {.name = "colour", .meaning = Meaning::colour, .label = {"Colour", "色"}}),
               field(&Sample::place,
                     {.name = "place", .range = {-9, 9}, .meaning = Meaning::position, .label = {"Place", "位置"}}),
               field(&Sample::angle, {.name = "angle", .range = {0, 90}, .also = 180.0, .label = {"Angle", "角度"}}),
               field(&Sample::name, {.name = "name", .label = {"Name", "名前"}}),
               field(&Sample::rows, {.name = "rows", .label = {"Rows", "行"}}),
               field(&Sample::inner, {.name = "inner", .label = {"Inner", "内側"}}),
               field(&Sample::list, {.name = "list", .label = {"List", "列"}})};

namespace {

class SlotsTest : public testing::Test {
 protected:
  Sample sample;
  Slots all = slots(sample);

  std::string refusal(const std::string& path, const Tree& value) {
    const Tree before = slot_tree(find_slot(all, path));
    try {
      assign(find_slot(all, path), value);
    } catch (const InputError& e) {
      EXPECT_EQ(e.where, path);
      EXPECT_EQ(slot_tree(find_slot(all, path)), before);
      EXPECT_FALSE(e.found.ja.empty());
      EXPECT_FALSE(e.accepted.ja.empty());
      return e.message(Language::english);
    }
    ADD_FAILURE() << path << " took " << to_json(value, 0);
    return "";
  }
};

TEST_F(SlotsTest, PathsInOrder) {
  std::string paths;
  for (const Slot& s : all) paths += s.path + " ";
  EXPECT_EQ(paths,
            "on fruit colour place angle name rows inner.x inner.count list.0.x list.0.count list.1.x list.1.count ");
}

TEST_F(SlotsTest, AssignsAndResets) {
  assign(find_slot(all, "fruit"), "apple");
  assign(find_slot(all, "colour"), 0.25);
  assign(find_slot(all, "angle"), 180);
  assign(find_slot(all, "list.1.count"), 7);
  EXPECT_EQ(sample.fruit, Fruit::apple);
  EXPECT_EQ(sample.colour, glm::dvec3(0.25));
  EXPECT_EQ(sample.angle, 180);
  EXPECT_EQ(sample.list[1].count, 7);
  EXPECT_FALSE(is_initial(find_slot(all, "fruit")));
  for (const Slot& s : all) reset(s);
  for (const Slot& s : all) EXPECT_TRUE(is_initial(s)) << s.path;
  EXPECT_EQ(sample.colour, glm::dvec3(1, 0.5, 0));
}

TEST_F(SlotsTest, RefusesAndSaysWhatWouldWork) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal("angle", 91).find("from 0 to 90, or 180"), std::string::npos);
  EXPECT_NE(refusal("angle", nan).find("nan"), std::string::npos);
  refusal("angle", inf), refusal("angle", "30"), refusal("angle", Tree()), refusal("angle", true);
  EXPECT_NE(refusal("fruit", "plum").find("apple, pear"), std::string::npos);
  refusal("fruit", 0), refusal("on", 1), refusal("name", 1);
  refusal("colour", Tree::List{0.1, 0.2}), refusal("colour", Tree::List{0.1, nan, 0.2});
  refusal("colour", Tree::List{0.1, 0.2, 1.01}), refusal("place", 1);
  refusal("inner.count", 2.5), refusal("inner.count", 11), refusal("inner.count", nan);
}

// A parameter that was a bool in older files.
TEST_F(SlotsTest, ReadsFormerNames) {
  assign(find_slot(all, "rows"), false);
  EXPECT_EQ(sample.rows, Rows::none);
  assign(find_slot(all, "rows"), true);
  EXPECT_EQ(sample.rows, Rows::some);
  assign_text(find_slot(all, "rows"), "false");
  EXPECT_EQ(sample.rows, Rows::none);
  EXPECT_EQ(slot_tree(find_slot(all, "rows")), Tree("none"));
  refusal("fruit", true), refusal("rows", ""), refusal("rows", 1);
}

TEST_F(SlotsTest, ReadsText) {
  assign_text(find_slot(all, "on"), "true");
  assign_text(find_slot(all, "fruit"), "apple");
  assign_text(find_slot(all, "colour"), "0.5, 0.2,0.1");
  assign_text(find_slot(all, "place"), "1,-2,3");
  assign_text(find_slot(all, "inner.count"), "9");
  assign_text(find_slot(all, "name"), "a, b");
  EXPECT_TRUE(sample.on);
  EXPECT_EQ(sample.colour, glm::dvec3(0.5, 0.2, 0.1));
  EXPECT_EQ(sample.place, glm::dvec3(1, -2, 3));
  EXPECT_EQ(sample.inner.count, 9);
  EXPECT_EQ(sample.name, "a, b");
  for (auto [path, text] : {std::pair("colour", "0.5,0.2"),
                            {"colour", ""},
                            {"colour", "a"},
                            {"colour", "0.1,,0.2"},
                            {"angle", "nan"},
                            {"angle", "0,5"},
                            {"on", "yes"},
                            {"inner.count", "1e400"}})
    EXPECT_THROW(assign_text(find_slot(all, path), text), InputError) << path << " " << text;
}

TEST_F(SlotsTest, UnknownNamesListTheNearestFirst) {
  const auto message = [&](std::string_view path) { return refusal_of([&] { find_slot(all, path); }); };
  EXPECT_EQ(message("inner.cuont"), "inner.cuont: there is no such parameter; known are: inner.count, inner.x");
  EXPECT_EQ(message("list.2.x"), "list.2.x: there is no such parameter; known are: list.0, list.1");
  EXPECT_NE(message("color").find("known are: colour"), std::string::npos);
  EXPECT_NE(message("").find("angle"), std::string::npos);
  EXPECT_NE(message("inner").find("inner"), std::string::npos);
  EXPECT_NE(message("..").find("angle"), std::string::npos);
}

}  // namespace
}  // namespace cg
