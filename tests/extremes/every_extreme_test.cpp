// The table of extremes (src/measure), walked through every technique; and the walk itself, which must see what is
// wrong.
//
// What else is extreme, and where it is asserted:
//   random states of everything                    extremes_test.cpp, storm_main.cpp, gl/lighting_oracle_test.cpp
//   the same to rounding, in software              software_extremes_test.cpp
//   sizes, by each rule for the normals' length    gl/extremes_test.cpp
//   each broken file of hundreds                   scene/read_*_test.cpp, scene/bad_files_test.cpp
//   clipping at the eye                            raster/clip_test.cpp
//   cameras that a gesture can reach               workbench/camera_control_test.cpp
//   windows of size 0, time that stands still      ui/widgets_test.cpp
//   every range's ends, decimal commas             workbench/parameters_test.cpp
#include <gtest/gtest.h>

#include <set>
#include <thread>

#include "measure/extreme_run.h"
#include "params/input_error.h"
#include "tests/all_techniques.h"

namespace cg {
namespace {

class EveryExtreme : public testing::TestWithParam<std::string> {};

TEST_P(EveryExtreme, IsRightInEveryTechnique) {
  Progress progress;
  int drawn = 0;
  for (const ExtremeResult& r : run_extremes(find_extremes(GetParam(), extreme_cases()), all_techniques(), progress)) {
    EXPECT_FALSE(is_failure(r.verdict)) << r.subject->id << ", " << r.by << ": " << r.error << ", " << r.said.en;
    drawn += r.verdict == Verdict::right;
    // Only what the description of the fixed function leaves out is not drawn.
    EXPECT_TRUE(r.verdict != Verdict::not_drawn || r.by == "gl-fixed") << r.subject->id << ", " << r.by;
    EXPECT_TRUE(r.verdict != Verdict::not_drawn || !(r.said.en.empty() || r.said.ja.empty())) << r.subject->id;
  }
  EXPECT_GT(drawn, 0);
}

std::vector<std::string> group_ids() {
  std::vector<std::string> ids;
  for (const Name& group : extreme_groups()) ids.emplace_back(group.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Groups, EveryExtreme, testing::ValuesIn(group_ids()),
                         [](const auto& group) { return group.param; });

TEST(ExtremeTable, IsWellDescribed) {
  std::set<std::string> ids, groups;
  for (const Name& group : extreme_groups()) groups.emplace(group.id);
  EXPECT_GE(extreme_cases().size(), 60u);
  for (const ExtremeCase& c : extreme_cases()) {
    SCOPED_TRACE(c.id);
    EXPECT_TRUE(ids.insert(c.id).second);
    EXPECT_TRUE(groups.count(c.group));
    EXPECT_FALSE(groups.count(c.id));
    for (const Text& text : {c.name, c.right}) {
      EXPECT_FALSE(text.en.empty() || text.ja.empty());
      EXPECT_NE(text.en, text.ja);
    }
    EXPECT_FALSE(c.parameter.empty() || c.value.empty());
    EXPECT_TRUE(c.scene || c.input || c.naive);
    EXPECT_TRUE(!c.scene || (c.tolerance > 0 && c.tolerance <= 2.0 / 255));
    EXPECT_TRUE(!c.naive || c.naive->rows().size() >= 2u);
  }
  for (const std::string& group : groups) EXPECT_FALSE(find_extremes(group, extreme_cases()).empty()) << group;
}

TEST(ExtremeTable, IsFoundByCaseAndGroup) {
  EXPECT_EQ(find_extremes("", extreme_cases()).size(), extreme_cases().size());
  EXPECT_EQ(find_extremes("light-w-1e-30", extreme_cases()).size(), 1u);
  EXPECT_GE(find_extremes("lights", extreme_cases()).size(), 20u);
  try {
    find_extremes("no-such", extreme_cases());
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(e.accepted.en.find("materials"), std::string::npos);
  }
}

// ---- the walk sees what is wrong ----

// The software, with its frames spoilt.
Technique spoilt(std::function<void(const Scene&, Frame&)> spoil) {
  Technique t = software_technique();
  t.render = [render = t.render, spoil](const Scene& s, const Plan& p, const View& v, Progress& progress) {
    Frame frame = render(s, p, v, progress);
    spoil(s, frame);
    return frame;
  };
  return t;
}

std::vector<ExtremeResult> run_with(const Technique& technique, const std::string& name,
                                    const ExtremeLimits& limits = {}) {
  Progress progress;
  std::vector<ExtremeResult> out;
  for (const ExtremeCase* c : find_extremes(name, extreme_cases()))
    for (ExtremeResult& r : run_extreme(*c, std::vector{technique}, progress, limits)) out.push_back(std::move(r));
  return out;
}

void expect_all(const std::vector<ExtremeResult>& results, Verdict verdict) {
  EXPECT_FALSE(results.empty());
  for (const ExtremeResult& r : results) EXPECT_EQ(r.verdict, verdict) << r.subject->id << ": " << r.said.en;
}

// Of each group of scenes, what is compared with a closed form or the reference.
TEST(ExtremeWalk, SeesAWrongColour) {
  const Technique brighter = spoilt([](const Scene&, Frame& f) {
    for (glm::vec3& c : f.colour.pixels()) c += 0.02f;
  });
  for (const char* name : {"light-grazing-0", "lights-64", "light-inside", "attenuation-least-normal",
                           "material-n-1000000", "material-k-1", "spot-90-128", "camera-fov-170", "picture-64x1"})
    expect_all(run_with(brighter, name), Verdict::off);
}

// What is compared with another scene sees a technique that does not take the extreme as it should.
TEST(ExtremeWalk, SeesWhatTheExtremeAloneGetsWrong) {
  const Technique forgets_w = spoilt([](const Scene& s, Frame& f) {
    if (!s.lights.empty() && s.lights[0].w != 1)
      for (glm::vec3& c : f.colour.pixels()) c *= 0.9f;
  });
  expect_all(run_with(forgets_w, "light-w-1e-30"), Verdict::off);
  const Technique hole = spoilt([](const Scene& s, Frame& f) {
    if (s.objects[0].mesh->data().face_count() > 1)
      for (int x = 10; x < 30; ++x) f.covered.at(x, 24) = 0;
  });
  expect_all(run_with(hole, "mesh-sliver"), Verdict::off);
}

TEST(ExtremeWalk, SeesNanAsBroken) {
  const Technique counted = spoilt([](const Scene&, Frame& f) { f.nan_pixels = 3; });
  expect_all(run_with(counted, "light-at-the-eye"), Verdict::broken);
  const Technique uncounted = spoilt([](const Scene&, Frame& f) {
    for (glm::vec3& c : f.colour.pixels()) c.g = std::nanf("");
  });
  expect_all(run_with(uncounted, "light-at-the-eye"), Verdict::broken);
  expect_all(run_with(uncounted, "light-w-0"), Verdict::broken);
  expect_all(run_with(uncounted, "material-n-0"), Verdict::broken);
  expect_all(run_with(counted, "material-emission-nan"), Verdict::off);
}

TEST(ExtremeWalk, SeesAnExceptionAsBroken) {
  const Technique throws = spoilt([](const Scene&, Frame&) { throw std::runtime_error("out of luck"); });
  for (const ExtremeResult& r : run_with(throws, "lights")) {
    EXPECT_EQ(r.verdict, Verdict::broken) << r.subject->id;
    EXPECT_NE(r.said.en.find("out of luck"), std::string::npos);
  }
}

TEST(ExtremeWalk, SeesWorkThatDoesNotEnd) {
  Technique hangs = software_technique();
  hangs.render = [](const Scene&, const Plan&, const View&, Progress& progress) -> Frame {
    while (!progress.cancelled) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    throw Cancelled{};
  };
  const auto results = run_with(hangs, "light-inside", {.seconds = 0.05});
  expect_all(results, Verdict::broken);
  EXPECT_NE(results[0].said.en.find("did not end"), std::string::npos);
}

TEST(ExtremeWalk, SeesAMissingNoteAMissingRefusalAndAnEmptyPicture) {
  Technique silent = software_technique();
  silent.plan = [plan = silent.plan](const Scene& s, const View& v) {
    Plan p = plan(s, v);
    p.notes.clear();
    return p;
  };
  expect_all(run_with(silent, "light-w-1e-30"), Verdict::off);
  const Technique empty = spoilt([](const Scene&, Frame& f) {
    for (std::uint8_t& c : f.covered.pixels()) c = 0;
  });
  expect_all(run_with(empty, "light-negative"), Verdict::off);
  expect_all(run_with(empty, "camera-inside"), Verdict::off);
  Technique draws_all = software_technique();
  draws_all.render = [](const Scene&, const Plan&, const View&, Progress&) { return Frame{}; };
  expect_all(run_with(draws_all, "picture-20000x20000"), Verdict::off);
  expect_all(run_with(draws_all, "picture-0x5"), Verdict::off);
}

// A fault counts as the driver's where the picture is what the fault makes of it, and as the technique's elsewhere.
TEST(ExtremeWalk, TheDriversFaultMustBeShown) {
  const ExtremeCase& c = *find_extremes("attenuation-denormal", extreme_cases())[0];
  ASSERT_TRUE(c.driver_fault);
  const auto by = [&](Technique t) {
    t.id = "gl";
    Progress progress;
    return run_extreme(c, std::vector{t}, progress).at(0).verdict;
  };
  EXPECT_EQ(by(software_technique()), Verdict::right);
  Technique flushes = software_technique();
  flushes.render = [render = flushes.render](Scene s, const Plan& p, const View& v, Progress& progress) {
    for (Light& l : s.lights) {
      if (l.k_2 < 1e-38) l.k_2 = 0;
      if (l.k_0 == 0 && l.k_1 == 0 && l.k_2 == 0) l.k_0 = 1;
    }
    return render(s, p, v, progress);
  };
  EXPECT_EQ(by(flushes), Verdict::driver);
  const Technique other = spoilt([](const Scene& s, Frame& f) {
    if (s.lights[0].k_2 > 0)
      for (glm::vec3& colour : f.colour.pixels()) colour = glm::vec3(0.5f);
  });
  EXPECT_EQ(by(other), Verdict::off);
}

TEST(ExtremeWalk, SeesAFormulaThatIsOffOrShowsNothing) {
  ExtremeCase c;
  c.id = "x", c.tolerance = 1e-6;
  const auto verdict = [&](double naive, double robust) {
    c.naive = Naive{"a", "b", {"x", "y"}, [=] { return std::vector<Naive::Row>{{"1", naive, robust, 1}}; }};
    Progress progress;
    return run_extreme(c, {}, progress).at(0).verdict;
  };
  EXPECT_EQ(verdict(0, 1), Verdict::right);
  EXPECT_EQ(verdict(std::nan(""), 1), Verdict::right);
  EXPECT_EQ(verdict(1, 1), Verdict::off);
  EXPECT_EQ(verdict(0, 1.1), Verdict::off);
  EXPECT_EQ(verdict(0, std::nan("")), Verdict::broken);
}

TEST(ExtremeWalk, StopsWhenItIsAsked) {
  Progress progress;
  progress.cancelled = true;
  EXPECT_THROW(run_extremes(find_extremes("lights", extreme_cases()), all_techniques(), progress), Cancelled);
}

}  // namespace
}  // namespace cg
