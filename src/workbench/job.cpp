#include "workbench/job.h"

#include <algorithm>
#include <new>
#include <utility>

#include "params/input_error.h"

namespace cg {

namespace {

constexpr double patience_ms = 100;  // a stale pass that takes longer is cancelled, whatever it was expected to take
constexpr int coarsest = 8;

double milliseconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double, std::milli>(d).count();
}

bool same_shapes(const std::vector<Object>& a, const std::vector<Object>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Object& x, const Object& y) {
    return x.model == y.model && x.part == y.part && x.tessellation == y.tessellation;
  });
}

}  // namespace

int drawing_threads() {
  const int n = int(std::thread::hardware_concurrency());
  return n > 2 ? n - 1 : std::max(n, 1);
}

Job::Job(Technique technique, Hooks hooks) : technique_(std::move(technique)), hooks_(std::move(hooks)) {}

std::uint64_t Job::submit(Request request) {
  // The scenes that are let go are freed after the lock.
  auto shared = std::make_shared<const Request>(std::move(request));
  std::uint64_t serial;
  bool stop;
  {
    const std::lock_guard lock(mutex_);
    serial = ++submitted_;
    stop = !same_shapes(drawing_, shared->scene.objects) || !worth_finishing();
  }
  worker_.submit([this, shared, serial](Progress& progress) { answer(*shared, serial, progress); }, stop);
  return serial;
}

Job::State Job::poll() {
  State state;
  bool stop;
  {
    const std::lock_guard lock(mutex_);
    state = state_;
    stop = !worth_finishing();
  }
  if (stop) worker_.cancel_stale();
  state.busy = worker_.busy();
  state.fraction = worker_.fraction();
  return state;
}

// Whether the pass that runs should go on although its scene is no longer the newest. A full pass that takes
// long had a coarse one before it, so cancelling it leaves something newer on screen than before.
bool Job::worth_finishing() const {
  if (milliseconds(Clock::now() - pass_start_) > patience_ms) return false;
  return pass_coarseness_ > 1 || full_ms_ <= hooks_.coarse_over_ms;
}

// A coarse picture should itself take no longer than a full one may.
int Job::first_coarseness(const View& view) const {
  const std::lock_guard lock(mutex_);
  if (full_ms_ <= hooks_.coarse_over_ms || std::min(view.width, view.height) < 2 * coarsest) return 1;
  return full_ms_ <= 16 * hooks_.coarse_over_ms ? 4 : coarsest;
}

void Job::answer(const Request& request, std::uint64_t serial, Progress& progress) {
  try {
    {
      const std::lock_guard lock(mutex_);
      drawing_ = request.scene.objects;
      pass_start_ = Clock::now();
    }
    if (technique_.unavailable) return fail(serial, *technique_.unavailable);
    Request loaded = request;
    if (hooks_.prepare) hooks_.prepare(loaded.scene);
    if (technique_.unsupported)
      if (const std::optional<Text> reason = technique_.unsupported(loaded.scene)) return fail(serial, *reason);
    const auto plan = std::make_shared<const Plan>(technique_.plan(loaded.scene, loaded.view));
    {
      const std::lock_guard lock(mutex_);
      state_.plan = plan;
    }
    const bool shown_again = same_light(loaded) != nullptr;
    if (const int coarseness = first_coarseness(loaded.view); coarseness > 1 && !shown_again) {
      publish(draw(loaded, plan, coarseness, progress), serial);
      if (worker_.waiting()) return;
    }
    publish(draw(loaded, plan, 1, progress), serial);
  } catch (const Cancelled&) {
    // Its elapsed time is what is known of a full picture now: the next one starts coarse.
    const std::lock_guard lock(mutex_);
    if (pass_coarseness_ == 1) full_ms_ = std::max(full_ms_, milliseconds(Clock::now() - pass_start_));
  } catch (const InputError& error) {
    fail(serial, {error.message(Language::english), error.message(Language::japanese)});
  } catch (const std::bad_alloc&) {
    fail(serial, {"There is not enough memory for this picture", "この画像にはメモリが足りません"});
  } catch (const std::exception& error) {
    fail(serial, {std::string("Drawing failed: ") + error.what(), std::string("描画に失敗しました: ") + error.what()});
  }
}

DrawingHandle Job::same_light(const Request& request) const {
  const std::lock_guard lock(mutex_);
  const DrawingHandle& before = state_.drawing;
  const bool same = before && request.view.reuse && before->coarseness == 1 && before->view == request.view;
  return same && scene_change(before->scene, request.scene).display_alone() ? before : nullptr;
}

std::shared_ptr<Drawing> Job::draw(const Request& request, std::shared_ptr<const Plan> plan, int coarseness,
                                   Progress& progress) {
  auto drawing = std::make_shared<Drawing>();
  {
    const std::lock_guard lock(mutex_);
    if (state_.drawing) drawing->change = scene_change(state_.drawing->scene, request.scene);
  }
  View view = request.view;
  if (coarseness > 1)
    view.width = std::max(1, view.width / coarseness), view.height = std::max(1, view.height / coarseness);
  {
    const std::lock_guard lock(mutex_);
    pass_coarseness_ = coarseness;
    pass_start_ = Clock::now();
  }
  progress.fraction = 0;
  drawing->plan = coarseness > 1 ? std::make_shared<const Plan>(technique_.plan(request.scene, view)) : std::move(plan);
  if (const DrawingHandle before = same_light(request); before && coarseness == 1) {
    drawing->frame = before->frame, drawing->wall_ms = before->wall_ms;
    for (PassRun& run : drawing->frame.passes) run.cpu_ms = 0, run.kept = true;
  } else {
    const auto start = Clock::now();
    drawing->frame = technique_.render(request.scene, *drawing->plan, view, progress);
    drawing->wall_ms = milliseconds(Clock::now() - start);
  }
  drawing->cpu_ms = drawing->frame.cpu_ms;
  for (const PassRun& run : drawing->frame.passes)
    drawing->partly = drawing->partly || (run.kept && (run.id == "transform" || run.id == "draw"));
  const Display& display = request.scene.display;
  drawing->shown = cg::picture(display, drawing->frame.colour);
  if (request.mark_clamped) drawing->clamped = mark_clamped(drawing->shown, drawing->frame.colour, display);
  drawing->scene = request.scene;
  drawing->view = request.view;
  drawing->coarseness = coarseness;
  return drawing;
}

void Job::publish(std::shared_ptr<Drawing> drawing, std::uint64_t serial) {
  drawing->serial = serial;
  DrawingHandle replaced;  // freed after the lock
  {
    const std::lock_guard lock(mutex_);
    if (drawing->coarseness == 1) full_ms_ = drawing->wall_ms, state_.answered = serial;
    replaced = std::exchange(state_.drawing, std::move(drawing));
    state_.message.reset();
  }
  if (hooks_.wake) hooks_.wake();
}

void Job::fail(std::uint64_t serial, Text message) {
  {
    const std::lock_guard lock(mutex_);
    state_.message = std::move(message);
    state_.answered = serial;
  }
  if (hooks_.wake) hooks_.wake();
}

}  // namespace cg
