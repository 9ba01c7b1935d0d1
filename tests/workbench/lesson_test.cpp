// Lessons: texts, files that change or are damaged, numbers, tasks.
#include "workbench/lesson.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "params/file.h"
#include "params/input_error.h"
#include "raster/software.h"
#include "tests/temporary_folder.h"
#include "workbench/data_folder.h"
#include "workbench/lesson_check.h"
#include "workbench/lesson_expression.h"
#include "workbench/lesson_json.h"
#include "workbench/lesson_watcher.h"
#include "workbench/open.h"
#include "workbench/preset.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

constexpr const char* english = R"(# Light

What it is *about*.

## First step {#one}

Red is {{red}}, n is {{material.n}}: $k_d (N·L)^{n}$.

- [ ] Make it darker. {#darker}

> Why?
>
> - [ ] Because.
> - [x] Hence.
>
> ---
>
> It is {{red}}.
)";
constexpr const char* japanese = R"(# 光

これは
光の話である。

## 最初 {#one}

赤は {{red}}、n は {{material.n}}。

- [ ] 暗くする。 {#darker}

> なぜか。
>
> - [ ] だから。
> - [x] ゆえに。
>
> ---
>
> {{red}} だから。
)";
constexpr const char* json = R"({
  "schema": 1,
  "steps": [
    {"id": "one",
     "scene": {"model": "uv-sphere", "material": {"k_a": 0.5, "k_d": 0, "k_s": 0}, "shading": {"ambient": 0.4}},
     "view": {"left": "software"},
     "offer": ["material.k_a"],
     "numbers": {
       "red": {"measure": "mean", "channel": "red", "size": 16, "expect": "shading.ambient.r*material.k_a.r",
               "tolerance": 1e-6, "source": "I_a k_a"}
     },
     "tasks": [{"id": "darker", "measure": "mean", "size": 16, "goal": "start/2", "tolerance": 0.01,
                "solution": {"material": {"k_a": 0.25}}}]}
  ]
}
)";

// A lesson's folder with these files.
void write(const TemporaryFolder& folder, std::string_view data = json, std::string_view en = english,
           std::string_view ja = japanese) {
  save_file(folder / "lesson.json", data);
  save_file(folder / "lesson.en.md", en);
  save_file(folder / "lesson.ja.md", ja);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  return at == text.npos ? text : text.replace(at, what.size(), by);
}

InputError error_of(const fs::path& folder) {
  try {
    read_lesson(folder);
  } catch (const InputError& e) {
    EXPECT_FALSE(e.message(Language::english).empty());
    EXPECT_FALSE(e.message(Language::japanese).empty());
    return e;
  }
  ADD_FAILURE() << "was read";
  return InputError("", {});
}

TEST(LessonText, BecomesBlocks) {
  const LessonText text = parse_lesson_text(english, "lesson.en.md");
  ASSERT_EQ(text.sections.size(), 2u);
  EXPECT_EQ(text.sections[0].title, "Light");
  const TextSection& step = text.sections[1];
  EXPECT_EQ(step.id, "one");
  EXPECT_EQ(step.title, "First step");
  EXPECT_EQ(step.line, 5);
  ASSERT_EQ(step.blocks.size(), 3u);
  ASSERT_EQ(step.blocks[0].runs.size(), 3u);
  EXPECT_EQ(step.blocks[0].runs[1], (TextRun{TextRun::formula, "k_d (N·L)^{n}"}));
  EXPECT_EQ(step.blocks[1].kind, TextBlock::task);
  EXPECT_EQ(step.blocks[1].id, "darker");
  EXPECT_EQ(step.blocks[1].runs, (std::vector{TextRun{TextRun::plain, "Make it darker."}}));
  const TextBlock& question = step.blocks[2];
  EXPECT_EQ(question.kind, TextBlock::question);
  ASSERT_EQ(question.choices.size(), 2u);
  EXPECT_FALSE(question.choices[0].right);
  EXPECT_TRUE(question.choices[1].right);
  EXPECT_EQ(question.inner.size(), 1u);
  EXPECT_EQ(question.answer.size(), 1u);
  EXPECT_EQ(numbers_in(step.blocks), (std::vector<std::string>{"red", "material.n"}));
}

TEST(LessonText, JoinsJapaneseLinesWithoutABlank) {
  const LessonText text = parse_lesson_text(japanese, "lesson.ja.md");
  ASSERT_EQ(text.sections[0].blocks.size(), 1u);
  EXPECT_EQ(text.sections[0].blocks[0].runs[0].text, "これは光の話である。");
  EXPECT_EQ(parse_lesson_text("# A\n\nfirst\nsecond", "").sections[0].blocks[0].runs[0].text, "first second");
}

// A blank beside a formula is of the text, or the formula's typesetting would lose it.
TEST(LessonText, ALineThatEndsInAFormulaKeepsItsBlank) {
  const auto runs = [](const char* text) { return parse_lesson_text(text, "").sections[0].blocks[0].runs; };
  EXPECT_EQ(runs("# A\n\n$B$\nis $E$\n"),
            (std::vector<TextRun>{{TextRun::formula, "B"}, {TextRun::plain, " is "}, {TextRun::formula, "E"}}));
  EXPECT_EQ(runs("# A\n\n$B$\n$E$\n"),
            (std::vector<TextRun>{{TextRun::formula, "B"}, {TextRun::plain, " "}, {TextRun::formula, "E"}}));
  EXPECT_EQ(runs("# A\n\na\n$E$\n"), (std::vector<TextRun>{{TextRun::plain, "a "}, {TextRun::formula, "E"}}));
}

TEST(LessonText, ListsAndListings) {
  const auto blocks =
      parse_lesson_text("# A\n\n1. one\n2. two\n   - deep\n\n```c\nint a;\n\nint b;\n```\n\n$$a = b$$\n", "")
          .sections[0]
          .blocks;
  ASSERT_EQ(blocks.size(), 5u);
  EXPECT_EQ(blocks[0].kind, TextBlock::numbered);
  EXPECT_EQ(blocks[1].number, 2);
  EXPECT_EQ(blocks[2].kind, TextBlock::bullet);
  EXPECT_EQ(blocks[2].level, 1);
  EXPECT_EQ(blocks[3].lines, (std::vector<std::string>{"int a;", "", "int b;"}));
  EXPECT_EQ(blocks[4].kind, TextBlock::formula);
}

TEST(LessonText, FillsInItsNumbers) {
  const auto number = [](std::string_view name) {
    return name == "a" ? std::optional<std::string>("1.5") : std::nullopt;
  };
  EXPECT_EQ(filled("x {{a}}/{{b}} y", number), "x 1.5/… y");
  const TextSection step = parse_lesson_text(english, "").sections[1];
  const auto all = filled(step.blocks, [](std::string_view) { return std::optional<std::string>("7"); });
  EXPECT_EQ(all[0].runs[0].text, "Red is 7, n is 7: ");
  EXPECT_EQ(all[2].answer[0].runs[0].text, "It is 7.");
}

TEST(LessonText, SaysTheLineOfAMistake) {
  const std::pair<const char*, long> mistakes[] = {
      {"no title", 1},
      {"# A\n\n## No id\n", 3},
      {"# A\n\n## B {#b}\n\n## C {#b}\n", 5},
      {"# A\n\nbad \xff bytes", 3},
      {"# A\n\nA {{name} is open.", 3},
      {"# A\n\nA $formula is open.", 3},
      {"# A\n\nA $x^{2$ brace.", 3},
      {"# A\n\n<b>bold</b>", 3},
      {"# A\n\n| a | b |\n|---|---|\n| 1 | 2 |", 3},
      {"# A\n\n![picture](a.png)", 3},
      {"# A\n\n- [ ] task without a name", 3},
      {"# A\n\ntext\n\n> Q?\n>\n> - [x] a\n", 7},
      {"# A\n\n# B\n", 3},
      {"# A\n\n&copy;\n", 3},
  };
  for (const auto& [text, line] : mistakes) try {
      parse_lesson_text(text, "lesson.en.md");
      ADD_FAILURE() << text;
    } catch (const InputError& e) {
      EXPECT_EQ(e.line, line) << text << " " << e.message(Language::english);
    }
}

TEST(LessonExpression, IsArithmetic) {
  const VariableOf variable = [](std::string_view name) { return name == "a.b" ? std::optional(3.0) : std::nullopt; };
  const auto value = [&](std::string_view text) { return evaluate(text, variable, "test"); };
  EXPECT_EQ(value("1 + 2*3"), 7);
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("(1 - 3)/4"), -0.5);
  EXPECT_EQ(value("a.b * 1e2"), 300);
  EXPECT_NEAR(value("degrees(acos(2^(-1/100)))"), 6.738, 5e-4);  // the half-angle of cos^100
  EXPECT_NEAR(value("atan2(1, 1)"), std::atan(1.0), 1e-15);
  for (const char* bad :
       {"", "1 +", "(1", "1)", "b", "sqrt", "sqrt(1, 2)", "1/0", "sqrt(-1)", "2 3", "1..2", "0x10", "$"})
    EXPECT_THROW(value(bad), InputError) << bad;
  EXPECT_THROW(value(std::string(10000, '(')), InputError);
  EXPECT_EQ(value(std::string(10000, '-') + "1"), 1);
}

TEST(Lesson, IsReadFromItsFolder) {
  TemporaryFolder folder;
  write(folder);
  const Lesson lesson = read_lesson(folder.path());
  ASSERT_EQ(lesson.steps.size(), 1u);
  EXPECT_EQ(lesson.in(Language::japanese).title, "光");
  EXPECT_EQ(lesson.steps[0].in(Language::english).title, "First step");
  EXPECT_EQ(lesson.steps[0].view.left, "software");
  EXPECT_EQ(lesson.steps[0].offered, (std::vector<std::string>{"material.k_a"}));
  EXPECT_EQ(scene_of_step(lesson, 0).shading.ambient, glm::dvec3(0.4));
}

TEST(Lesson, AStepChangesTheOneBefore) {
  const auto steps = parse_lesson_json(
      R"({"schema": 1, "steps": [
        {"id": "a", "scene": {"model": "cube", "lights": {"1": {"kind": "spot"}}}, "view": {"view": "wipe"}},
        {"id": "b", "scene": {"lights": {"1": null}, "material": {"n": 8}}}]})",
      "lesson.json");
  EXPECT_EQ(scene_of(steps[0].preset, "a").lights.size(), 2u);
  const Scene second = scene_of(steps[1].preset, "b");
  EXPECT_EQ(second.lights.size(), 1u);
  EXPECT_EQ(second.material.n, 8);
  EXPECT_EQ(second.objects.at(0).model, "cube");
  EXPECT_EQ(steps[1].view.view, ViewMode::wipe);
}

TEST(Lesson, AMistakeNamesFileAndLine) {
  TemporaryFolder folder;
  const auto mistake = [&](const std::string& what, const std::string& by, long line) {
    write(folder, replaced(json, what, by));
    const InputError e = error_of(folder.path());
    EXPECT_NE(e.where.find("lesson.json"), e.where.npos) << e.where;
    EXPECT_EQ(e.line, line) << e.message(Language::english);
  };
  mistake("\"schema\": 1,", "\"schema\": 1", 3);
  mistake("\"offer\"", "\"offers\"", 7);
  mistake("\"measure\": \"mean\", \"channel\"", "\"measure\": \"meen\", \"channel\"", 9);
  mistake("\"channel\": \"red\"", "\"channel\": \"rot\"", 9);
  mistake("\"size\": 16, \"expect\"", "\"size\": 1e9, \"expect\"", 9);
  mistake("\"tolerance\": 1e-6, ", "", 9);
  mistake("\"goal\"", "\"gaol\"", 12);
  mistake("{\"left\": \"software\"}", "{\"left\": 3}", 6);

  write(folder, json, replaced(english, "{#one}", "{#two}"));
  EXPECT_NE(error_of(folder.path()).where.find("lesson.en.md"), std::string::npos);
  write(folder, json, english, replaced(japanese, "{{red}}、", "{{green}}、"));
  EXPECT_EQ(error_of(folder.path()).line, 6);
  write(folder, json, replaced(english, "{#darker}", "{#lighter}"));
  EXPECT_EQ(error_of(folder.path()).line, 9);
  fs::remove(folder / "lesson.ja.md");
  write(folder);
  fs::remove(folder / "lesson.ja.md");
  EXPECT_NE(error_of(folder.path()).where.find("lesson.ja.md"), std::string::npos);
}

TEST(LessonWatcher, KeepsTheLastGoodVersion) {
  TemporaryFolder folder;
  write(folder);
  LessonWatcher watcher(folder.path());
  ASSERT_TRUE(watcher.lesson());
  EXPECT_FALSE(watcher.poll());
  save_file(folder / "lesson.en.md", "broken");
  EXPECT_TRUE(watcher.poll());
  ASSERT_TRUE(watcher.error());
  EXPECT_EQ(watcher.lesson()->in(Language::english).title, "Light");
  save_file(folder / "lesson.en.md", replaced(english, "# Light", "# Brighter light"));
  EXPECT_TRUE(watcher.poll());
  EXPECT_FALSE(watcher.error());
  EXPECT_EQ(watcher.lesson()->in(Language::english).title, "Brighter light");
}

std::vector<LessonFinding> findings_of(const TemporaryFolder& folder) {
  const std::vector<Technique> techniques{software_technique()};
  Progress progress;
  return check_lesson(folder.path(), techniques, progress);
}

TEST(LessonCheck, FindsWhatIsOff) {
  TemporaryFolder folder;
  write(folder, replaced(json, "\"left\": \"software\"", "\"left\": \"software\", \"right\": \"software\""));
  for (const LessonFinding& f : findings_of(folder)) EXPECT_TRUE(f.holds) << f.name << ": " << f.note.en;
  EXPECT_EQ(findings_of(folder).size(), 2u);

  const auto off = [&](const std::string& what, const std::string& by, const std::string& name) {
    write(folder, replaced(json, what, by));
    std::string names;
    bool found = false;
    for (const LessonFinding& f : findings_of(folder))
      names += f.name + " ", found = found || (!f.holds && f.name == name);
    EXPECT_TRUE(found) << by << ": " << names;
  };
  off("shading.ambient.r*", "2*shading.ambient.r*", "red");
  off("shading.ambient.r*", "shading.ambience*", "red");
  off("\"goal\": \"start/2\"", "\"goal\": \"start\"", "darker");
  off("{\"k_a\": 0.25}", "{\"k_a\": 0.3}", "darker");
  off("[\"material.k_a\"]", "[\"material.k_z\"]", "offer");
  off("\"ambient\": 0.4", "\"ambience\": 0.4", "scene");
  off("\"left\": \"software\"", "\"left\": \"watercolour\"", "view");
  write(folder, json, english, replaced(japanese, "- [ ] だから。\n", ""));
  // One choice stays: the texts no longer ask the same.
  write(folder, json, english, replaced(japanese, "> - [ ] だから。\n", ""));
  bool found = false;
  for (const LessonFinding& f : findings_of(folder)) found = found || (!f.holds && f.name == "text");
  EXPECT_TRUE(found);
}

TEST(LessonNumbers, FollowTheStudentsScene) {
  TemporaryFolder folder;
  write(folder);
  const Lesson lesson = read_lesson(folder.path());
  const std::vector<Technique> techniques{software_technique()};
  Progress progress;
  SolvedScenes solved;
  Scene scene = scene_of_step(lesson, 0);
  scene.material.k_a = glm::dvec3(1);
  const auto results = compute_numbers(lesson.steps[0], preset_of(scene), lesson.folder, techniques, progress, solved);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_TRUE(results[0].holds());
  EXPECT_EQ(text_of_number("red", results, scene), "0.4");
  EXPECT_EQ(text_of_number("material.n", results, scene), "32");
  EXPECT_EQ(text_of_number("lights.0.position.y", results, scene), "10");
  EXPECT_EQ(text_of_number("nothing", results, scene), std::nullopt);
}

TEST(LessonNumbers, ACircleIsAProblemAndNoCrash) {
  const auto steps = parse_lesson_json(
      R"({"schema": 1, "steps": [{"id": "a", "scene": {"model": "cube"},
          "numbers": {"p": {"value": "q"}, "q": {"value": "p + 1"}}}]})",
      "lesson.json");
  Progress progress;
  SolvedScenes solved;
  for (const NumberResult& r : compute_numbers(steps[0], steps[0].preset, {}, {}, progress, solved))
    EXPECT_TRUE(r.problem);
}

// Whatever bytes a file holds: read or refused in one line, in bounded time.
TEST(Lesson, AnyBytesAreReadOrRefused) {
  std::mt19937 random(20260731);
  const std::string alphabet = "#$*_`>-[]x {}|<&;\n\n\\!()\"',:0123456789abc.\xe3\x81\x82\xff\t";
  const auto one_line = [](const InputError& e) {
    for (const Language language : {Language::english, Language::japanese})
      EXPECT_EQ(e.message(language).find('\n'), std::string::npos);
  };
  for (int i = 0; i < 3000; ++i) {
    std::string text = i % 3 == 0 ? std::string("# A\n") : i % 3 == 1 ? english : json;
    for (int k = 0; k < int(random() % 60); ++k) {
      const std::size_t at = random() % (text.size() + 1);
      if (random() % 3 == 0 && at < text.size())
        text.erase(at, random() % 8);
      else
        text.insert(at, std::string(1 + random() % 3, alphabet[random() % alphabet.size()]));
    }
    try {
      parse_lesson_text(text, "lesson.en.md");
    } catch (const InputError& e) {
      one_line(e);
    }
    try {
      parse_lesson_json(text, "lesson.json");
    } catch (const InputError& e) {
      one_line(e);
    }
  }
}

TEST(Lesson, DeepAndLongTextsAreRefused) {
  std::string deep = "# A\n\n";
  for (int i = 0; i < 5000; ++i) deep += '>';
  EXPECT_THROW(parse_lesson_text(deep + " a", ""), InputError);
  std::string lists = "# A\n\n";
  for (int i = 0; i < 40; ++i) lists += std::string(std::size_t(2 * i), ' ') + "- a\n";
  EXPECT_THROW(parse_lesson_text(lists, ""), InputError);
  EXPECT_THROW(parse_lesson_text(std::string(2 << 20, 'a'), ""), InputError);
  EXPECT_NO_THROW(parse_lesson_text("# A\n\n" + std::string(1000000, '*'), ""));
}

// ---- the lessons that come with the program ----

TEST(ShippedLessons, OpenAsScenesByTheirNames) {
  const auto folders = lesson_folders(data_folder() / "lessons");
  ASSERT_FALSE(folders.empty());
  for (const fs::path& folder : folders) {
    const Lesson lesson = read_lesson(folder);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i)
      EXPECT_EQ(open_scene(lesson.id + ":" + std::to_string(i + 1)), scene_of_step(lesson, i));
    EXPECT_EQ(open_scene(lesson.id), scene_of_step(lesson, 0));
    EXPECT_THROW(open_scene(lesson.id + ":0"), InputError);
    EXPECT_THROW(open_scene(lesson.id + ":99"), InputError);
    EXPECT_THROW(open_scene(lesson.id + ":1x"), InputError);
  }
}

}  // namespace
}  // namespace cg
