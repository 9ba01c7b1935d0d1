// What the mistakes do to the scene, computed on a thread of its own: the window never waits for a mesh.
#pragma once
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "workbench/mistake_effects.h"
#include "workbench/worker.h"

namespace cg {

class MistakeJobs {
 public:
  // Asks for the effects of `mistakes` (names of members of Mistakes) in a picture of `view`'s size; cheap where
  // nothing changed since the last time. `wake` is called, from the thread, when they are there.
  void want(const Scene& scene, const std::vector<std::string>& mistakes, const View& view, std::function<void()> wake);
  // The newest there is, of the scene now or a moment ago; nothing before the first.
  std::optional<MistakeEffect> of(const std::string& mistake) const;
  bool busy() const { return worker_.busy(); }

 private:
  Scene scene_;
  std::vector<std::string> mistakes_;
  View view_;
  mutable std::mutex mutex_;
  std::map<std::string, MistakeEffect> effects_;
  Worker worker_;  // last: it uses what stands above
};

}  // namespace cg
