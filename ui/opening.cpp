#include "ui/opening.h"

#include <imgui_internal.h>

#include <algorithm>

#include "image/image_file.h"
#include "ui/app.h"
#include "ui/quiz.h"
#include "ui/trade_desk.h"
#include "workbench/environment.h"
#include "workbench/import.h"
#include "workbench/model_library.h"
#include "workbench/open.h"
#include "workbench/preset.h"
#include "workbench/session.h"
#include "workbench/texture_library.h"

namespace cg {

namespace {

// Two pictures beside each other, black between them and below the lower one.
ColourImage beside(const ColourImage& a, const ColourImage& b) {
  constexpr int gap = 8;
  ColourImage out(a.width() + gap + b.width(), std::max(a.height(), b.height()));
  for (int y = 0; y < out.height(); ++y) {
    std::fill_n(out.row(y), out.width(), glm::vec3(0));
    if (y < a.height()) std::copy_n(a.row(y), a.width(), out.row(y));
    if (y < b.height()) std::copy_n(b.row(y), b.width(), out.row(y) + a.width() + gap);
  }
  return out;
}

}  // namespace

void Errands::run(App& app, std::function<Done()> task) {
  worker_.submit([this, wake = app.wake, task = std::move(task)](Progress&) {
    Done done;
    try {
      done = task();
    } catch (const InputError& e) {
      done = [e](App& a) { say(a, e); };
    } catch (const std::bad_alloc&) {
      done = [](App& a) { say(a, InputError("", {"not enough memory", "メモリが足りません"})); };
    } catch (const std::exception& e) {
      done = [what = std::string(e.what())](App& a) { say(a, InputError("", {what, what})); };
    }
    {
      const std::lock_guard lock(mutex_);
      done_.push_back(std::move(done));
    }
    if (wake) wake();
  });
}

void Errands::finish(App& app) {
  std::vector<Done> done;
  {
    const std::lock_guard lock(mutex_);
    done.swap(done_);
  }
  for (const Done& d : done)
    if (d) d(app);
}

namespace {

// Another scene in place of the one in hand.
void replace_scene(App& app, Scene scene, const std::string& what) {
  leave_quiz(app);
  stop_measuring(app);
  app.scene = std::move(scene);
  app.preset = what.ends_with(".json") ? what : std::string();
  app.light = app.object = 0;
  app.isolated = {};
  add_recent(app.recent, what);
}

// A student's program, with what was not understood of it.
void import_in_window(App& app, const std::string& file) {
  app.errands->run(app, [file]() -> Errands::Done {
    auto report = std::make_shared<ImportReport>(import_file(file));
    load_meshes(report->scene);
    return [file, report](App& a) {
      replace_scene(a, std::move(report->scene), file);
      a.presets.imported = std::filesystem::path(file).filename().string();
      a.presets.complaints = std::move(report->complaints);
      const std::string n = std::to_string(a.presets.complaints.size());
      if (a.presets.complaints.empty()) return;
      a.settings.side = Side::presets;
      say(a, Text("Not all of it was understood: " + n + " remarks at the right",
                  "読み取れないところがありました（" + n + " 件、右に表示）"));
    };
  });
}

}  // namespace

void open_in_window(App& app, std::string what) {
  if (std::filesystem::path(what).extension() == ".c") return import_in_window(app, what);
  app.errands->run(app, [what]() -> Errands::Done {
    auto notes = std::make_shared<std::vector<Text>>();
    auto scene = std::make_shared<Scene>(open_scene(what, notes.get()));
    std::vector<InputError> bad;
    load_textures(*scene, &bad);
    for (const InputError& e : bad) notes->push_back({e.message(Language::english), e.message(Language::japanese)});
    return [what, notes, scene](App& a) {
      replace_scene(a, std::move(*scene), what);
      for (const Text& note : *notes) say(a, note);
    };
  });
}

void keep_history(App& app) {
  const ImGuiID held = app.sweep.item ? app.sweep.item : ImGui::IsMouseDown(0) ? ImGui::GetActiveID() : 0;
  if (held == 0 && !app.gesture) app.history.end_gesture();
  const std::string gesture = held != 0 ? std::to_string(held) : app.gesture ? "pane" : std::string();
  app.history.change(app.scene, gesture);
}

void save_or_ask(App& app) {
  if (app.preset.empty())
    app.dialogue = {Dialogue::save, "scene.json", true};
  else
    save_as(app, app.preset);
}

void say_saved(App& app, const std::filesystem::path& file, const Text& more) {
  const std::string place = shown_path(file);
  say(app, Text("Saved " + place + more.en, place + " に保存しました" + more.ja));
}

void save_picture(App& app, std::filesystem::path file) {
  const Recorded what = app.settings.picture;
  const DrawingHandle one = app.drawings[what == Recorded::right ? 1 : 0];
  const DrawingHandle two = what == Recorded::both ? app.drawings[1] : nullptr;
  if (!one || (what == Recorded::both && !two)) return;
  app.errands->run(app, [file, one, two]() -> Errands::Done {
    write_image(file, two ? beside(one->frame.colour, two->frame.colour) : one->frame.colour, one->scene.display);
    return [file](App& a) { say_saved(a, file); };
  });
}

void save_as(App& app, std::filesystem::path file) {
  if (file.extension() != ".json") file += ".json";
  app.errands->run(app, [file, scene = app.scene]() -> Errands::Done {
    save_preset(scene, file);
    return [file](App& a) {
      a.preset = file.string();
      add_recent(a.recent, std::filesystem::absolute(file).string());
      say_saved(a, file);
    };
  });
}

}  // namespace cg
