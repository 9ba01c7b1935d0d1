// bench [--pairs N] [--size WxH] [--triangles 70k|250k|1M]: how fast the software pipeline draws beside llvmpipe, and
// what threads and double precision cost. One process; the two of a pair take turns, so that both see the machine at
// the same speed. CPU time of the whole process, so that llvmpipe's threads count too (it gets one). Meshes, surfaces
// and vertex buffers are resident, and the camera turns a little from picture to picture, so that nothing drawn is
// kept; OpenGL's time is told without and with reading the picture back. Threads are compared by wall time, on a
// machine that may be busy: beside the median of the pairs stand the fastest of all runs, the CPU time of the busier
// thread, and the limit of the machine, two pictures by one thread each at once.
#include <algorithm>
#include <atomic>
#include <barrier>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <thread>

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

double least(const std::vector<double>& v) { return v.empty() ? 0 : *std::min_element(v.begin(), v.end()); }

struct Run {
  const Technique* technique;
  Scene scene;
  View view;
  // Milliseconds: CPU time inside the technique, CPU time and wall time of the whole call, and CPU time of the busier
  // of two threads.
  std::vector<double> drawn_ms, cpu_ms, wall_ms, busier_ms;

  void once() {
    static std::atomic<unsigned> pictures{0};  // of all runs: some share a technique, which keeps what it drew last
    scene.camera.position.x = 1e-4 * (pictures++ % 64);
    Progress progress;
    const Plan plan = technique->plan(scene, view);
    const double cpu = seconds(CLOCK_PROCESS_CPUTIME_ID), own = seconds(CLOCK_THREAD_CPUTIME_ID);
    const double wall = seconds(CLOCK_MONOTONIC);
    const Frame frame = technique->render(scene, plan, view, progress);
    wall_ms.push_back((seconds(CLOCK_MONOTONIC) - wall) * 1e3);
    const double own_ms = (seconds(CLOCK_THREAD_CPUTIME_ID) - own) * 1e3;
    cpu_ms.push_back((seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu) * 1e3);
    busier_ms.push_back(std::max(own_ms, cpu_ms.back() - own_ms));
    drawn_ms.push_back(frame.cpu_ms);
  }
  void forget() { drawn_ms.clear(), cpu_ms.clear(), wall_ms.clear(), busier_ms.clear(); }
};

// The median of the ratios of pairs, which a slow moment of the machine disturbs less than a ratio of medians.
double ratio(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> r;
  for (std::size_t i = 0; i < a.size(); ++i) r.push_back(a[i] / b[i]);
  return median(r);
}

void take_turns(Run& a, Run& b, int pairs) {
  a.once(), b.once();  // warm: surfaces, buffers, shaders
  a.forget(), b.forget();
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

// What the machine itself gives to a second thread: two pictures drawn at once, one thread each, against one picture
// alone. Also the fastest of all runs.
double limit_of_machine(Run one, const Technique& another, int pairs) {
  constexpr int pictures = 4;  // between two meetings, so that to meet costs little
  Run beside = one;
  beside.technique = &another;  // with buffers of its own
  std::vector<double> alone_ms, both_ms;
  std::barrier meeting(2);
  const auto draw = [](Run& run) {
    for (int i = 0; i < pictures; ++i) run.once();
  };
  const auto timed = [](std::vector<double>& ms, const auto& work) {
    const double begin = seconds(CLOCK_MONOTONIC);
    work();
    ms.push_back((seconds(CLOCK_MONOTONIC) - begin) * 1e3);
  };
  std::jthread second([&] {
    for (int i = 0; i < pairs; ++i) meeting.arrive_and_wait(), draw(beside), meeting.arrive_and_wait();
  });
  for (int i = 0; i < pairs; ++i) {
    timed(alone_ms, [&] { draw(one); });
    meeting.arrive_and_wait();
    timed(both_ms, [&] { draw(one), meeting.arrive_and_wait(); });
  }
  return 2 * least(alone_ms) / least(both_ms);
}

void against_threads(const char* name, Run one, const Technique& another, int pairs) {
  Run two = one;
  two.technique = &another;  // which keeps what two threads need from picture to picture
  two.view.threads = 2;
  take_turns(one, two, pairs);
  const double fastest = least(one.wall_ms) / least(two.wall_ms), limit = limit_of_machine(one, another, pairs);
  std::printf("  %-34s %8.2f ms   2 threads %8.2f ms   %5.2f times as fast  goal 1.7 (wall time)\n", name,
              median(one.wall_ms), median(two.wall_ms), ratio(one.wall_ms, two.wall_ms));
  std::printf(
      "  %-34s fastest runs %.2f, by the busier thread's CPU time %.2f, by that of both %.2f, limit of the machine "
      "%.2f\n",
      "", fastest, median(one.cpu_ms) / median(two.busier_ms), 2 * median(one.cpu_ms) / median(two.cpu_ms), limit);
  std::fflush(stdout);
}

void against_double(Run narrow, int pairs) {
  Run wide = narrow;
  wide.scene.shading.precision = Precision::double_precision;
  take_turns(narrow, wide, pairs);
  std::printf("  %-34s double costs %.2f times float\n", "", ratio(wide.cpu_ms, narrow.cpu_ms));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  int pairs = 15;
  View view{1024, 1024};
  const char* only = nullptr;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--pairs") == 0) pairs = std::max(1, std::atoi(argv[i + 1]));
    if (std::strcmp(argv[i], "--triangles") == 0) only = argv[i + 1];
    if (std::strcmp(argv[i], "--size") == 0) std::sscanf(argv[i + 1], "%dx%d", &view.width, &view.height);
  }
  setenv("LP_NUM_THREADS", "0", 1);  // llvmpipe draws on the thread that calls it
  const Technique software = software_technique(), another = software_technique();
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
    if (only && std::strcmp(only, wanted) != 0) continue;
    const double triangles = wanted[0] == '7' ? 70e3 : wanted[0] == '2' ? 250e3 : 1e6;
    int level = 6;
    while (level < 1000 && double(make_shape(*find_shape("torus"), level)->triangles().size()) < triangles)
      level += std::max(1, level / 20);
    const auto run = [&](const Technique* t, ShadingMode mode, Precision precision) {
      return Run{t, torus_scene(level, mode, precision), view, {}, {}, {}, {}};
    };
    double load = 0;
    getloadavg(&load, 1);
    std::printf("torus of %zu triangles, %dx%d, median of %d pairs, CPU time; load average %.1f\n",
                torus_scene(level, ShadingMode::flat, single).objects[0].mesh->triangles().size(), view.width,
                view.height, pairs, load);
    const auto gouraud = ShadingMode::gouraud, phong = ShadingMode::phong;
    against_opengl("Gouraud, software float", run(&software, gouraud, single), run(fixed, gouraud, single), 2, pairs);
    against_opengl("Gouraud, software double", run(&software, gouraud, twice), run(fixed, gouraud, twice), 2, pairs);
    against_opengl("Phong, software float", run(&software, phong, single), run(glsl, phong, single), 1.5, pairs);
    against_opengl("Phong, software double", run(&software, phong, twice), run(glsl, phong, twice), 1.5, pairs);
    for (const ShadingMode mode : {gouraud, phong}) {
      const Run one = run(&software, mode, single);
      against_threads(mode == gouraud ? "Gouraud, 1 thread" : "Phong, 1 thread", one, another, pairs);
      against_double(one, pairs);
    }
  }
}
