// JSON text and trees: what is refused and where, numbers bit for bit, RFC 7396's own examples.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "params/input_error.h"
#include "params/numbers.h"
#include "params/tree.h"

namespace cg {
namespace {

InputError error_of(const std::string& text) {
  try {
    parse_json(text, "a.json");
  } catch (const InputError& e) {
    return e;
  }
  ADD_FAILURE() << "accepted: " << text.substr(0, 80);
  return InputError("", {});
}

TEST(Json, ReadsEveryKindOfValue) {
  const Tree t = parse_json(R"({"a": [1, -2.5, 1e3, true, null], "b": {"c": "é\n\u3042"}})", "a.json");
  const Tree::List& a = *t.find("a")->list();
  EXPECT_EQ(*a[0].number(), 1);
  EXPECT_EQ(*a[1].number(), -2.5);
  EXPECT_EQ(*a[2].number(), 1000);
  EXPECT_EQ(*a[3].boolean(), true);
  EXPECT_TRUE(a[4].is_null());
  EXPECT_EQ(*t.find("b")->find("c")->string(), "é\nあ");
  EXPECT_EQ(t.find("c"), nullptr);
}

TEST(Json, RefusesWithLineAndColumn) {
  const InputError e = error_of("{\n  \"a\": 1,\n  \"b\": x\n}");
  EXPECT_EQ(e.line, 3);
  EXPECT_NE(e.message(Language::english).find("a.json:3: "), std::string::npos);
  EXPECT_NE(e.message(Language::english).find("column 8"), std::string::npos) << e.message(Language::english);
  EXPECT_NE(e.message(Language::japanese).find("8 桁目"), std::string::npos);
  for (const char* bad :
       {"", " ", "{", "[1,]", "{\"a\":1,}", "{a:1}", "[NaN]", "[Infinity]", "[1e400]", "[-1e400]", "[01]", "[1] 2",
        "[\"\xff\"]", "[\"\\ud800\"]", "[\"a\nb\"]", "// no\n1", "'a'", "[+1]", "\xef\xbb"})
    EXPECT_EQ(error_of(bad).message(Language::english).find('\n'), std::string::npos) << bad;
}

TEST(Json, RefusesDuplicatesDepthAndSize) {
  EXPECT_NE(error_of("{\"a\":{\"k\":1},\n\"a\":2}").message(Language::english).find("a.json:2: the key \"a\""),
            std::string::npos);
  EXPECT_EQ(parse_json(R"({"a":{"k":1},"b":{"k":1}})", "").members()->size(), 2u);
  EXPECT_NO_THROW(parse_json(std::string(64, '[') + std::string(64, ']'), ""));
  error_of(std::string(65, '[') + std::string(65, ']'));
  error_of(std::string(100000, '['));
  error_of("[\"" + std::string((16 << 20) + 1, 'x') + "\"]");
  error_of(std::string(100, '"') + std::string(5000, 'x'));
}

// Whatever bytes change, a text is read or refused in one line; what is read is written and read back the same.
TEST(Json, DamagedTextsAreReadOrRefused) {
  std::mt19937 random(5);
  const std::string whole = R"({"schema": 1, "é": [1, -2.5e-3, true, null, "\u3042\n"], "b": {"c": {}, "d": []}})";
  for (int i = 0; i < 50000; ++i) {
    std::string text = whole;
    for (unsigned n = random() % 4 + 1; n > 0; --n) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
        case 0:
          text[at] = char(random());
          break;
        case 1:
          text.insert(at, 1, "{}[],:\"\\0e-."[random() % 12]);
          break;
        case 2:
          text.erase(at, 1 + random() % 5);
          break;
        default:
          text += text.substr(at);
      }
      if (text.empty()) text = "{";
    }
    try {
      const Tree tree = parse_json(text, "a.json");
      ASSERT_EQ(parse_json(to_json(tree), "a.json"), tree) << text;
    } catch (const InputError& e) {
      ASSERT_EQ(e.message(Language::english).find('\n'), std::string::npos);
      ASSERT_GE(e.line, 1);
    }
  }
}

TEST(Json, NumbersKeepTheirBits) {
  std::mt19937_64 random(1);
  std::vector<double> values{0.0,
                             -0.0,
                             1,
                             -1,
                             0.1,
                             1e20,
                             1e21,
                             1e-320,
                             5e-324,
                             9007199254740993.0,
                             1e308,
                             std::numeric_limits<double>::max(),
                             18446744073709551615.0,
                             -9223372036854775808.0};
  while (values.size() < 20000)
    if (const double v = std::bit_cast<double>(random()); std::isfinite(v)) values.push_back(v);
  for (double v : values) {
    const Tree back = parse_json(to_json(Tree(Tree::List{v}), 0), "");
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*back.list()->front().number()), std::bit_cast<std::uint64_t>(v)) << v;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*parse_number(number_text(v))), std::bit_cast<std::uint64_t>(v)) << v;
  }
  EXPECT_EQ(to_json(Tree(std::nan("")), 0), "null");
  EXPECT_EQ(number_text(std::nan("")), "nan");
  EXPECT_EQ(number_text(-std::nan("")), "nan");
}

TEST(Json, WritesWhatAPersonCanRead) {
  Tree t;
  t.at("k_d") = Tree::List{0.5, 1, 0.25};
  t.at("name") = "球 \"a\"\n";
  t.at("empty") = Tree::Members{};
  EXPECT_EQ(to_json(t), "{\n  \"k_d\": [0.5, 1, 0.25],\n  \"name\": \"球 \\\"a\\\"\\n\",\n  \"empty\": {}\n}");
  EXPECT_EQ(to_json(t, 0), "{\"k_d\":[0.5,1,0.25],\"name\":\"球 \\\"a\\\"\\n\",\"empty\":{}}");
  EXPECT_EQ(parse_json(to_json(t), ""), t);
}

TEST(Numbers, Texts) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1), "1");
  EXPECT_EQ(number_text(100000), "100000");
  EXPECT_EQ(number_text(-0.0001), "-0.0001");
  EXPECT_EQ(number_text(1e-9), "1e-09");
  EXPECT_EQ(number_text(-0.0), "-0");
  EXPECT_EQ(number_text(std::nan("")), "nan");
  EXPECT_EQ(number_text(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(c_literal(1), "1.0");
  EXPECT_EQ(c_literal(-0.0), "-0.0");
  EXPECT_EQ(c_literal(1e20), "1e+20");
  EXPECT_EQ(c_literal(0.5), "0.5");
  EXPECT_EQ(*parse_number("+1.5"), 1.5);
  for (const char* bad : {"", "+", "-", "+-1", "1,5", " 1", "1 ", "nan", "inf", "-inf", "1e400", "0x10", "1f", "true"})
    EXPECT_FALSE(parse_number(bad)) << bad;
}

// RFC 7396, appendix A, every row.
TEST(MergePatch, AppendixA) {
  const char* rows[][3] = {{R"({"a":"b"})", R"({"a":"c"})", R"({"a":"c"})"},
                           {R"({"a":"b"})", R"({"b":"c"})", R"({"a":"b","b":"c"})"},
                           {R"({"a":"b"})", R"({"a":null})", R"({})"},
                           {R"({"a":"b","b":"c"})", R"({"a":null})", R"({"b":"c"})"},
                           {R"({"a":["b"]})", R"({"a":"c"})", R"({"a":"c"})"},
                           {R"({"a":"c"})", R"({"a":["b"]})", R"({"a":["b"]})"},
                           {R"({"a":{"b":"c"}})", R"({"a":{"b":"d","c":null}})", R"({"a":{"b":"d"}})"},
                           {R"({"a":[{"b":"c"}]})", R"({"a":[1]})", R"({"a":[1]})"},
                           {R"(["a","b"])", R"(["c","d"])", R"(["c","d"])"},
                           {R"({"a":"b"})", R"(["c"])", R"(["c"])"},
                           {R"({"a":"foo"})", R"(null)", R"(null)"},
                           {R"({"a":"foo"})", R"("bar")", R"("bar")"},
                           {R"({"e":null})", R"({"a":1})", R"({"e":null,"a":1})"},
                           {R"([1,2])", R"({"a":"b","c":null})", R"({"a":"b"})"},
                           {R"({})", R"({"a":{"bb":{"ccc":null}}})", R"({"a":{"bb":{}}})"}};
  for (const auto& [target, patch, result] : rows)
    EXPECT_EQ(to_json(merge_patch(parse_json(target, ""), parse_json(patch, "")), 0), result) << target << patch;
}

}  // namespace
}  // namespace cg
