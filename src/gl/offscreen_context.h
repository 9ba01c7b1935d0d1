// An OpenGL context without a window: EGL, surfaceless, as EGL_KHR_surfaceless_context describes it.
#pragma once
#include <stdexcept>

#include "params/words.h"

namespace cg {

enum class GlProfile {
  legacy,  // the fixed function: a compatibility context of at least 3.0
  core     // 3.3 core
};

// There is no such context here; the reason in both languages.
class NoContext : public std::runtime_error {
 public:
  explicit NoContext(Text why) : std::runtime_error(why.en), reason(std::move(why)) {}
  Text reason;
};

// Made current on the thread that constructs it, and to be destroyed on the same thread. One a thread.
class OffscreenContext {
 public:
  // Throws NoContext.
  explicit OffscreenContext(GlProfile profile);
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace cg
