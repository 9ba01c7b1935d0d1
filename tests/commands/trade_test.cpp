// shadebench trade, as a person runs it.
#include <gtest/gtest.h>

#include "params/tree.h"
#include "tests/commands/run_program.h"

namespace cg {
namespace {

class TradeCommandTest : public testing::Test {
 protected:
  Outcome run(const std::vector<std::string>& arguments, const Environment& environment = {}) {
    std::vector<std::string> all{"trade"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_program(SHADEBENCH_PROGRAM, folder, all, environment);
  }
  const TemporaryFolder folder;
};

TEST_F(TradeCommandTest, TheListNamesEightKnobsAndMoreWithTheirSources) {
  const Outcome o = run({"--list", "--json"});
  ASSERT_EQ(o.status, 0) << o.err;
  const Tree list = parse_json(o.out, "list");
  const Tree* knobs = list.find("knobs");
  ASSERT_TRUE(knobs && knobs->list());
  EXPECT_GE(knobs->list()->size(), 8u);
  const Outcome english = run({"--list"}), japanese = run({"--list"}, {{"LANG", "ja_JP.UTF-8"}});
  for (const Tree& knob : *knobs->list()) {
    const std::string& id = *knob.find("id")->string();
    EXPECT_NE(english.out.find(id + ": " + *knob.find("name")->find("en")->string()), std::string::npos) << id;
    EXPECT_NE(japanese.out.find(*knob.find("name")->find("ja")->string()), std::string::npos) << id;
    ASSERT_FALSE(knob.find("predictions")->list()->empty()) << id;
    for (const Tree& p : *knob.find("predictions")->list())
      EXPECT_NE(english.out.find(*p.find("source")->string()), std::string::npos) << id;
  }
}

TEST_F(TradeCommandTest, ItWritesTheTableAndThePlotAndIsSilentInAPipe) {
  const Outcome o = run({"near-plane", "torus", "--size", "64x64", "--repeats", "2", "-o", "out/deep", "--json"},
                        {{"LC_ALL", "de_DE.UTF-8"}});
  ASSERT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.err, "");
  const Tree trade = parse_json(o.out, "trade");
  EXPECT_EQ(*trade.find("scene")->string(), "torus");
  EXPECT_EQ(*trade.find("width")->number(), 64);
  EXPECT_EQ(*trade.find("repeats")->number(), 2);
  EXPECT_FALSE(trade.find("machine")->find("cpu")->string()->empty());
  const std::string csv = read_file(folder / "out/deep/near-plane-torus.csv");
  EXPECT_TRUE(csv.starts_with("id,series,x,")) << csv;
  EXPECT_EQ(parse_json(read_file(folder / "out/deep/near-plane-torus.json"), "file"), trade);
  EXPECT_TRUE(read_file(folder / "out/deep/near-plane-torus.svg").starts_with("<svg "));
}

TEST_F(TradeCommandTest, TwoRunsGiveTheSameErrors) {
  const auto errors = [&] {
    const Outcome o = run({"reflection", "torus", "--size", "48x48", "--repeats", "1", "--json"});
    EXPECT_EQ(o.status, 0) << o.err;
    Tree::List out;
    const Tree trade = parse_json(o.out, "trade");
    for (const Tree& s : *trade.find("settings")->list()) out.push_back(*s.find("rmse")), out.push_back(*s.find("max"));
    return to_json(Tree(out));
  };
  EXPECT_EQ(errors(), errors());
}

TEST_F(TradeCommandTest, ARunIsHeldAgainstAnEarlierOne) {
  const std::vector<std::string> plain{"reflection", "torus", "--size", "48x48", "--repeats", "3"};
  const auto with = [&](std::vector<std::string> all, std::initializer_list<std::string> more) {
    all.insert(all.end(), more);
    return run(all);
  };
  ASSERT_EQ(with(plain, {"-o", "."}).status, 0);
  const std::string file = "reflection-torus.json";
  const Outcome same = with(plain, {"--against", file, "--json"});
  ASSERT_EQ(same.status, 0) << same.err;
  const Tree result = parse_json(same.out, "result");
  EXPECT_GT(*result.find("settings")->number(), 1);
  EXPECT_EQ(*result.find("same_errors")->number(), *result.find("settings")->number());

  Tree changed = parse_json(read_file(folder / file), file);
  Tree::List& settings = std::get<Tree::List>(changed.at("settings").value);
  settings[1].at("rmse") = *settings[1].find("rmse")->number() * 2;
  settings[0].at("ms_low") = 1e9, settings[0].at("ms_high") = 2e9;
  save_file(folder / "changed.json", to_json(changed));
  const Outcome other = with(plain, {"--against", "changed.json", "--json"});
  EXPECT_EQ(other.status, 1) << other.err;
  const Tree found = parse_json(other.out, "result");
  ASSERT_EQ(found.find("other_errors")->list()->size(), 1u);
  EXPECT_EQ(found.find("other_errors")->list()->front(), *settings[1].find("id"));
  EXPECT_EQ(*found.find("times_outside")->list()->front().find("id"), *settings[0].find("id"));

  for (const char* language : {"C", "ja_JP.UTF-8"}) {
    std::vector<std::string> wrong{"trade", "near-plane", "torus", "--against", file};
    const Outcome o = run_program(SHADEBENCH_PROGRAM, folder, wrong, {{"LANG", language}});
    EXPECT_EQ(o.status, 2);
    EXPECT_NE(o.err.find("reflection-torus.json"), std::string::npos) << o.err;
    EXPECT_EQ(o.error_lines(), 1u);
  }
  save_file(folder / "empty.json", "{}");
  EXPECT_EQ(with(plain, {"--against", "empty.json"}).status, 2);
  EXPECT_EQ(run({"reflection", "torus", "--size", "40x40", "--repeats", "1", "--against", file}).status, 2);
}

TEST_F(TradeCommandTest, MistakesAreOneLineThatSaysWhatWouldWork) {
  const auto mistake = [&](const std::vector<std::string>& arguments, const std::string& says) {
    const Outcome o = run(arguments);
    EXPECT_EQ(o.status, 2) << o.out;
    EXPECT_EQ(o.error_lines(), 1u) << o.err;
    EXPECT_NE(o.err.find(says), std::string::npos) << o.err;
  };
  mistake({}, "near-plane");
  mistake({"shadng"}, "supersampling");
  mistake({"shading", "cornell-box.obj"}, "torus-knot");
  mistake({"shading", "no-such-scene"}, "teapot");
  mistake({"shading", "torus", "--repeats", "0"}, "1 to 1000");
  mistake({"near-plane", "torus", "--technique", "raytracer"}, "software");
  mistake({"near-plane", "torus", "--set", "camera.projection=orthographic"}, "perspective");
  mistake({"near-plane", "torus", "--size", "32x32", "--repeats", "1", "-o", "/proc/none"}, "/proc/none");
}

}  // namespace
}  // namespace cg
