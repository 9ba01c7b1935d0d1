#include "ui/window.h"

#include <epoxy/gl.h>
// After epoxy, which stands in for OpenGL's own headers.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <utility>

#include "params/slots.h"
#include "scene/shape.h"
#include "ui/actions.h"
#include "ui/app.h"
#include "ui/challenge_game.h"
#include "ui/dress.h"
#include "ui/frame_times.h"
#include "ui/keeping.h"
#include "ui/layout.h"
#include "ui/lecture.h"
#include "ui/lesson_player.h"
#include "ui/measure.h"
#include "ui/one_at_a_time.h"
#include "ui/radiosity_desk.h"
#include "ui/recording.h"
#include "ui/screenshot.h"
#include "ui/solver_panel.h"
#include "ui/state_dump.h"
#include "ui/trade_desk.h"
#include "workbench/environment.h"
#include "workbench/open.h"
#include "workbench/texture_library.h"

namespace cg {
namespace {

std::string last_glfw_error() {
  const char* text = nullptr;
  return glfwGetError(&text) != GLFW_NO_ERROR && text ? text : "?";
}

// GLFW, its window with an OpenGL context, and ImGui on it; undone in reverse order.
class Surface {
 public:
  Surface(App& app, const WindowPlacement& place) : ears_{app, {}, {}} {
    if (!glfwInit()) {
      const std::string why = last_glfw_error();
      throw InputError("display", {"no window can be opened: " + why, "ウィンドウを開けません: " + why},
                       {"a display (DISPLAY), or one of the commands render, compare, plan",
                        "ディスプレイ（DISPLAY）、または render・compare・plan コマンド"});
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_FALSE);
    int width = place.width, height = place.height;
    if (width <= 0 || height <= 0) fit_monitor(width, height);
    // GLFW refuses a size of 0, and X ends the program for one beyond its 16 bits.
    window_ =
        glfwCreateWindow(std::clamp(width, 1, 16384), std::clamp(height, 1, 16384), "Shadebench", nullptr, nullptr);
    if (!window_) {
      const std::string why = last_glfw_error();
      glfwTerminate();
      throw InputError("OpenGL", {"no window with OpenGL 3.3: " + why, "OpenGL 3.3 のウィンドウを開けません: " + why},
                       {"a driver with OpenGL 3.3", "OpenGL 3.3 のあるドライバ"});
    }
    glfwSetWindowSizeLimits(window_, 320, 240, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowUserPointer(window_, &ears_);
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
      if (count > 0) open_in_window(static_cast<Ears*>(glfwGetWindowUserPointer(w))->app, paths[0]);
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int code, int what, int with) {
      if (what == GLFW_RELEASE) return;
      Ears& ears = *static_cast<Ears*>(glfwGetWindowUserPointer(w));
      if (key >= 0 && what == GLFW_PRESS) ears.tapped.push_back(key);
      const char* name = glfwGetKeyName(key, code);  // the letter on the key, wherever the layout has it
      if (name && name[0] >= 'a' && name[0] <= 'z' && name[1] == 0) key = GLFW_KEY_A + (name[0] - 'a');
      ears.pressed.push_back({key, (with & GLFW_MOD_CONTROL) != 0, (with & GLFW_MOD_SHIFT) != 0,
                              (with & (GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0, what == GLFW_REPEAT});
    });
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    IMGUI_CHECKVERSION();
    ImGui::CreateContext(&no_fonts_);  // Dress brings them before the first frame
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // the session keeps what there is to keep
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
  }
  ~Surface() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
  }
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  GLFWwindow* get() const { return window_; }

  // The keys since the last time.
  std::vector<KeyPress> take_keys() { return std::exchange(ears_.pressed, {}); }

  // ImGui 1.86 looks at the keys once a frame: one that was let go before it looked counts as held in this frame.
  void new_frame() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = frame_time(io.DeltaTime);
    std::erase_if(ears_.tapped, [&](int key) { return io.KeysDown[key]; });
    for (const int key : ears_.tapped) io.KeysDown[key] = true;
    ImGui::NewFrame();
    for (const int key : ears_.tapped) io.KeysDown[key] = false;
    ears_.tapped.clear();
  }

  double content_scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::isfinite(x) ? std::clamp(double(x), 0.5, 4.0) : 1.0;
  }

 private:
  static void fit_monitor(int& width, int& height) {
    width = 1440, height = 900;
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
      int x, y, w = 0, h = 0;
      float scale = 1, unused = 1;
      glfwGetMonitorContentScale(monitor, &scale, &unused);
      glfwGetMonitorWorkarea(monitor, &x, &y, &w, &h);
      if (scale > 0) width = int(float(width) * scale), height = int(float(height) * scale);
      if (w > 0 && h > 0) width = std::min(width, w), height = std::min(height, h);
    }
  }

  struct Ears {
    App& app;
    std::vector<KeyPress> pressed;
    std::vector<int> tapped;  // GLFW's keys that went down since the last frame
  };
  Ears ears_;
  GLFWwindow* window_ = nullptr;
  ImFontAtlas no_fonts_;
};

// When the next frame is drawn.
struct Pace {
  int settling = 2;                // frames still to be drawn without a reason
  double next = 0;                 // not before this time, unless there is something new
  std::atomic<bool> woken{false};  // a picture came, or an errand was done
};

// Waits until there is a reason for a frame: an event, a picture that came, a time that was asked for. Of mouse
// moves and animations there are no more than 60 frames a second: a driver without a display's rhythm would take
// from the techniques what nobody sees.
void wait_for_reason(App& app, Pace& pace) {
  if (app.animating || pace.settling > 0) {
    pace.settling = app.animating ? 2 : pace.settling - 1;
    glfwPollEvents();
    for (double rest = pace.next - glfwGetTime(); rest > 0 && !pace.woken; rest = pace.next - glfwGetTime())
      glfwWaitEventsTimeout(rest);
  } else {
    const double rest = std::clamp(app.next_frame - glfwGetTime(), 0.0, 2.0);
    glfwWaitEventsTimeout(std::max(rest, 0.001));
    pace.settling = 1;  // ImGui shows some things a frame after the event
  }
  pace.woken = false;
  pace.next = glfwGetTime() + 1.0 / 60;
}

void draw_frame(App& app, Surface& surface) {
  app.now = glfwGetTime();
  app.animating = false;
  app.next_frame = app.now + 2;
  app.errands->finish(app);
  lessons_of(app).update(app);
  game_of(app).update(app);
  if (app.trades) app.trades->update(app);
  surface.new_frame();
  handle_keys(app, surface.take_keys());
  watch_sweep(app);
  draw_window(app, ImGui::GetIO().DisplaySize);
  keep_history(app);
  note_lecture(app);
  recorder_of(app).update(app);
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(surface.get(), &width, &height);
  if (width <= 0 || height <= 0) return;
  glViewport(0, 0, width, height);
  const ImVec4 back = ImGui::ColorConvertU32ToFloat4(app.look.palette.window);
  glClearColor(back.x, back.y, back.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

// Those of the window's settings at once; the others, of the scene, are returned.
std::vector<std::string> set_settings(App& app, const std::vector<std::string>& texts) {
  std::vector<std::string> others;
  const Slots all = slots(app.settings);
  for (const std::string& text : texts) {
    const std::string path = text.substr(0, text.find('='));
    const bool own = std::any_of(all.begin(), all.end(), [&](const Slot& slot) { return slot.path == path; });
    if (path.size() == text.size() || (!own && path.find('.') != path.npos))
      others.push_back(text);
    else
      assign_text(find_slot(all, path), text.substr(path.size() + 1));
  }
  return others;
}

void set_parameters(Scene& scene, const std::vector<std::string>& texts) {
  for (const std::string& text : texts) set_parameter(scene, text);
  if (!texts.empty()) load_meshes(scene);
}

// Before there is a window: what cannot be opened ends the program with its message.
void open_at_start(App& app, const std::string& what) {
  std::vector<Text> notes;
  app.scene = open_scene(what, &notes);
  std::vector<InputError> bad;
  load_textures(app.scene, &bad);
  for (const InputError& e : bad) notes.push_back({e.message(Language::english), e.message(Language::japanese)});
  if (what.ends_with(".json")) app.preset = what;
  add_recent(app.recent, what);
  for (const Text& note : notes) say(app, note);
}

// The lesson of the last session, which goes on where it was; or the step that was named, with its view.
void open_lesson_at_start(App& app, const std::string& scene, const std::vector<std::string>& set) {
  const std::optional<StepName> named = scene.empty() ? std::nullopt : find_step(scene);
  if (!named) return lessons_of(app).resume(app.settings.lesson, false);
  lessons_of(app).open(named->folder, named->step, true, set);
  if (app.settings.side == Side::none) app.settings.side = Side::lesson;
}

// What lives on the window's OpenGL context goes before it.
struct ContextUsers {
  App& app;
  ~ContextUsers() {
    app.panes.reset(), app.world.reset(), app.solver.reset(), app.radiosity.reset();
    app.challenge.reset();
    app.trades.reset(), app.hemicube.reset();
  }
};

}  // namespace

int run_window(const std::vector<Technique>& techniques, const WindowOptions& options) {
  StartTimes start(options.times);
  Pace pace;  // outlives the threads that wake the window
  App app;
  for (const Technique& technique : techniques) app.techniques.push_back(one_at_a_time(technique));
  app.settings.language = language_of_environment();
  app.wake = [&pace] {
    pace.woken = true;
    glfwPostEmptyEvent();
  };
  app.radiosity = std::make_shared<RadiosityDesk>(app.wake, options.draw_items);
  SessionStore store(options.keep_session ? state_folder() : std::nullopt,
                     options.keep_session ? config_folder() : std::nullopt);
  WindowPlacement place;
  if (options.keep_session) restore(app, place, store, options.scene.empty());
  const std::vector<std::string> set = set_settings(app, options.set);
  choose_techniques(app);
  if (options.width > 0 && options.height > 0) place = {options.width, options.height};
  app.bundled = bundled_models();
  if (!options.state.empty()) app.dump = std::make_shared<StateDump>(options.state);
  if (!options.scene.empty()) open_at_start(app, options.scene);
  if (app.scene.objects.empty()) app.scene = open_scene(std::string(shapes().front().id));
  set_parameters(app.scene, set);
  app.history.restart(app.scene);
  open_lesson_at_start(app, options.scene, set);
  start.mark("scene");
  if (options.scale > 0) app.content_scale = options.scale;
  Dress dress(app);  // the fonts are built while the window opens
  Surface surface(app, place);
  const ContextUsers users{app};
  start.mark("window");
  FrameTimes times;
  Screenshot shot(options.screenshot);
  WindowMeasurement measurement(options.measure);
  for (bool first = true; !glfwWindowShouldClose(surface.get()); first = false) {
    if (!first) wait_for_reason(app, pace);
    times.begin();
    app.content_scale = options.scale > 0 ? options.scale : surface.content_scale();
    fit_presenter(app, surface.get());
    dress.fit(app);
    if (first) start.mark("fonts built");
    measurement.change(app);
    draw_frame(app, surface);
    if (app.dump) app.dump->write(app, dress.busy());
    measurement.drawn(app);
    if (!app.presenter.full) glfwGetWindowSize(surface.get(), &place.width, &place.height);
    if (options.keep_session) keep(app, place, store);
    if (recorder_of(app).wants_window(app)) recorder_of(app).take_window(app, window_picture(surface.get()));
    times.end();
    if (shot.wanted(app, dress.busy())) {
      shot.take(surface.get());
      break;
    }
    glfwSwapBuffers(surface.get());
    measurement.shown(app);
    if (measurement.finished()) break;
    if (first) start.mark("first frame");
  }
  measurement.print(app);
  if (options.times) times.print();
  return 0;
}

}  // namespace cg
