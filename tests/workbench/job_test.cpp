// The job against techniques whose pictures are known.
#include "workbench/job.h"

#include <gtest/gtest.h>

#include <random>

#include "params/input_error.h"

namespace cg {
namespace {

using namespace std::chrono_literals;

// Every pixel is the material's n. Takes `ms` for a full picture, less for a coarse one, and asks every 1/4 ms
// whether it was cancelled.
Technique slow_technique(double ms, std::atomic<int>* cancelled = nullptr) {
  Technique t;
  t.id = "slow";
  t.plan = [](const Scene&, const View&) { return Plan{.technique = "slow", .passes = {}, .notes = {}}; };
  t.render = [=](const Scene& scene, const Plan&, const View& view, Progress& progress) {
    const double share = double(view.width) * view.height / (64.0 * 64.0);
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double, std::milli>(ms * share);
    while (std::chrono::steady_clock::now() < end) {
      if (progress.cancelled) {
        if (cancelled) ++*cancelled;
        throw Cancelled();
      }
      std::this_thread::sleep_for(250us);
    }
    Frame frame;
    frame.colour = ColourImage(view.width, view.height, glm::vec3(float(scene.material.n)));
    frame.covered = Image<std::uint8_t>(view.width, view.height, 1);
    return frame;
  };
  return t;
}

Request request(double n) {
  Request r;
  r.scene.material.n = n;
  r.view.width = r.view.height = 64;
  return r;
}

double drawn(const Job::State& state) { return state.drawing ? double(state.drawing->frame.colour.at(0, 0).r) : -1; }

TEST(Job, DrawsWhatWasSubmitted) {
  Job job(slow_technique(0), {});
  EXPECT_EQ(job.poll().drawing, nullptr);
  const auto serial = job.submit(request(7));
  job.wait();
  const auto state = job.poll();
  EXPECT_EQ(drawn(state), 7);
  EXPECT_EQ(state.answered, serial);
  EXPECT_EQ(state.drawing->serial, serial);
  EXPECT_EQ(state.drawing->coarseness, 1);
  EXPECT_FALSE(state.busy);
  ASSERT_TRUE(state.plan);
  EXPECT_EQ(state.plan->technique, "slow");
}

// Where light may be kept and only the display transform is another, nothing is drawn again.
TEST(Job, AnotherDisplayAloneDrawsNothingAgain) {
  std::atomic<int> rendered{0};
  Technique t = slow_technique(0);
  t.render = [&, inner = t.render](const Scene& s, const Plan& p, const View& v, Progress& g) {
    ++rendered;
    Frame frame = inner(s, p, v, g);
    frame.passes = {{"draw", 1, 0, false}};
    return frame;
  };
  Job job(t, {});
  Request r = request(0.5);
  const auto draw = [&] {
    job.submit(r);
    job.wait();
    return job.poll().drawing;
  };
  r.view.reuse = true;
  EXPECT_FALSE(draw()->partly);
  r.scene.display.transform = DisplayTransform::photographic;
  const DrawingHandle shown = draw();
  EXPECT_EQ(rendered, 1);
  EXPECT_TRUE(shown->partly && shown->frame.passes[0].kept && shown->change.display_alone());
  EXPECT_NE(shown->shown.at(0, 0).r, to_8bit(0.5f));
  EXPECT_EQ(shown->scene, r.scene);
  r.scene.display.background = {1, 0, 0};
  EXPECT_FALSE(draw()->partly);
  EXPECT_EQ(rendered, 2);
  r.scene.display.exposure = 1, r.view.reuse = false;
  EXPECT_FALSE(draw()->partly);
  EXPECT_EQ(rendered, 3);
}

TEST(Job, TheNewestWinsAndNoQueueGrows) {
  std::atomic<int> rendered{0};
  Technique t = slow_technique(5);
  t.render = [&, inner = t.render](const Scene& s, const Plan& p, const View& v, Progress& g) {
    ++rendered;
    return inner(s, p, v, g);
  };
  Job job(t, {});
  std::uint64_t last = 0;
  for (int i = 1; i <= 1000; ++i) last = job.submit(request(i));
  job.wait();
  EXPECT_EQ(drawn(job.poll()), 1000);
  EXPECT_EQ(job.poll().answered, last);
  EXPECT_LT(rendered, 100);
}

TEST(Job, ASliderThatNeverRestsStillShowsPictures) {
  for (double ms : {5.0, 80.0}) {  // one that is let finish, one that comes coarse first
    Job job(slow_technique(ms), {});
    job.submit(request(1));
    job.wait();
    std::uint64_t shown = job.poll().drawing->serial;
    int changes = 0;
    for (int i = 2; i < 120; ++i) {
      job.submit(request(i));
      std::this_thread::sleep_for(5ms);
      const auto picture = job.poll().drawing;
      if (picture->serial != shown) ++changes, shown = picture->serial;
    }
    EXPECT_GT(changes, 10) << ms;
    job.wait();
    EXPECT_EQ(drawn(job.poll()), 119);
  }
}

TEST(Job, ACoarsePictureComesBeforeASlowOne) {
  std::mutex mutex;
  std::vector<int> coarseness;
  Job* self = nullptr;
  Job::Hooks hooks;
  hooks.wake = [&] {
    const std::lock_guard lock(mutex);
    coarseness.push_back(self->poll().drawing->coarseness);
  };
  Job job(slow_technique(60), hooks);
  self = &job;
  job.submit(request(1));
  job.wait();
  job.submit(request(2));
  job.wait();
  EXPECT_EQ(coarseness, (std::vector{1, 4, 1}));
  const auto picture = job.poll().drawing;
  EXPECT_EQ(picture->frame.colour.width(), 64);
  EXPECT_EQ(picture->shown.width(), 64);
}

TEST(Job, WhatIsStaleIsCancelled) {
  std::atomic<int> cancelled{0};
  Job job(slow_technique(1e6, &cancelled), {});
  job.submit(request(1));
  std::this_thread::sleep_for(20ms);  // it draws
  Request other = request(2);
  Object cube;
  cube.model = "cube";
  other.scene.objects.push_back(cube);  // another shape: nobody waits for the old one
  other.view.width = other.view.height = 0;
  job.submit(other);
  job.wait();
  EXPECT_EQ(cancelled, 1);
  EXPECT_EQ(job.poll().answered, 2u);
}

TEST(Job, ErrorsAreMessagesAndTheLastPictureStays) {
  Technique t = slow_technique(0);
  t.unsupported = [](const Scene& s) -> std::optional<Text> {
    if (s.material.n == 3) return Text("no three", "3 は不可");
    return std::nullopt;
  };
  t.render = [inner = t.render](const Scene& s, const Plan& p, const View& v, Progress& g) {
    if (s.material.n == 4) throw InputError("model.obj", {"bad", "不正"}, {}, 7);
    if (s.material.n == 5) throw std::bad_alloc();
    if (s.material.n == 6) throw std::runtime_error("oh");
    return inner(s, p, v, g);
  };
  Job job(t, {});
  job.submit(request(1));
  job.wait();
  const std::vector<std::string> expected{"no three", "model.obj:7: bad", "There is not enough memory for this picture",
                                          "Drawing failed: oh"};
  for (int n = 3; n <= 6; ++n) {
    const auto serial = job.submit(request(n));
    job.wait();
    const auto state = job.poll();
    ASSERT_TRUE(state.message);
    EXPECT_EQ(state.message->en, expected[std::size_t(n - 3)]);
    EXPECT_EQ(state.answered, serial);
    EXPECT_EQ(drawn(state), 1);
  }
  job.submit(request(8));
  job.wait();
  EXPECT_FALSE(job.poll().message);
  EXPECT_EQ(drawn(job.poll()), 8);
}

TEST(Job, AnUnavailableTechniqueSaysWhy) {
  Technique t = slow_technique(0);
  t.unavailable = Text("no context", "コンテキストなし");
  Job job(t, {});
  job.submit(request(1));
  job.wait();
  EXPECT_EQ(job.poll().message->en, "no context");
}

TEST(Job, MeshesAreLoadedOnItsThread) {
  const auto window = std::this_thread::get_id();
  std::thread::id loader;
  Job::Hooks hooks;
  hooks.prepare = [&](Scene& s) {
    loader = std::this_thread::get_id();
    s.material.n = 9;
  };
  Job job(slow_technique(0), hooks);
  job.submit(request(1));
  job.wait();
  EXPECT_NE(loader, window);
  EXPECT_EQ(job.poll().drawing->scene.material.n, 9);
}

// Submits, polls and destroys at random while it draws; for the sanitizers.
TEST(Job, CancelStorm) {
  std::mt19937 random(1);
  for (int round = 0; round < 60; ++round) {
    Job job(slow_technique(double(random() % 40)), {});
    for (int i = 0; i < 40; ++i) {
      Request r = request(i);
      Object object;
      object.model = std::to_string(random() % 4);
      if (random() % 3 == 0) r.scene.objects.push_back(object);
      job.submit(std::move(r));
      if (random() % 2) job.poll();
      if (random() % 4 == 0) std::this_thread::sleep_for(std::chrono::microseconds(random() % 3000));
    }
    if (random() % 2) {
      job.wait();
      EXPECT_EQ(drawn(job.poll()), 39);
    }  // else it is destroyed while it draws
  }
}

TEST(Job, MarksClampedPixels) {
  Request r = request(1);
  r.mark_clamped = true;
  Technique t = slow_technique(0);
  t.render = [](const Scene&, const Plan&, const View& v, Progress&) {
    Frame frame;
    frame.colour = ColourImage(v.width, v.height, glm::vec3(0.5f));
    frame.covered = Image<std::uint8_t>(v.width, v.height, 1);
    frame.colour.at(0, 0) = {1.5f, 0, 0};
    frame.colour.at(1, 0) = {-0.5f, 0, 0};
    return frame;
  };
  Job job(t, {});
  job.submit(r);
  job.wait();
  const auto picture = job.poll().drawing;
  EXPECT_EQ(picture->clamped.above, 1u);
  EXPECT_EQ(picture->clamped.below, 1u);
  EXPECT_NE(picture->shown.at(0, 0), glm::u8vec4(255, 0, 0, 255));
  EXPECT_EQ(picture->shown.at(3, 0), glm::u8vec4(128, 128, 128, 255));
}

}  // namespace
}  // namespace cg
