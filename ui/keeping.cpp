#include "ui/keeping.h"

#include <algorithm>

#include "ui/app.h"
#include "ui/extremes_desk.h"
#include "ui/lesson_player.h"
#include "ui/quiz.h"

namespace cg {
namespace {

int index_of(const std::vector<Technique>& all, const std::string& id, int otherwise) {
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].id == id && !all[i].unavailable) return int(i);
  return std::clamp(otherwise, 0, std::max(0, int(all.size()) - 1));
}

}  // namespace

void choose_techniques(App& app) {
  app.left = index_of(app.techniques, app.settings.left, 0);
  app.right = index_of(app.techniques, app.settings.right, int(app.techniques.size()) - 1);
}

void restore(App& app, WindowPlacement& placement, SessionStore& store, bool with_scene) {
  Session session = store.load();
  take_values(slots(app.settings), session.settings);
  take_values(slots(placement), session.window);
  app.recent = session.recent;
  if (with_scene && session.scene) {
    app.scene = std::move(*session.scene);
    if (session.source.ends_with(".json")) app.preset = session.source;
  }
}

void keep(App& app, const WindowPlacement& placement, SessionStore& store) {
  const auto id = [&](int i) {
    return i >= 0 && i < int(app.techniques.size()) ? app.techniques[std::size_t(i)].id : std::string();
  };
  app.settings.left = id(app.left), app.settings.right = id(app.right);
  app.settings.lesson = app.lessons ? app.lessons->place() : std::string();
  WindowPlacement place = placement;
  Session session;
  session.scene = app.quiz ? app.quiz->quiz.before() : app.scene;
  if (!can_be_kept(*session.scene) && app.extremes) session.scene = app.extremes->before;
  session.source = app.preset;
  session.recent = app.recent;
  session.settings = values_of(slots(app.settings));
  session.window = values_of(slots(place));
  store.keep(session, app.now);
  while (const std::optional<Text> message = store.next_message()) say(app, *message);
}

}  // namespace cg
