// The dialogue for pictures: one is saved, or from now on all are recorded.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <filesystem>

#include "ui/app.h"
#include "ui/layout.h"
#include "ui/opening.h"
#include "ui/recording.h"
#include "ui/widgets.h"
#include "workbench/environment.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

bool can_save(const App& app) {
  switch (app.settings.picture) {
    case Recorded::left:
      return bool(app.drawings[0]);
    case Recorded::right:
      return bool(app.drawings[1]);
    case Recorded::both:
      return app.drawings[0] && app.drawings[1];
    case Recorded::window:
      return true;
  }
  return false;
}

void save(App& app) {
  const fs::path file = typed_path(app.dialogue.text);
  if (app.settings.picture == Recorded::window)
    recorder_of(app).save_window(file);
  else
    save_picture(app, file);
}

// "clip.png" is recorded as clip.gif, or into the folder clip.
void record(App& app) {
  fs::path path = typed_path(app.dialogue.text);
  path.replace_extension(app.settings.record_as == RecordedAs::gif ? ".gif" : "");
  start_recording(app, path);
}

}  // namespace

bool draw_picture_dialogue(App& app) {
  const Language l = app.language();
  const bool entered = save_field(app, {"picture.png", "picture.png"});
  ImGui::Dummy({1, app.look.px(4)});
  int picture = int(app.settings.picture);
  if (choose(app, "picture", names_of<Recorded>, picture)) app.settings.picture = Recorded(picture);
  ImGui::Dummy({1, app.look.px(4)});
  const bool named = !app.dialogue.text.empty(), able = can_save(app) && named;
  bool done = false;
  if ((button(app, "save", {.label = Words{"Save", "保存"}.in(l), .enabled = able}) || entered) && able) {
    save(app);
    done = true;
  }
  heading(app, Words{"PNG and JPEG as shown; EXR and HDR keep the linear numbers",
                     "PNG と JPEG は表示どおり、EXR と HDR は線形の値のまま"}
                   .in(l));
  ImGui::Dummy({1, app.look.px(8)});
  int as = int(app.settings.record_as);
  if (choose(app, "as", names_of<RecordedAs>, as)) app.settings.record_as = RecordedAs(as);
  ImGui::Dummy({1, app.look.px(4)});
  if (button(app, "record",
             {.label = Words{"Record from now on", "ここから録画する"}.in(l), .shortcut = "Ctrl+R", .enabled = able})) {
    record(app);
    done = true;
  }
  heading(app, Words{"A click on the red dot ends it; the file appears when it is whole",
                     "赤い点をクリックすると終わる。ファイルは完成してから現れる"}
                   .in(l));
  return done;
}

}  // namespace cg
