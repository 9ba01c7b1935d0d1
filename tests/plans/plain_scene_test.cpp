// One mesh, one directional light that is diffuse, no texture: nothing runs, is held or is compiled that this does not
// use. Asked of the memory itself, of OpenGL's objects and of the shaders that it was given.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <set>

#include "gl/gl_plan.h"
#include "gl/gl_thread.h"
#include "gl/glsl_renderer.h"
#include "raster/software.h"
#include "tests/plans/plan_scenes.h"
#include "workbench/measured_plan.h"

namespace {

// Every block of 2 KiB and more that is asked for while `watching`.
std::atomic<bool> watching{false};
std::atomic<std::size_t> large_blocks{0}, large_bytes{0};

void* allocate(std::size_t size) noexcept {
  if (watching && size >= 2048) ++large_blocks, large_bytes += size;
  return std::malloc(size ? size : 1);
}

void* allocate_or_throw(std::size_t size) {
  if (void* p = allocate(size)) return p;
  throw std::bad_alloc();
}

}  // namespace

// Each form that an unaligned delete can meet, or AddressSanitizer finds its own new before our free.
void* operator new(std::size_t size) { return allocate_or_throw(size); }
void* operator new[](std::size_t size) { return allocate_or_throw(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }

namespace cg {
namespace {

using Ids = std::set<std::string>;

Ids ids_of(const Frame& frame) {
  Ids ids;
  for (const PassRun& run : frame.passes) ids.insert(run.id);
  return ids;
}

std::size_t bytes_of(const Frame& frame, const std::string& id) {
  for (const PassRun& run : frame.passes)
    if (run.id == id) return run.bytes;
  return 0;
}

Frame draw_plain(const Technique& t, ShadingMode mode, int times) {
  Scene scene = plain_scene();
  scene.shading.mode = mode;
  const View view = view_of(256, 256);
  const Plan plan = t.plan(scene, view);
  Progress progress;
  Frame frame;
  for (int i = 0; i < times; ++i) {
    frame = {};
    large_blocks = large_bytes = 0;
    watching = true;
    frame = t.render(scene, plan, view, progress);
    watching = false;
  }
  return frame;
}

const Ids software_needs{"picture", "surfaces", "transform", "visibility", "mark-visible", "diffuse"};

Ids with(Ids ids, std::initializer_list<const char*> more) {
  ids.insert(more.begin(), more.end());
  return ids;
}

TEST(PlainScene, SoftwareRunsWhatItNeeds) {
  const Technique t = software_technique();
  EXPECT_EQ(ids_of(draw_plain(t, ShadingMode::gouraud, 1)), with(software_needs, {"vertex-lighting", "interpolation"}));
  EXPECT_EQ(ids_of(draw_plain(t, ShadingMode::flat, 1)), with(software_needs, {"face-lighting", "interpolation"}));
  EXPECT_EQ(ids_of(draw_plain(t, ShadingMode::phong, 1)), with(software_needs, {"vertex-to-eye", "pixel-lighting"}));
}

// The recorded bytes are all there are: what the program asks of the heap is no more than the lines of the trace.
TEST(PlainScene, SoftwareHoldsWhatItRecords) {
  const Technique t = software_technique();
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong}) {
    const Frame frame = draw_plain(t, mode, 1);
    std::size_t recorded = 0;
    for (const PassRun& run : frame.passes)
      if (run.id != "surfaces" && run.id != "visibility") recorded += run.bytes;  // made before; oneTBB's own memory
    EXPECT_LE(large_bytes, recorded);
    EXPECT_GE(double(large_bytes), 0.9 * double(recorded));
    // A second picture asks for itself alone: three images.
    const Frame second = draw_plain(t, mode, 2);
    EXPECT_EQ(large_blocks, 3u);
    EXPECT_EQ(large_bytes, bytes_of(second, "picture"));
  }
}

// The light that does not use P carries no P.
TEST(PlainScene, SoftwareCarriesOnlyWhatItsLightDependsOn) {
  const Technique t = software_technique();
  const std::size_t vertices = make_surface(*sphere_mesh(), NormalRule::file, 180)->positions.size();
  EXPECT_EQ(bytes_of(draw_plain(t, ShadingMode::phong, 1), "vertex-to-eye"), vertices * sizeof(glm::dvec3));
  const Scene full = full_scene();
  EXPECT_TRUE(software_technique().plan(full, view_of(64, 64)).runs("local-viewer"));
}

class PlainGlsl : public testing::Test {
 protected:
  // Draws in a context of its own and calls look(renderer, frame, plan) there.
  template <class Look>
  void draw(const Scene& scene, const View& view, const Look& look) {
    try {
      thread_.run([&] {
        Progress progress;
        const Plan plan = gl_plan(scene, view);
        const Frame frame = renderer_.render(scene, plan, view, progress);
        look(renderer_, frame, plan);
        renderer_.release();
      });
    } catch (const NoContext& none) {
      skipped_ = none.reason.en;
    }
    if (!skipped_.empty()) GTEST_SKIP() << skipped_;
  }

  GlslRenderer renderer_;
  GlThread thread_{GlProfile::core};
  std::string skipped_;
};

// `which`: GL_ACTIVE_UNIFORMS or GL_ACTIVE_ATTRIBUTES, and the function that names one of them.
template <class Name>
Ids active_names(GLuint program, GLenum which, const Name& name_of) {
  Ids names;
  GLint count = 0;
  glGetProgramiv(program, which, &count);
  for (GLint i = 0; i < count; ++i) {
    char name[256];
    GLint size = 0;
    GLenum type = 0;
    name_of(program, GLuint(i), sizeof name, nullptr, &size, &type, name);
    names.insert(name);
  }
  return names;
}

Ids uniforms_of(GLuint program) { return active_names(program, GL_ACTIVE_UNIFORMS, glGetActiveUniform); }
Ids attributes_of(GLuint program) { return active_names(program, GL_ACTIVE_ATTRIBUTES, glGetActiveAttrib); }

// What all buffers hold, by OpenGL's own account.
std::size_t bytes_of_buffers() {
  std::size_t all = 0;
  for (GLuint name = 1; name < 1000; ++name) {
    if (!glIsBuffer(name)) continue;
    GLint size = 0;
    glBindBuffer(GL_ARRAY_BUFFER, name);
    glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &size);
    all += std::size_t(size);
  }
  return all;
}

// What all renderbuffers hold: width x height x the bits of their components.
std::size_t bytes_of_renderbuffers() {
  std::size_t all = 0;
  for (GLuint name = 1; name < 1000; ++name) {
    if (!glIsRenderbuffer(name)) continue;
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    const auto get = [](GLenum what) {
      GLint v = 0;
      glGetRenderbufferParameteriv(GL_RENDERBUFFER, what, &v);
      return std::size_t(v);
    };
    std::size_t bits = 0;
    for (const GLenum part : {GL_RENDERBUFFER_RED_SIZE, GL_RENDERBUFFER_GREEN_SIZE, GL_RENDERBUFFER_BLUE_SIZE,
                              GL_RENDERBUFFER_ALPHA_SIZE, GL_RENDERBUFFER_DEPTH_SIZE})
      bits += get(part);
    all += get(GL_RENDERBUFFER_WIDTH) * get(GL_RENDERBUFFER_HEIGHT) * bits / 8;
  }
  return all;
}

GLuint only_program() {
  for (GLuint name = 1; name < 1000; ++name)
    if (glIsProgram(name)) return name;
  return 0;
}

int programs_of_context() {
  int n = 0;
  for (GLuint name = 1; name < 1000; ++name) n += glIsProgram(name) == GL_TRUE;
  return n;
}

TEST_F(PlainGlsl, RunsHoldsAndCompilesWhatItNeeds) {
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong}) {
    Scene scene = plain_scene();
    scene.shading.mode = mode;
    const bool phong = mode == ShadingMode::phong;
    draw(scene, view_of(64, 64), [&](const GlslRenderer& r, const Frame& frame, const Plan&) {
      EXPECT_EQ(ids_of(frame), (Ids{"picture", "surfaces", "target", "compile", "vertex-upload", "normal-buffers",
                                    "draw", "read-back", "diffuse", phong ? "pixel-lighting" : "vertex-lighting"}));
      EXPECT_EQ(r.programs().size(), 1u);
      EXPECT_EQ(programs_of_context(), 1);
      EXPECT_EQ(uniforms_of(only_program()),
                (Ids{"surface_to_clip", "normal_to_eye", "lights[0].diffuse", "lights[0].position", "material.k_d"}));
      EXPECT_EQ(attributes_of(only_program()), (Ids{"position", "normal"}));
      EXPECT_EQ(bytes_of_buffers(), bytes_of(frame, "vertex-upload") + bytes_of(frame, "normal-buffers"));
      EXPECT_EQ(bytes_of_buffers(), r.buffers().bytes());
      EXPECT_EQ(bytes_of_renderbuffers(), bytes_of(frame, "target"));
    });
  }
}

TEST_F(PlainGlsl, WithoutLightThereAreNoNormals) {
  Scene scene = plain_scene();
  scene.shading.ambient = {1, 1, 1}, scene.material.k_a = {0.5, 0.5, 0.5};
  scene.lights.clear();
  draw(scene, view_of(64, 64), [&](const GlslRenderer&, const Frame& frame, const Plan&) {
    EXPECT_EQ(ids_of(frame).count("normal-buffers"), 0u);
    EXPECT_EQ(uniforms_of(only_program()), (Ids{"surface_to_clip", "ambient", "material.k_a"}));
    EXPECT_EQ(attributes_of(only_program()), (Ids{"position"}));
    EXPECT_EQ(bytes_of_buffers(), bytes_of(frame, "vertex-upload"));
  });
}

TEST_F(PlainGlsl, WithoutAnythingThereIsNoOpenGl) {
  draw(Scene{}, view_of(64, 64), [&](const GlslRenderer& r, const Frame& frame, const Plan&) {
    EXPECT_EQ(ids_of(frame), Ids{"picture"});
    EXPECT_EQ(r.programs().size(), 0u);
    EXPECT_EQ(r.target().bytes().picture, 0u);
    EXPECT_EQ(bytes_of_buffers() + bytes_of_renderbuffers(), 0u);
  });
}

// The other end: each thing that the plain scene goes without is there where it is used.
TEST_F(PlainGlsl, TheFullSceneHasItAll) {
  for (const ShadingMode mode : {ShadingMode::gouraud, ShadingMode::phong}) {
    Scene scene = full_scene_with_radiosity();
    scene.shading.mode = mode;
    draw(scene, view_of(64, 64, true), [&](const GlslRenderer& r, const Frame& frame, const Plan& plan) {
      EXPECT_TRUE(differences(plan, frame).empty());
      for (const Pass& pass : plan.passes) {
        const bool other_mode = pass.id == (mode == ShadingMode::phong ? "vertex-lighting" : "pixel-lighting");
        const bool excluded = pass.id == "samples";  // by the ids
        EXPECT_EQ(pass.needed, !other_mode && !excluded) << pass.id;
      }
      EXPECT_EQ(r.programs().size(), 2u);  // one object shines, the other has highlights
      Ids uniforms;
      for (GLuint name = 1; name < 1000; ++name)
        if (glIsProgram(name)) uniforms.merge(uniforms_of(name));
      for (const char* name :
           {"ambient", "material.k_a", "material.k_d", "material.k_s", "material.n", "material.emission",
            "lights[2].spot_cosine", "lights[1].k_1", "lights[0].directional", "lights[0].ambient",
            "lights[2].specular", "surface_to_eye", "normal_to_world", "object"})
        EXPECT_TRUE(uniforms.count(name)) << name;
      EXPECT_EQ(bytes_of_buffers(), bytes_of(frame, "vertex-upload") + bytes_of(frame, "normal-buffers") +
                                        bytes_of(frame, "radiosity") / 2 +  // the other half is the surface's
                                        bytes_of(frame, "uv") / 2);
      EXPECT_EQ(r.textures().bytes(), bytes_of(frame, "texture-upload"));
      EXPECT_EQ(bytes_of_renderbuffers(),
                bytes_of(frame, "target") + r.target().bytes().ids + r.target().bytes().normals);
    });
  }
}

}  // namespace
}  // namespace cg
