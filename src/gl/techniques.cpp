#include "gl/techniques.h"

#include <algorithm>
#include <memory>
#include <new>

#include "gl/fixed_renderer.h"
#include "gl/gl_plan.h"
#include "gl/gl_thread.h"
#include "gl/glsl_renderer.h"
#include "params/input_error.h"

namespace cg {

namespace {

// A renderer with the thread that its context lives on.
template <class Renderer>
class Threaded {
 public:
  explicit Threaded(GlProfile profile) : thread_(profile) {
    thread_.at_exit([this] { renderer_.release(); });
  }

  Frame render(const std::string& id, const Scene& scene, const Plan& plan, const View& view, Progress& progress) {
    Frame frame;
    try {
      thread_.run([&] {
        if (view.width > 0 && view.height > 0) {
          frame = renderer_.render(scene, plan, view, progress);
        } else {
          PassRecorder record;
          frame = empty_frame(scene, view, record);
        }
      });
    } catch (const NoContext& none) {
      throw InputError(id, none.reason, Words{"the technique software would work", "ソフトウェア描画なら使えます"});
    } catch (const std::bad_alloc&) {
      throw InputError(id, Words{"there is not enough memory for this picture", "この画像にはメモリーが足りません"},
                       Words{"a smaller one would work", "小さくすれば描けます"});
    }
    return frame;
  }

  std::optional<Text> failure() const { return thread_.failure(); }

  std::string device() {
    std::string name;
    ask([&] {
      for (const GLenum part : {GL_RENDERER, GL_VERSION})
        if (const GLubyte* said = glGetString(part))
          (name += name.empty() ? "" : ", ") += reinterpret_cast<const char*>(said);
    });
    return name;
  }

  int most_samples() {
    GLint most = 1;
    ask([&] { glGetIntegerv(GL_MAX_SAMPLES, &most); });
    return std::max(most, 1);
  }

 private:
  // Where there is no context the question has no answer.
  void ask(const std::function<void()>& question) {
    try {
      thread_.run(question);
    } catch (const NoContext&) {
    }
  }

  Renderer renderer_;
  GlThread thread_;  // ends first
};

using Support = std::optional<Text> (*)(const Scene&);

template <class Renderer>
Technique technique(std::string id, Words name, GlProfile profile, Plan (*plan)(const Scene&, const View&),
                    Support unsupported) {
  const auto gl = std::make_shared<Threaded<Renderer>>(profile);
  Technique t;
  t.id = id;
  t.name = name;
  t.unsupported = [gl, unsupported](const Scene& scene) {
    const std::optional<Text> failure = gl->failure();
    return failure ? failure : unsupported(scene);
  };
  t.plan = plan;
  t.device = [gl] { return gl->device(); };
  if constexpr (std::is_same_v<Renderer, GlslRenderer>) t.most_samples = [gl] { return gl->most_samples(); };
  t.render = [gl, id](const Scene& scene, const Plan& plan, const View& view, Progress& progress) {
    return gl->render(id, scene, plan, view, progress);
  };
  return t;
}

std::optional<Text> everything(const Scene&) { return std::nullopt; }

}  // namespace

std::vector<Technique> gl_techniques() {
  return {technique<FixedRenderer>("gl-fixed", {"OpenGL, fixed function", "OpenGL 固定機能"}, GlProfile::legacy,
                                   gl_fixed_plan, unsupported_by_fixed_function),
          technique<GlslRenderer>("gl", {"OpenGL, GLSL", "OpenGL GLSL"}, GlProfile::core, gl_plan, everything)};
}

void find_availability(Technique& technique) {
  Progress progress;
  View nothing_to_draw;
  nothing_to_draw.width = nothing_to_draw.height = 0;
  try {
    technique.render(Scene{}, Plan{}, nothing_to_draw, progress);
    technique.unavailable.reset();
  } catch (const InputError& e) {
    technique.unavailable = e.found;
  }
}

}  // namespace cg
