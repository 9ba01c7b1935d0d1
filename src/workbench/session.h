// What is remembered between two starts of the window: the scene as a preset and the window's own state in
// XDG_STATE_HOME/shadebench/session.json, its settings in XDG_CONFIG_HOME/shadebench/settings.json.
#pragma once
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "params/slots.h"
#include "scene/scene.h"
#include "workbench/worker.h"

namespace cg {

struct Session {
  std::optional<Scene> scene;       // meshes loaded
  std::string source;               // what it was opened from
  std::vector<std::string> recent;  // what was opened before, the newest first
  Tree window;                      // values_of() a described struct: sizes of the window and its panels
  Tree settings;                    // values_of() a described struct: language, theme, techniques, ...
  friend bool operator==(const Session&, const Session&) = default;
};

// Puts `what` first, once; keeps at most 12.
void add_recent(std::vector<std::string>& recent, const std::string& what);

// Keeps the session on the disk, from a thread of its own. The folder of a Store that is open is locked: a second
// window reads the session but does not save it.
class SessionStore {
 public:
  // Empty: not saved, and said so. SessionStore(state_folder(), config_folder()) is the user's own.
  SessionStore(std::optional<std::filesystem::path> state, std::optional<std::filesystem::path> config);
  // Saves what was kept last.
  ~SessionStore();
  SessionStore(const SessionStore&) = delete;
  SessionStore& operator=(const SessionStore&) = delete;

  // What was saved last. A file that is missing, unreadable or damaged is replaced by the one saved before it, then by
  // nothing; next_message() says so in a sentence. Never throws.
  Session load();

  // Remembers the session as it is now; cheap where nothing changed. It is saved when the last saving was at least 2
  // seconds ago; call it now and then, so that the last change is saved too. `now` in seconds of any steady clock.
  void keep(const Session& session, double now);

  // Saves what was kept, now, and waits until that is done.
  void flush();

  // What the user should be told, once: why nothing is saved, what could not be read.
  std::optional<Text> next_message();

 private:
  void say(Text text);
  void save(const Session& session);
  void submit();

  const std::optional<std::filesystem::path> state_, config_;
  int lock_ = -1;
  std::optional<Session> kept_;
  bool dirty_ = false;
  double last_ = -1e9;
  std::mutex mutex_;  // guards messages_ and failed_
  std::vector<Text> messages_;
  bool failed_ = false;                         // the last saving
  std::string saved_session_, saved_settings_;  // used by the worker's thread alone
  Worker worker_;                               // last: its thread uses all of the above
};

}  // namespace cg
