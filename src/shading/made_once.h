// What is made from something shared, kept while that lives: several techniques ask for the same at the same time.
#pragma once
#include <algorithm>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace cg {

// What something is made from, and may be gone. The parts of a model may have one owner, the model, so the address
// counts as well.
struct MadeFrom {
  std::weak_ptr<const void> owner;
  const void* address;
  bool operator<(const MadeFrom& other) const {
    if (owner.owner_before(other.owner)) return true;
    return !other.owner.owner_before(owner) && std::less<>()(address, other.address);
  }
};

// Safe to use from several threads. Keeps, of each thing, the few values used last, and none of a thing that is gone.
template <class Key, class Value>
class MadeOnce {
 public:
  explicit MadeOnce(std::size_t most) : most_(most) {}

  // make(), or what it returned before. Who asks while another thread makes the same waits for it; others do not.
  template <class Make>
  Value get(const MadeFrom& from, const Key& key, const Make& make) {
    std::promise<Value> promise;
    if (auto made = find_or_add(from, key, promise)) return made->get();
    try {
      Value value = make();
      promise.set_value(value);
      return value;
    } catch (...) {
      promise.set_exception(std::current_exception());
      const std::lock_guard lock(mutex_);
      std::erase_if(things_[from], [&](const Entry& e) { return e.key == key; });
      throw;
    }
  }

 private:
  struct Entry {
    Key key;
    std::shared_future<Value> value;
  };

  // The value where there is one; else an entry is added that `promise` is to fulfil.
  std::optional<std::shared_future<Value>> find_or_add(const MadeFrom& from, const Key& key,
                                                       std::promise<Value>& promise) {
    const std::lock_guard lock(mutex_);
    std::vector<Entry>& entries = things_[from];  // the one used last stands last
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
    if (found != entries.end()) {
      std::rotate(found, found + 1, entries.end());
      return entries.back().value;
    }
    if (entries.size() >= most_) entries.erase(entries.begin());
    entries.push_back({key, promise.get_future().share()});
    std::erase_if(things_, [](const auto& m) { return m.first.owner.expired(); });
    return std::nullopt;
  }

  std::mutex mutex_;
  std::size_t most_;
  std::map<MadeFrom, std::vector<Entry>> things_;
};

}  // namespace cg
