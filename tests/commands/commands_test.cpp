// The commands from end to end: exit status, one line for a mistake, JSON that parses, any locale, any file name.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "params/tree.h"
#include "tests/commands/run_program.h"

namespace cg {
namespace {

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class CommandTest : public testing::Test {
 protected:
  Outcome run(const std::vector<std::string>& arguments, const Environment& environment = {}) {
    return run_program(SHADEBENCH_PROGRAM, folder, arguments, environment);
  }
  // Exit status 2 and one line on stderr, nothing on stdout.
  std::string mistake(const std::vector<std::string>& arguments, const Environment& environment = {}) {
    const Outcome o = run(arguments, environment);
    EXPECT_EQ(o.status, 2) << o.err;
    EXPECT_EQ(o.error_lines(), 1u) << o.err;
    EXPECT_TRUE(o.err.starts_with("shadebench: ")) << o.err;
    EXPECT_EQ(o.out, "");
    return o.err;
  }
  std::string bytes(const std::string& file) { return read_file(folder / file); }
  const TemporaryFolder folder;
};

TEST_F(CommandTest, HelpAndVersion) {
  const Outcome version = run({"--version"}), help = run({"--help"}),
                hilfe = run({"--help"}, {{"LANG", "ja_JP.UTF-8"}});
  EXPECT_EQ(version.status, 0);
  EXPECT_TRUE(version.out.starts_with("shadebench "));
  EXPECT_EQ(help.status, 0);
  for (const char* word : {"render", "compare", "plan", "radiosity", "trade", "teapot", "Usage: "})
    EXPECT_NE(help.out.find(word), std::string::npos) << help.out;
  EXPECT_NE(hilfe.out.find("使い方"), std::string::npos);
  EXPECT_EQ(hilfe.out.find("Usage"), std::string::npos) << hilfe.out;
  EXPECT_EQ(run({"render", "--help"}).status, 0);
  EXPECT_NE(run({"compare", "--help"}).out.find("--max-error"), std::string::npos);
}

TEST_F(CommandTest, RenderWritesEachKindOfFile) {
  for (const char* name : {"a.png", "a.jpg", "a.exr", "a.hdr", "名 前.png"}) {
    const Outcome o = run({"render", "teapot", "-o", name, "--size", "64x48"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_EQ(o.out + o.err, "");
    EXPECT_GT(bytes(name).size(), 100u);
  }
}

TEST_F(CommandTest, ThePictureDoesNotDependOnThreadsRunOrLocale) {
  const auto draw = [&](const std::string& name, const std::string& threads, const Environment& e) {
    EXPECT_EQ(run({"render", "teapot", "-o", name, "--size", "96x96", "--threads", threads, "--set",
                   "shading.mode=phong", "--set", "material.k_d=0.25,0.5,0.75"},
                  e)
                  .status,
              0);
    return bytes(name);
  };
  const std::string one = draw("1.exr", "1", {});
  EXPECT_TRUE(draw("2.exr", "2", {}) == one);
  EXPECT_TRUE(draw("3.exr", "7", {{"LC_ALL", "de_DE.UTF-8"}}) == one);
  EXPECT_TRUE(draw("4.exr", "1", {{"LC_ALL", "ja_JP.UTF-8"}}) == one);
}

TEST_F(CommandTest, SetChangesThePicture) {
  const auto draw = [&](const std::vector<std::string>& settings) {
    std::vector<std::string> arguments{"render", "torus", "-o", "a.png", "--size", "64x64"};
    for (const std::string& s : settings) arguments.insert(arguments.end(), {"--set", s});
    const Outcome o = run(arguments);
    EXPECT_EQ(o.status, 0) << o.err;
    return bytes("a.png");
  };
  const std::string plain = draw({});
  EXPECT_FALSE(draw({"material.k_d=0.1"}) == plain);
  EXPECT_FALSE(draw({"lights.1.position=-5,0,0", "lights.1.kind=directional"}) == plain);
  EXPECT_FALSE(draw({"objects.0.tessellation=12"}) == plain);
  EXPECT_TRUE(draw({"material.k_d=0.1", "material.k_d=0.8"}) == plain);
}

TEST_F(CommandTest, CompareInJson) {
  const Outcome o = run({"compare", "cube", "--left", "software", "--right", "software", "--size", "40x30", "--json"});
  ASSERT_EQ(o.status, 0) << o.err;
  const Tree t = parse_json(o.out, "compare");
  EXPECT_EQ(*t.find("left")->string(), "software");
  EXPECT_EQ(*t.find("right")->string(), "software");
  EXPECT_EQ(*t.find("width")->number(), 40);
  EXPECT_EQ(*t.find("height")->number(), 30);
  for (const char* zero : {"coverage_mismatch", "max_error", "rmse", "over_1_255"})
    EXPECT_EQ(*t.find(zero)->number(), 0) << zero;
  EXPECT_TRUE(t.find("psnr")->is_null());
  EXPECT_GT(*t.find("left_ms")->number(), 0);
  EXPECT_GT(*t.find("right_ms")->number(), 0);
}

TEST_F(CommandTest, CompareWithOpenGl) {
  const Outcome o = run({"compare", "teapot", "--size", "128x128", "--json", "-o", "差.png", "--max-error", "2/255"});
  if (o.status == 2) GTEST_SKIP() << "no OpenGL here: " << o.err;
  EXPECT_EQ(o.status, 0) << o.err << o.out;
  const Tree t = parse_json(o.out, "compare");
  EXPECT_EQ(*t.find("left")->string(), "gl-fixed");
  EXPECT_LE(*t.find("max_error")->number(), 2.0 / 255);
  EXPECT_GT(bytes("差.png").size(), 100u);
  EXPECT_EQ(run({"compare", "teapot", "--size", "64x64", "--max-error", "0"}).status, 1);
  EXPECT_NE(run({"compare", "teapot", "--size", "64x64"}, {{"LANG", "ja_JP.UTF-8"}}).out.find("最大誤差"),
            std::string::npos);
  const Outcome phong = run({"compare", "teapot", "--size", "64x64", "--set", "shading.mode=phong", "--json"});
  EXPECT_EQ(*parse_json(phong.out, "compare").find("left")->string(), "gl");
}

TEST_F(CommandTest, Plan) {
  const Outcome text = run({"plan", "teapot"}), json = run({"plan", "teapot", "--json"}, {{"LC_ALL", "de_DE.UTF-8"}});
  EXPECT_EQ(text.status, 0);
  EXPECT_NE(text.out.find("  + "), std::string::npos);
  const Tree t = parse_json(json.out, "plan");
  EXPECT_EQ(*t.find("technique")->string(), "software");
  ASSERT_FALSE(t.find("passes")->list()->empty());
  for (const Tree& pass : *t.find("passes")->list()) {
    EXPECT_FALSE(pass.find("id")->string()->empty());
    EXPECT_FALSE(pass.find("reason")->string()->empty());
    EXPECT_EQ(*pass.find("needed")->boolean(), *pass.find("ran")->boolean());
    EXPECT_TRUE(*pass.find("needed")->boolean() || *pass.find("held_bytes")->number() == 0);
    EXPECT_GE(*pass.find("ms")->number(), 0);
  }
  EXPECT_TRUE(*t.find("agrees")->boolean());
  EXPECT_GT(*t.find("ms")->number(), 0);
  const Tree undrawn = parse_json(run({"plan", "teapot", "--json", "--repeats", "0"}).out, "plan");
  EXPECT_FALSE(undrawn.find("ms"));
  EXPECT_EQ(undrawn.find("passes")->list()->size(), t.find("passes")->list()->size());
  EXPECT_NE(run({"plan", "teapot"}, {{"LANG", "ja_JP.UTF-8"}}).out.find("省いたもの"), std::string::npos);
  EXPECT_EQ(run({"plan", "teapot", "--repeats", "-1"}).status, 2);
}

TEST_F(CommandTest, FilesAndPresetsWithAnyName) {
  save_file(folder / "三 角 'x\".obj", triangle);
  save_file(folder / "a b.json", R"({"schema": 1, "model": "三 角 'x\".obj", "material": {"k_d": [1, 0, 0]}})");
  EXPECT_EQ(run({"render", "三 角 'x\".obj", "-o", "a.png", "--size", "32x32"}).status, 0);
  EXPECT_EQ(run({"render", "a b.json", "-o", "b.png", "--size", "32x32"}).status, 0);
  EXPECT_FALSE(bytes("a.png") == bytes("b.png"));
}

TEST_F(CommandTest, MistakesAreOneLine) {
  const auto says = [&](const std::vector<std::string>& arguments, const std::string& part) {
    const std::string error = mistake(arguments);
    EXPECT_NE(error.find(part), std::string::npos) << error;
  };
  says({"render", "teapot", "--frob", "-o", "a.png"}, "--frob: there is no such option; known are: ");
  says({"rendr", "teapot"}, "the commands are: render, compare, ");
  says({"render", "teapot", "-o"}, "-o");
  says({"render", "-o", "a.png"}, "no scene is named");
  says({"render", "teapot"}, "no file is named");
  says({"render", "teapto", "-o", "a.png"}, "teapto: there is no such model");
  says({"render", "none.json", "-o", "a.png"}, "none.json");
  says({"render", "teapot", "-o", "a.png", "--technique", "magic"}, "magic: there is no such technique; known are: ");
  says({"render", "teapot", "-o", "a.xyz"}, "a.xyz");
  says({"render", "teapot", "-o", "none/a.png"}, "none/a.png");
  for (const char* size : {"0x5", "5", "axb", "-5x5", "16385x1", "5x", "1e2x1"})
    says({"render", "teapot", "-o", "a.png", "--size", size}, "--size");
  says({"render", "teapot", "-o", "a.png", "--threads", "0"}, "--threads");
  says({"render", "teapot", "-o", "a.png", "--set", "material.kd=1"}, "material.k_d");
  says({"render", "teapot", "-o", "a.png", "--set", "material.n=nan"}, "give a number from 0 to 1000000");
  says({"render", "teapot", "-o", "a.png", "--set", "material.n"}, "there is no value");
  says({"compare", "teapot", "--max-error", "x"}, "--max-error");
  says({"--set", "a=1", "render", "teapot", "-o", "a.png"}, "--set");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST_F(CommandTest, BadModelsAreOneLineInEitherLanguage) {
  save_file(folder / "bad.obj", "v 0 0 0\nv 1 0 0\nf 1 2 99\n");
  EXPECT_NE(mistake({"plan", "bad.obj"}).find("bad.obj:3"), std::string::npos);
  EXPECT_NE(mistake({"plan", "bad.obj"}, {{"LC_ALL", "ja_JP.UTF-8"}}).find("bad.obj:3"), std::string::npos);
  save_file(folder / "bad.json", "{\"schema\": 1,\n \"materal\": {}}");
  EXPECT_NE(mistake({"plan", "bad.json"}).find("materal"), std::string::npos);
  EXPECT_NE(mistake({"plan", "nix"}, {{"LANG", "ja"}}).find("そのようなモデルはありません"), std::string::npos);
}

TEST_F(CommandTest, AFullDiskIsSaidAndTheOldPictureStays) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  mistake({"render", "cube", "-o", "/dev/full", "--size", "32x32"});
  EXPECT_EQ(run({"render", "cube", "-o", "a.png", "--size", "32x32"}).status, 0);
  const std::string before = bytes("a.png");
  std::filesystem::create_directory(folder / "sub");
  mistake({"render", "cube", "-o", "sub", "--size", "32x32"});
  EXPECT_TRUE(bytes("a.png") == before);
}

TEST_F(CommandTest, WithoutADisplayItComparesTheFirstScene) {
  const Outcome o = run({});
  if (o.status == 2) GTEST_SKIP() << "no OpenGL here: " << o.err;
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_NE(o.out.find("teapot"), std::string::npos);
  EXPECT_NE(o.out.find("largest error"), std::string::npos);
  for (const char* name : {"gl-fixed.png", "software.png", "difference.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / ".cache/shadebench" / name)) << name;
}

TEST_F(CommandTest, ProbeSaysWhatAPixelIsMadeOf) {
  const Outcome o = run({"probe", "teapot", "--pixel", "30,24", "--size", "64x48", "--json"});
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.err, "");
  const Tree tree = parse_json(o.out, "probe");
  for (const char* key : {"pixel", "technique", "terms", "sum", "clamped", "frame", "covered", "N", "V", "lights"})
    EXPECT_TRUE(tree.find(key)) << key;
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(*tree.find("clamped")->list()->at(c).number(), *tree.find("frame")->list()->at(c).number(), 1e-5);
  EXPECT_NE(run({"probe", "teapot", "--pixel", "30,24"}).out.find("in the picture"), std::string::npos);
  EXPECT_NE(run({"probe", "teapot", "--pixel", "30,24"}, {{"LANG", "ja_JP.UTF-8"}}).out.find("画像の値"),
            std::string::npos);
  for (const char* pixel : {"", "3", "3,", "-1,3", "64,3", "3,48", "a,b", "3,4,5"})
    EXPECT_NE(mistake({"probe", "teapot", "--size", "64x48", "--pixel", pixel}).find("63,47"), std::string::npos);
}

TEST_F(CommandTest, ExportWritesEachFormat) {
  EXPECT_EQ(run({"export", "teapot", "--as", "glut", "-o", "a b.c", "--set", "material.n=300"}).err, "");
  EXPECT_NE(bytes("a b.c").find("int main( int argc, char *argv[] )"), std::string::npos);
  EXPECT_NE(bytes("a b.c").find("GL_SHININESS, 128.0 );"), std::string::npos);
  EXPECT_TRUE(bytes("a b.obj").starts_with("# Exported by Shadebench\n"));
  for (const char* name : {"a.c", "a.obj", "a.json"}) {
    EXPECT_EQ(run({"export", "torus", "-o", name}, {{"LC_ALL", "de_DE.UTF-8"}}).status, 0);
    EXPECT_GT(bytes(name).size(), 20u);
  }
  EXPECT_EQ(run({"export", "a.json", "-o", "b.c"}).status, 0);
  EXPECT_EQ(bytes("a.c"), bytes("b.c"));
}

TEST_F(CommandTest, ExportRefusesWhatCannotBe) {
  EXPECT_NE(mistake({"export", "teapot", "--as", "pdf", "-o", "a.pdf"}).find("json, c, glut, obj"), std::string::npos);
  EXPECT_NE(mistake({"export", "teapot", "-o", "a.png"}).find("json, c, glut, obj"), std::string::npos);
  EXPECT_NE(mistake({"export", "teapot", "--as", "c"}).find("-o"), std::string::npos);
  EXPECT_NE(mistake({"export", "teapot", "--as", "glut", "-o", "a.obj"}).find("a.c would work"), std::string::npos);
  EXPECT_NE(mistake({"export", "teapot", "--as", "c", "-o", "no/such/a.c"}).find("no/such"), std::string::npos);
}

}  // namespace
}  // namespace cg
