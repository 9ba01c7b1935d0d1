#include "workbench/session.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

#include "params/file.h"
#include "params/input_error.h"
#include "workbench/preset.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t recent_limit = 12;
constexpr double seconds_between_saves = 2;
constexpr const char *session_name = "session.json", *previous_name = "session.previous.json",
                     *unopened_name = "unopened-scene.json", *settings_name = "settings.json";

// Fowler, Noll and Vo's hash FNV-1a, 64 bits, in hexadecimal: a flipped bit anywhere shows.
std::string checksum(std::string_view text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const unsigned char c : text) hash = (hash ^ c) * 1099511628211u;
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), hash, 16).ptr;
  return {digits.data(), end};
}

std::string sealed(const Tree& content) {
  Tree file;
  file.at("checksum") = checksum(to_json(content, 0));
  file.at("content") = content;
  return to_json(file) + "\n";
}

// The content, or nothing where the file is missing or damaged.
std::optional<Tree> opened(const fs::path& file) try {
  const Tree tree = parse_json(read_file(file, std::size_t(16) << 20), file.string());
  const Tree *sum = tree.find("checksum"), *content = tree.find("content");
  if (!sum || !sum->string() || !content || *sum->string() != checksum(to_json(*content, 0))) return std::nullopt;
  return *content;
} catch (const InputError&) {
  return std::nullopt;
}

Tree tree_of(const Session& session) {
  Tree out;
  out.at("source") = session.source;
  Tree::List recent;
  for (const std::string& name : session.recent) recent.emplace_back(name);
  out.at("recent") = std::move(recent);
  out.at("window") = session.window;
  if (session.scene) out.at("scene") = preset_of(*session.scene);
  return out;
}

std::string text_at(const Tree& tree, std::string_view key) {
  const Tree* value = tree.find(key);
  return value && value->string() ? *value->string() : "";
}

// All but the settings. Throws InputError where the scene cannot be opened; the rest is there then.
void take(Session& session, const Tree& tree) {
  session.source = text_at(tree, "source");
  session.recent.clear();
  if (const Tree* recent = tree.find("recent"); recent && recent->list())
    for (const Tree& name : *recent->list())
      if (name.string() && session.recent.size() < recent_limit) session.recent.push_back(*name.string());
  if (const Tree* window = tree.find("window")) session.window = *window;
  if (const Tree* scene = tree.find("scene")) session.scene = scene_of(*scene, "session");
}

// A scene that does not open today may open tomorrow (a folder that was not mounted): what is saved from now on must
// not be its end. Returns a sentence that says where it is.
Text keep_unopened(const Tree& content, const fs::path& file) try {
  save_file(file, to_json(*content.find("scene")) + "\n");
  return {" It is kept as " + file.string() + ".", file.string() + " に残してあります。"};
} catch (const InputError&) {
  return {};
}

}  // namespace

void add_recent(std::vector<std::string>& recent, const std::string& what) {
  std::erase(recent, what);
  recent.insert(recent.begin(), what);
  if (recent.size() > recent_limit) recent.resize(recent_limit);
}

SessionStore::SessionStore(std::optional<fs::path> state, std::optional<fs::path> config)
    : state_(std::move(state)), config_(std::move(config)) {
  if (!state_ || !config_) {
    say({"Nothing is saved: HOME is not set.", "HOME が設定されていないため、何も保存されません。"});
    return;
  }
  std::error_code error;
  fs::create_directories(*state_, error);
  if (!error) fs::create_directories(*config_, error);
  if (!error) lock_ = ::open((*state_ / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock_ < 0) {
    const Text why = system_text(error ? error.value() : errno);
    say({"Nothing is saved in " + state_->string() + ": " + why.en + ".",
         state_->string() + " に保存できません：" + why.ja + "。"});
  } else if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    ::close(std::exchange(lock_, -1));
    say({"Another window is open: this one's session is not saved.",
         "別のウィンドウが開いているため、このウィンドウの状態は保存されません。"});
  }
}

SessionStore::~SessionStore() {
  flush();
  if (lock_ >= 0) ::close(lock_);
}

Session SessionStore::load() {
  Session session;
  std::error_code error;
  if (const auto settings = config_ ? opened(*config_ / settings_name) : std::nullopt)
    session.settings = *settings;
  else if (config_ && fs::exists(*config_ / settings_name, error))
    say({"The settings were damaged; the defaults are used.", "設定が壊れていたため、既定値を使います。"});
  if (!state_) return session;
  auto content = opened(*state_ / session_name);
  const bool damaged = !content && fs::exists(*state_ / session_name, error);
  if (!content) content = opened(*state_ / previous_name);
  if (damaged)
    say(content ? Text{"The last session was damaged; the one saved before it is shown.",
                       "前回の状態が壊れていたため、その一つ前の状態を開きました。"}
                : Text{"The last session was damaged; the defaults are used.",
                       "前回の状態が壊れていたため、既定値を使います。"});
  try {
    if (content) take(session, *content);
  } catch (const InputError& e) {
    const Text kept = lock_ >= 0 ? keep_unopened(*content, *state_ / unopened_name) : Text{};
    say({"The last scene cannot be opened: " + e.message(Language::english) + "." + kept.en,
         "前回のシーンを開けません：" + e.message(Language::japanese) + "。" + kept.ja});
  }
  return session;
}

void SessionStore::keep(const Session& session, double now) {
  if (lock_ < 0) return;
  if (!kept_ || !(*kept_ == session)) kept_ = session, dirty_ = true;
  if (!dirty_ || now - last_ < seconds_between_saves) return;
  last_ = now;
  submit();
}

void SessionStore::flush() {
  if (lock_ >= 0 && dirty_) submit();
  worker_.wait();
}

void SessionStore::submit() {
  dirty_ = false;
  worker_.submit([this, session = *kept_](Progress&) { save(session); });
}

void SessionStore::save(const Session& session) {
  try {
    if (const std::string text = sealed(session.settings); text != saved_settings_) {
      save_file(*config_ / settings_name, text);
      saved_settings_ = text;
    }
    if (const std::string text = sealed(tree_of(session)); text != saved_session_) {
      // Of a crash between the two, load() finds the previous one.
      std::error_code ignored;
      if (opened(*state_ / session_name)) fs::rename(*state_ / session_name, *state_ / previous_name, ignored);
      save_file(*state_ / session_name, text);
      saved_session_ = text;
    }
    const std::lock_guard lock(mutex_);
    failed_ = false;
  } catch (const InputError& e) {
    const bool first = [&] {
      const std::lock_guard lock(mutex_);
      return !std::exchange(failed_, true);
    }();
    if (first)
      say({"Not saved: " + e.message(Language::english) + ".",
           "保存できません：" + e.message(Language::japanese) + "。"});
  }
}

std::optional<Text> SessionStore::next_message() {
  const std::lock_guard lock(mutex_);
  if (messages_.empty()) return std::nullopt;
  Text first = std::move(messages_.front());
  messages_.erase(messages_.begin());
  return first;
}

void SessionStore::say(Text text) {
  const std::lock_guard lock(mutex_);
  messages_.push_back(std::move(text));
}

}  // namespace cg
