// What was read from a file or made, kept as long as somebody holds it, and made again when the file has changed.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <system_error>
#include <utility>

namespace cg {

// What tells a file from an older version of itself.
struct Stamp {
  std::filesystem::file_time_type changed;
  std::uintmax_t size = 0;
  friend bool operator==(const Stamp&, const Stamp&) = default;
};

inline Stamp stamp_of(const std::filesystem::path& file) {
  std::error_code error;
  const Stamp stamp{std::filesystem::last_write_time(file, error), std::filesystem::file_size(file, error)};
  return error ? Stamp{} : stamp;
}

// Values that are remembered as long as somebody holds them.
template <class Key, class T>
class Remembered {
 public:
  // `make` is called where nothing is remembered under the key, or something with another stamp. Others wait meanwhile:
  // they may want the same.
  template <class Make>
  std::shared_ptr<const T> get(const Key& key, const Stamp& stamp, Make make) {
    const std::lock_guard lock(mutex_);
    if (const auto known = entries_.find(key); known != entries_.end() && known->second.first == stamp)
      if (auto value = known->second.second.lock()) return value;
    std::erase_if(entries_, [](const auto& entry) { return entry.second.second.expired(); });
    std::shared_ptr<const T> value = make();
    entries_[key] = {stamp, value};
    return value;
  }

 private:
  std::mutex mutex_;
  std::map<Key, std::pair<Stamp, std::weak_ptr<const T>>> entries_;
};

}  // namespace cg
