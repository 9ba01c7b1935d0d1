// shadebench radiosity, as a person types it.
#include <gtest/gtest.h>

#include <cmath>

#include "params/tree.h"
#include "tests/commands/run_program.h"

namespace cg {
namespace {

class RadiosityCommandTest : public testing::Test {
 protected:
  Outcome run(std::vector<std::string> arguments, const Environment& environment = {}) {
    arguments.insert(arguments.begin(), "radiosity");
    return run_program(SHADEBENCH_PROGRAM, folder, arguments, environment);
  }
  Tree json(std::vector<std::string> arguments) {
    arguments.push_back("--json");
    const Outcome o = run(arguments);
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_EQ(o.err, "");
    return o.status == 0 ? parse_json(o.out, "radiosity") : Tree();
  }
  static double number(const Tree& t, const char* key) {
    const Tree* found = t.find(key);
    return found && found->number() ? *found->number() : NAN;
  }
  TemporaryFolder folder;
};

constexpr const char* cube = "models/closed-cube.json";

TEST_F(RadiosityCommandTest, FiguresInJson) {
  const Tree t = json({cube, "--patch-size", "0.25", "--resolution", "64", "--threads", "2"});
  EXPECT_EQ(number(t, "patches"), 150);  // 5 x 5 a face: the cube is fitted into view
  EXPECT_EQ(number(t, "elements"), 150);
  EXPECT_EQ(number(t, "resolution"), 64);
  EXPECT_EQ(*t.find("solver")->string(), "gauss-seidel");
  EXPECT_EQ(*t.find("form_factors")->string(), "hemicube");
  EXPECT_EQ(*t.find("end")->string(), "converged");
  EXPECT_LE(number(t, "row_sum_error"), 2e-4);
  EXPECT_EQ(number(t, "missed"), 0);
  EXPECT_LE(number(t, "error_bound"), 1e-6);
  EXPECT_GT(number(t, "sweeps"), 3);
  EXPECT_GE(number(t, "reciprocity_error"), 0);
  double sum = 0;
  for (const char* phase : {"patches", "form_factors", "solve", "elements"}) {
    EXPECT_GE(number(*t.find("seconds"), phase), 0) << phase;
    sum += number(*t.find("seconds"), phase);
  }
  EXPECT_NEAR(number(*t.find("seconds"), "total"), sum, 1e-9);
}

// Sum A B (1 - rho) = sum A E, to what the closed forms and floats leave.
TEST_F(RadiosityCommandTest, WhatIsEmittedIsAbsorbed) {
  const Tree t = json({cube, "--patch-size", "0.25", "--form-factors", "closed-form"});
  double power = 0, emitted = 0;
  for (const Tree& o : *t.find("objects")->list()) {
    power += number(o, "area") * *(*o.find("radiosity")->list())[0].number();
    if (*o.find("name")->string() == "floor") emitted = number(o, "area");
  }
  EXPECT_NEAR(power * .5 / emitted, 1, 1e-4);
}

TEST_F(RadiosityCommandTest, FormFactorOfTwoObjects) {
  for (const auto& [scene, expected] : {std::pair("models/parallel-squares.json", 0.199824895698),
                                        {"models/perpendicular-squares.json", 0.200043776}}) {
    const std::vector<std::string> common{scene, "--form-factor", "0,1", "--patch-size", "1"};
    const auto with = [&](std::vector<std::string> more) {
      more.insert(more.begin(), common.begin(), common.end());
      return number(json(more), "form_factor");
    };
    EXPECT_NEAR(with({"--form-factors", "closed-form"}), expected, 1e-6);
    EXPECT_NEAR(with({"--form-factors", "hemicube", "--resolution", "64", "--samples", "8"}), expected, 5e-4);
  }
}

// From the middle of a unit square to the one opposite it: a point and a plate. The wrong weights sum to 1 too.
TEST_F(RadiosityCommandTest, FormFactorByEachWeight) {
  const std::vector<std::string> arguments{"models/parallel-squares.json",
                                           "--patch-size",
                                           "2",
                                           "--samples",
                                           "1",
                                           "--resolution",
                                           "64",
                                           "--form-factor",
                                           "lower,upper",
                                           "--weights"};
  const Tree t = json(arguments);
  const Tree& figures = *t.find("form_factor_by_weight");
  constexpr double exact = 0.239456470461;
  EXPECT_NEAR(number(figures, "nusselt"), exact, 1e-7);
  EXPECT_NEAR(number(figures, "closed_form"), 0.199824895698, 1e-7);
  const Tree::List& rows = *figures.find("weights")->list();
  ASSERT_EQ(rows.size(), 5u);
  for (const Tree& row : rows) {
    const std::string weight = *row.find("weight")->string();
    EXPECT_NEAR(number(row, "sum"), 1, 2e-4) << weight;
    const double error = std::abs(number(row, "form_factor") - exact);
    if (weight == "delta-form-factor" || weight == "integrated")
      EXPECT_LT(error, 1e-4) << weight;
    else
      EXPECT_GT(error, 0.03) << weight;
  }
  const Outcome japanese = run(arguments, {{"LANG", "ja_JP.UTF-8"}});
  EXPECT_NE(japanese.out.find("0.239456"), std::string::npos) << japanese.out;
  const Outcome unnamed = run({cube, "--weights"});
  EXPECT_EQ(unnamed.status, 2);
  EXPECT_EQ(unnamed.error_lines(), 1u) << unnamed.err;
}

TEST_F(RadiosityCommandTest, MeansAgainstAnotherMethod) {
  const std::vector<std::string> arguments{"models/cornell-box.json", "--patch-size", "0.3", "--against",
                                           "monte-carlo"};
  const Tree t = json(arguments);
  const Tree& against = *t.find("against");
  EXPECT_EQ(*against.find("form_factors")->string(), "monte-carlo");
  EXPECT_EQ(against.find("objects")->list()->size(), 8u);
  EXPECT_GT(number(against, "largest"), 0);
  EXPECT_LT(number(against, "largest"), 0.05);  // 1024 rays a patch
  for (const char* language : {"en_US.UTF-8", "ja_JP.UTF-8"}) {
    const Outcome o = run(arguments, {{"LANG", language}});
    for (const char* name : {"left-wall", "tall-block"}) EXPECT_NE(o.out.find(name), std::string::npos) << o.out;
  }
}

// As the software's, but for what the driver's rounding of corners makes of pixels at borders.
TEST_F(RadiosityCommandTest, HemicubesByOpenGl) {
  const std::vector<std::string> gl{"--set", "radiosity.item_buffer=gl"};
  const auto means = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{cube, "--patch-size", "0.5", "--resolution", "64"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    std::vector<double> out;
    const Tree printed = json(arguments);
    for (const Tree& o : *printed.find("objects")->list()) out.push_back(*(*o.find("radiosity")->list())[0].number());
    return out;
  };
  const std::vector<double> software = means({}), by_gl = means(gl);
  ASSERT_EQ(software.size(), by_gl.size());
  for (std::size_t i = 0; i < software.size(); ++i) EXPECT_NEAR(by_gl[i] / software[i], 1, 1e-3) << i;
  // Where there is no OpenGL: one line that says so, in both languages, and what works.
  std::vector<std::string> arguments{cube, "--patch-size", "0.5"};
  arguments.insert(arguments.end(), gl.begin(), gl.end());
  for (const char* language : {"en_US.UTF-8", "ja_JP.UTF-8"}) {
    const Outcome o = run(arguments, {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"}, {"LANG", language}});
    EXPECT_EQ(o.status, 2) << o.out;
    EXPECT_EQ(o.error_lines(), 1u) << o.err;
    EXPECT_NE(o.err.find("item_buffer"), std::string::npos) << o.err;
    EXPECT_NE(o.err.find("software"), std::string::npos) << o.err;
  }
}

TEST_F(RadiosityCommandTest, OptionsAreShortCutsForSet) {
  const auto timeless = [&](const std::vector<std::string>& arguments) {
    Tree t = json(arguments);
    t.at("seconds") = Tree();
    return to_json(t);
  };
  EXPECT_EQ(timeless({cube, "--patch-size", "0.5", "--solver", "southwell", "--residual", "1e-4"}),
            timeless({cube, "--set", "radiosity.patch_size=0.5", "--set", "radiosity.solver=southwell", "--set",
                      "radiosity.residual=1e-4"}));
  EXPECT_EQ(timeless({cube, "--patch-size", "0.5", "--threads", "1"}),
            timeless({cube, "--patch-size", "0.5", "--threads", "5"}));
}

TEST_F(RadiosityCommandTest, EverySolverFindsTheSameLight) {
  double expected = NAN;
  for (const char* solver : {"lu", "jacobi", "gauss-seidel", "southwell", "progressive"}) {
    const Tree t = json({cube, "--patch-size", "0.5", "--form-factors", "closed-form", "--solver", solver});
    const double b = *(*t.find("objects")->list()->back().find("radiosity")->list())[0].number();
    if (std::isnan(expected)) expected = b;
    EXPECT_NEAR(b, expected, 2e-6) << solver;
  }
}

TEST_F(RadiosityCommandTest, TextInBothLanguagesAndASolution) {
  const std::vector<std::string> arguments{cube, "--patch-size", "0.5", "--form-factor", "0,0", "-o", "解.ply"};
  const Outcome english = run(arguments), japanese = run(arguments, {{"LANG", "ja_JP.UTF-8"}});
  EXPECT_EQ(english.status, 0) << english.err;
  for (const char* word : {"patches", "form factors", "solver", "form factor: "})
    EXPECT_NE(english.out.find(word), std::string::npos) << english.out;
  EXPECT_NE(japanese.out.find("形態係数"), std::string::npos);
  EXPECT_EQ(japanese.out.find("patches"), std::string::npos) << japanese.out;
  EXPECT_GT(read_file(folder / "解.ply").size(), 1000u);
}

TEST_F(RadiosityCommandTest, MistakesAreOneLineThatSaysWhatWouldWork) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {},
           {cube, "--form-factors", "hemisphere"},
           {cube, "--solver", "sor"},
           {cube, "--resolution", "8"},
           {cube, "--residual", "0"},
           {cube, "--patch-size", "-1"},
           {cube, "--form-factor", "0"},
           {cube, "--form-factor", "0,wall-of-china"},
           {cube, "--against", "rays"},
           {cube, "--set", "material.k_d=1.5", "--set", "objects.0.own_material=false"},
           {cube, "--patch-size", "0.5", "-o", "no/such/folder/s.ply"}}) {
    const Outcome o = run(arguments);
    EXPECT_EQ(o.status, 2) << o.out;
    EXPECT_EQ(o.error_lines(), 1u) << o.err;
  }
}

TEST_F(RadiosityCommandTest, DivergenceIsAFailedCheck) {
  std::vector<std::string> arguments{cube, "--patch-size", "0.5"};
  for (const char* object : {"0", "1", "2", "3", "4", "5"})
    arguments.insert(arguments.end(), {"--set", std::string("objects.") + object + ".material.k_d=1"});
  const Outcome o = run(arguments);
  EXPECT_EQ(o.status, 1) << o.out << o.err;
  EXPECT_NE(o.err.find("iverges"), std::string::npos) << o.err;
}

}  // namespace
}  // namespace cg
