// bench [--pairs N] [--size WxH]: how fast the software pipeline draws beside llvmpipe, and what threads and double
// precision cost. One process; the two of a pair take turns, so that both see the machine at the same speed. CPU time
// of the whole process, so that llvmpipe's threads count too (it gets one). Meshes, surfaces and vertex buffers are
// resident, as while a slider moves; OpenGL's time is told without and with reading the picture back.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>

#include "gl/techniques.h"
#include "raster/software.h"
#include "scene/shape.h"

namespace {

using namespace cg;

double seconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return double(t.tv_sec) + double(t.tv_nsec) * 1e-9;
}

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v.empty() ? 0 : v[v.size() / 2];
}

struct Run {
  const Technique* technique;
  Scene scene;
  View view;
  // Milliseconds: CPU time inside the technique, CPU time and wall time of the whole call.
  std::vector<double> drawn_ms, cpu_ms, wall_ms;

  void once() {
    Progress progress;
    const Plan plan = technique->plan(scene, view);
    const double cpu = seconds(CLOCK_PROCESS_CPUTIME_ID), wall = seconds(CLOCK_MONOTONIC);
    const Frame frame = technique->render(scene, plan, view, progress);
    cpu_ms.push_back((seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu) * 1e3);
    wall_ms.push_back((seconds(CLOCK_MONOTONIC) - wall) * 1e3);
    drawn_ms.push_back(frame.cpu_ms);
  }
};

// The median of the ratios of pairs, which a slow moment of the machine disturbs less than a ratio of medians.
double ratio(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> r;
  for (std::size_t i = 0; i < a.size(); ++i) r.push_back(a[i] / b[i]);
  return median(r);
}

void take_turns(Run& a, Run& b, int pairs) {
  a.once(), b.once();  // warm: surfaces, buffers, shaders
  for (Run* r : {&a, &b}) r->drawn_ms.clear(), r->cpu_ms.clear(), r->wall_ms.clear();
  for (int i = 0; i < pairs; ++i) i % 2 ? (b.once(), a.once()) : (a.once(), b.once());
}

Scene torus_scene(int level, ShadingMode mode, Precision precision) {
  Scene scene;
  Object o;
  o.mesh = make_shape(*find_shape("torus"), level);
  scene.objects = {o};
  scene.camera.position = {0, 1.4, 2.4};
  scene.shading.mode = mode;
  scene.shading.precision = precision;
  return scene;
}

void against_opengl(const char* name, Run ours, Run theirs, double goal, int pairs) {
  if (theirs.technique->unavailable) return;
  take_turns(ours, theirs, pairs);
  std::printf("  %-34s %8.2f ms   %s %8.2f ms (read back %8.2f)   %5.2f times as fast (read back %5.2f)  goal %.1f\n",
              name, median(ours.cpu_ms), theirs.technique->id.c_str(), median(theirs.drawn_ms), median(theirs.cpu_ms),
              ratio(theirs.drawn_ms, ours.cpu_ms), ratio(theirs.cpu_ms, ours.cpu_ms), goal);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  int pairs = 15;
  View view{1024, 1024};
  for (int i = 1; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--pairs") == 0) pairs = std::max(1, std::atoi(argv[i + 1]));
    if (std::strcmp(argv[i], "--size") == 0) std::sscanf(argv[i + 1], "%dx%d", &view.width, &view.height);
  }
  setenv("LP_NUM_THREADS", "0", 1);  // llvmpipe draws on the thread that calls it
  const Technique software = software_technique();
  std::vector<Technique> gl = gl_techniques();
  for (Technique& t : gl) {
    find_availability(t);
    if (t.unavailable) std::printf("%s: %s\n", t.id.c_str(), t.unavailable->en.c_str());
  }
  const auto find = [&](const char* id) -> const Technique* {
    return &*std::find_if(gl.begin(), gl.end(), [&](const Technique& t) { return t.id == id; });
  };
  const Technique *fixed = find("gl-fixed"), *glsl = find("gl");
  constexpr auto single = Precision::single_precision, twice = Precision::double_precision;
  for (const char* wanted : {"70k", "250k", "1M"}) {
    const double triangles = wanted[0] == '7' ? 70e3 : wanted[0] == '2' ? 250e3 : 1e6;
    int level = 6;
    while (level < 1000 && double(make_shape(*find_shape("torus"), level)->triangles().size()) < triangles)
      level += std::max(1, level / 20);
    const auto run = [&](const Technique* t, ShadingMode mode, Precision precision, int threads = 1) {
      View v = view;
      v.threads = threads;
      return Run{t, torus_scene(level, mode, precision), v, {}, {}, {}};
    };
    std::printf("torus of %zu triangles, %dx%d, median of %d pairs, CPU time\n",
                torus_scene(level, ShadingMode::flat, single).objects[0].mesh->triangles().size(), view.width,
                view.height, pairs);
    const auto gouraud = ShadingMode::gouraud, phong = ShadingMode::phong;
    against_opengl("Gouraud, software float", run(&software, gouraud, single), run(fixed, gouraud, single), 2, pairs);
    against_opengl("Gouraud, software double", run(&software, gouraud, twice), run(fixed, gouraud, twice), 2, pairs);
    against_opengl("Phong, software float", run(&software, phong, single), run(glsl, phong, single), 1.5, pairs);
    against_opengl("Phong, software double", run(&software, phong, twice), run(glsl, phong, twice), 1.5, pairs);
    for (const ShadingMode mode : {gouraud, phong}) {
      Run one = run(&software, mode, single), two = run(&software, mode, single, 2), wide = run(&software, mode, twice);
      take_turns(one, two, pairs);
      std::printf("  %-34s %8.2f ms   2 threads %8.2f ms   %5.2f times as fast  goal 1.7 (wall time)\n",
                  mode == gouraud ? "Gouraud, 1 thread" : "Phong, 1 thread", median(one.wall_ms), median(two.wall_ms),
                  ratio(one.wall_ms, two.wall_ms));
      take_turns(one, wide, pairs);
      std::printf("  %-34s double costs %.2f times float\n", "", ratio(wide.cpu_ms, one.cpu_ms));
      std::fflush(stdout);
    }
  }
}
