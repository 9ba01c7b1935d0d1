// A lesson: steps, each a scene, a text in both languages, the parameters it offers, numbers and tasks. It is data
// alone, a folder lessons/NN-topic/ with
//   lesson.json                     scenes, numbers, tasks
//   lesson.en.md, lesson.ja.md      the texts (workbench/lesson_text.h), a section for each step, joined by its id
//
//   {"schema": 1, "steps": [
//     {"id": "diffuse",
//      "scene": {"model": "teapot", "material": {"k_a": 0}},   a preset; from the second step on a merge patch (RFC
//                                                              7396) on the step before, so it says what changes
//      "view": {"left": "gl-fixed", "right": "software"},      how it is looked at, patched the same way
//      "offer": ["material.k_d", "lights.0.position"],
//      "numbers": {"peak": {"measure": "brightest", "expect": "material.k_d", "tolerance": 1e-3, "source": "N·L = 1"}},
//      "tasks": [{"id": "half", "measure": "brightest", "goal": "start/2", "tolerance": 0.01,
//                 "solution": {"material": {"k_d": 0.4}}}]}]}
//
// No result is written by hand: a text says {{peak}}, and what a number is expected to be is an expression
// (workbench/lesson_expression.h) or another technique's picture, so that a lesson's check compares two derivations.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "params/field.h"
#include "scene/scene.h"
#include "workbench/hemicube_show.h"
#include "workbench/lesson_text.h"
#include "workbench/measurement.h"
#include "workbench/view_mode.h"

namespace cg {

// How a step wants to be looked at: the window's settings of the same names.
struct LessonView {
  std::string left = "gl-fixed", right = "software";  // ids of techniques
  ViewMode view = ViewMode::two;
  LightTerm term = LightTerm::all;  // drawn alone,
  int light = -1;                   // of that light (all_lights, no_light as in workbench/isolate.h)
  bool handles = true, vertex_normals = false, face_normals = false, wireframe = false, axes = false, clamped = false;
  std::string knob, extreme;  // what the panels of trades and extremes have open; empty: as they are
  std::string panel;          // the panel that a button above the text opens: "solver"; empty: none
  // What the panel of the hemicube shows: of which patch, seeing which other, from which of its positions. -1: one that
  // is in the middle of the picture, or seen best; the panel is as it was where no step has named a patch.
  int patch = -1, other_patch = -1, position = 0;
  HemicubeShow hemicube = HemicubeShow::items;
  friend bool operator==(const LessonView&, const LessonView&) = default;
};

template <>
inline constexpr auto fields_of<LessonView> = std::tuple{
    field(&LessonView::left, {.name = "left", .label = {"Left technique", "左の手法"}}),
    field(&LessonView::right, {.name = "right", .label = {"Right technique", "右の手法"}}),
    field(&LessonView::view, {.name = "view", .label = {"View", "見方"}}),
    field(&LessonView::term, {.name = "term", .label = {"Term", "項"}}),
    field(&LessonView::light, {.name = "light", .range = {-2, 63}, .label = {"Light", "光源"}}),
    field(&LessonView::handles, {.name = "handles", .label = {"Lights in the picture", "光源を表示"}}),
    field(&LessonView::vertex_normals, {.name = "vertex_normals", .label = {"Vertex normals", "頂点の法線"}}),
    field(&LessonView::face_normals, {.name = "face_normals", .label = {"Face normals", "面の法線"}}),
    field(&LessonView::wireframe, {.name = "wireframe", .label = {"Wireframe", "ワイヤーフレーム"}}),
    field(&LessonView::axes, {.name = "axes", .label = {"Axes", "座標軸"}}),
    field(&LessonView::clamped, {.name = "clamped", .label = {"Clamped pixels", "クランプ画素"}}),
    field(&LessonView::knob, {.name = "knob", .label = {"Trade", "速さと精度"}}),
    field(&LessonView::extreme, {.name = "extreme", .label = {"Extreme", "極端な値"}}),
    field(&LessonView::panel, {.name = "panel", .label = {"Panel", "パネル"}}),
    field(&LessonView::patch, {.name = "patch", .range = {-1, 1 << 22}, .label = {"Patch", "パッチ"}}),
    field(&LessonView::other_patch,
          {.name = "other_patch", .range = {-1, 1 << 22}, .label = {"Seen patch", "見えるパッチ"}}),
    field(&LessonView::position, {.name = "position", .range = {0, 255}, .label = {"Position", "位置"}}),
    field(&LessonView::hemicube, {.name = "hemicube", .label = {"Hemicube", "ヘミキューブ"}}),
};

// A number of a step, which the program computes.
struct LessonNumber {
  std::string name;       // as in {{name}}
  Measuring measuring;    // what is measured, by which technique; measuring.what is null where `value` says it
  std::string value;      // an expression over the step's other numbers and parameters, or empty
  Tree scene, against;    // merge patches on the step's scene, and on that for the second of two scenes; null: none
  std::string expect;     // an expression; empty: nothing is expected (then it is only shown)
  std::string tolerance;  // an expression, absolute
  Text source;            // where the expected value comes from: "closed form: cos^n δ"
  int digits = 3;         // significant, in a text,
  int decimals = -1;      // and at most so many behind the point; -1: any
};

// What the student is asked to reach by turning parameters.
struct LessonTask {
  std::string id;  // as in the text: {#id}
  Measuring measuring;
  Tree against;           // a merge patch for the second of two scenes; null: none
  std::string goal;       // an expression; `start` is the measurement of the step's own scene
  std::string tolerance;  // an expression
  Tree solution;          // a merge patch that reaches the goal
};

struct LessonStep {
  std::string id;
  Tree preset;  // complete: the steps before it are merged in
  LessonView view;
  std::vector<std::string> offered;  // paths of slots(scene), in order; "lights.0" stands for all of its slots
  std::vector<LessonNumber> numbers;
  std::vector<LessonTask> tasks;
  TextSection text[2];  // by Language

  const TextSection& in(Language language) const { return text[int(language)]; }
};

struct Lesson {
  std::string id;  // the folder's name: "03-shading"
  std::filesystem::path folder;
  TextSection text[2];            // title and introduction, by Language
  std::vector<LessonStep> steps;  // at least one

  const TextSection& in(Language language) const { return text[int(language)]; }
};

// Reads the three files of a folder. Throws InputError with file and line. Scenes are not opened and nothing is
// measured: cheap enough for every change of a file.
Lesson read_lesson(const std::filesystem::path& folder);

// Where a step's model files are looked for, meshes loaded. May be called from any thread. Throws InputError that
// names lesson and step.
Scene scene_of_step(const Lesson& lesson, std::size_t step);

// The folders below `folder` that hold a lesson.json, sorted. The program's own are in data_folder() / "lessons".
std::vector<std::filesystem::path> lesson_folders(const std::filesystem::path& folder);

// A lesson's step as a person names it: "03-shading:2" is the second, "03-shading" the first; nothing where no lesson
// of the program has that name. Throws InputError where the step is not there.
struct StepName {
  std::filesystem::path folder;
  std::size_t step = 0;  // from 0
};
std::optional<StepName> find_step(const std::string& name);

}  // namespace cg
