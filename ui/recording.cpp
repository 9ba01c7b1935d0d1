#include "ui/recording.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "image/image_file.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/frame_writer.h"
#include "ui/opening.h"
#include "ui/widgets.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

constexpr double per_second = 15;

// A picture as large as it was asked for: a coarse one is smaller.
std::shared_ptr<const Picture> shown_picture(const DrawingHandle& drawing) { return {drawing, &drawing->shown}; }

std::string clock_text(double seconds) {
  const int whole = int(std::max(seconds, 0.0));
  return std::to_string(whole / 60) + (whole % 60 < 10 ? ":0" : ":") + std::to_string(whole % 60);
}

// The first name that is free: recording-1.gif, recording-2.gif, ...
fs::path free_name(RecordedAs as) {
  std::error_code error;
  for (int i = 1; i < 10000; ++i) {
    const fs::path path = "recording-" + std::to_string(i) + (as == RecordedAs::gif ? ".gif" : "");
    if (!fs::exists(path, error)) return fs::absolute(path, error);
  }
  return "recording";
}

}  // namespace

Recorder::Recorder(std::function<void()> wake) : wake_(wake ? std::move(wake) : [] {}) {}
Recorder::~Recorder() = default;

void Recorder::start(const App& app, Recorded what, RecordedAs as, const fs::path& path) {
  if (recording()) return;
  writers_.push_back(std::make_unique<FrameWriter>(as, path, per_second, wake_));
  what_ = what;
  began_ = next_ = app.now;
  ticks_ = 0;
  frames_ = 0;
  recording_ = true;
}

void Recorder::stop() {
  if (!recording_) return;
  recording_ = false;
  writers_.back()->finish();
}

void Recorder::tell(App& app) {
  for (std::size_t i = 0; i < writers_.size();) {
    FrameWriter& writer = *writers_[i];
    if (!writer.ended()) {
      ++i;
      continue;
    }
    if (recording_ && i + 1 == writers_.size()) recording_ = false;  // it failed, or is as long as it may be
    if (const auto& error = writer.error())
      say(app, *error);
    else
      say(app, writer.report());
    writers_.erase(writers_.begin() + std::ptrdiff_t(i));
  }
}

bool Recorder::due(const App& app) const { return recording_ && app.now >= next_; }

void Recorder::put(App& app, std::shared_ptr<const Picture> left, std::shared_ptr<const Picture> right) {
  const long now = long((app.now - began_) * per_second) + 1;
  if (writers_.back()->put({std::move(left), std::move(right), int(now - ticks_)})) {
    ticks_ = now;
    ++frames_;
  }
  next_ = began_ + double(now) / per_second;
}

void Recorder::update(App& app) {
  tell(app);
  if (!recording_) return;
  app.next_frame = std::min(app.next_frame, std::max(next_, app.now));
  if (what_ == Recorded::window || !due(app)) return;
  const DrawingHandle &left = app.drawings[0], &right = app.drawings[1];
  std::shared_ptr<const Picture> a = left && what_ != Recorded::right ? shown_picture(left) : nullptr;
  std::shared_ptr<const Picture> b = right && what_ != Recorded::left ? shown_picture(right) : nullptr;
  if (!a) std::swap(a, b);
  if (a) put(app, std::move(a), std::move(b));
}

bool Recorder::wants_window(const App& app) const { return !still_.empty() || (what_ == Recorded::window && due(app)); }

void Recorder::save_window(const fs::path& file) { still_ = file; }

void Recorder::take_window(App& app, Picture picture) {
  const auto shared = std::make_shared<const Picture>(std::move(picture));
  if (!still_.empty()) {
    app.errands->run(app, [file = std::exchange(still_, {}), shared]() -> Errands::Done {
      write_image(file, *shared);
      return [file](App& a) { say_saved(a, file); };
    });
  }
  if (what_ == Recorded::window && due(app)) put(app, shared, nullptr);
}

Recorder& recorder_of(App& app) {
  if (!app.recorder) app.recorder = std::make_shared<Recorder>(app.wake);
  return *app.recorder;
}

void toggle_recording(App& app) {
  Recorder& recorder = recorder_of(app);
  if (recorder.recording()) return recorder.stop();
  start_recording(app, free_name(app.settings.record_as));
}

void start_recording(App& app, const fs::path& path) {
  try {
    recorder_of(app).start(app, app.settings.picture, app.settings.record_as, path);
  } catch (const InputError& e) {
    say(app, e);
  }
}

void draw_recording_sign(App& app, ImVec2 top) {
  Recorder& recorder = recorder_of(app);
  if (!recorder.recording()) return;
  Look& look = app.look;
  const std::string text = clock_text(recorder.seconds(app));
  const float h = look.px(30), w = text_width(look.fonts.mono, text) + look.px(46);
  ImGui::SetNextWindowPos({std::floor(top.x - 0.5f * w), std::floor(top.y)});
  ImGui::SetNextWindowSize({w, h});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.palette.raised);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, h * 0.5f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::Begin("recording", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton("stop", {w, h});
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 c{at.x + look.px(18), at.y + 0.5f * h};
  const float r = look.px(6);
  if (hovered)
    draw->AddRectFilled({c.x - r, c.y - r}, {c.x + r, c.y + r}, look.palette.error, look.px(1));
  else
    draw->AddCircleFilled(c, r, look.palette.error);
  set_text(draw, look.fonts.mono, {at.x + look.px(32), at.y + look.px(20)}, look.palette.text, text);
  if (wants_tooltip(app))
    tooltip(app, {}, Words{"Recording; a click ends it", "録画中。クリックで終える"}.in(app.language()), "Ctrl+R");
  ImGui::End();
  if (pressed) recorder.stop();
}

}  // namespace cg
