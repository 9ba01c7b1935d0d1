// bench_plain [--pairs N] [--size WxH] [--instructions]: what the plainest scene costs, beside what it costs in a
// program that was built without everything else (bench_plain_only: SHADEBENCH_ONLY_PLAIN). Two processes of one source
// take turns, so that both see the machine at the same speed; CPU time of the whole process. Prints the median of the
// pairs' ratios with the quartiles. Not a test: a time is no promise on another machine. With --instructions it counts,
// under Valgrind, the instructions of a picture instead, which no neighbour on the machine can disturb.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "gl/techniques.h"
#include "raster/software.h"
#include "scene/cpu_clock.h"
#include "scene/shape.h"

namespace {

using namespace cg;

constexpr int draws = 12;  // a measurement

struct Case {
  const char *name, *technique;
  ShadingMode mode;
  Precision precision;
  bool with_plan;  // the plan is made for each picture, as in the window
};
constexpr auto single = Precision::single_precision, twice = Precision::double_precision;
constexpr auto gouraud = ShadingMode::gouraud, phong = ShadingMode::phong;
constexpr std::array cases{Case{"software, float, Gouraud", "software", gouraud, single, false},
                           Case{"software, float, Phong", "software", phong, single, false},
                           Case{"software, double, Gouraud", "software", gouraud, twice, false},
                           Case{"software, double, Phong", "software", phong, twice, false},
                           Case{"software, float, Gouraud, plan", "software", gouraud, single, true},
                           Case{"gl, Gouraud", "gl", gouraud, twice, false},
                           Case{"gl, Phong", "gl", phong, twice, false},
                           Case{"gl, Gouraud, plan", "gl", gouraud, twice, true}};

Scene plain_scene(const Case& c) {
  Scene scene;
  scene.objects.emplace_back().mesh = make_shape(*find_shape("torus"), 64);
  scene.camera.position = {0, 1.4, 4};  // all of it in view
  scene.lights[0].kind = LightKind::directional;
  scene.material.k_a = scene.material.k_s = {0, 0, 0};
  scene.shading.ambient = {0, 0, 0};
  scene.shading.normal_length = NormalLength::off;
  scene.shading.clamp = false;
  scene.shading.mode = c.mode, scene.shading.precision = c.precision;
  return scene;
}

struct Drawing {
  Scene scene;
  Technique technique;
  Plan plan;
};

Drawing prepare(const Case& c, const View& view) {
  std::vector<Technique> all = gl_techniques();
  all.push_back(software_technique());
  Drawing d{
      plain_scene(c), *std::find_if(all.begin(), all.end(), [&](const auto& t) { return t.id == c.technique; }), {}};
  find_availability(d.technique);
  if (!d.technique.unavailable) d.plan = d.technique.plan(d.scene, view);
  return d;
}

void draw(Drawing& d, const Case& c, const View& view) {
  Progress progress;
  if (c.with_plan) d.plan = d.technique.plan(d.scene, view);
  d.technique.render(d.scene, d.plan, view, progress);
}

// Draws what it is told on stdin, a case's number a line; answers with the milliseconds, negative where it cannot.
int work(const View& view) {
  unsigned number = 0;
  while (std::scanf("%u", &number) == 1 && number < cases.size()) {
    const Case& c = cases[number];
    Drawing d = prepare(c, view);
    double ms = -1;
    if (!d.technique.unavailable) {
      draw(d, c, view);  // warm
      const double begin = process_cpu_ms();
      for (int i = 0; i < draws; ++i) draw(d, c, view);
      ms = (process_cpu_ms() - begin) / draws;
    }
    std::printf("%.17g\n", ms);
    std::fflush(stdout);
  }
  return 0;
}

// A case drawn so often, for a program that counts.
int draw_only(const Case& c, int times, const View& view) {
  Drawing d = prepare(c, view);
  if (d.technique.unavailable) return 1;
  for (int i = 0; i < times; ++i) draw(d, c, view);
  return 0;
}

// Instructions that Valgrind counts while a program draws a case so often; negative where it cannot.
double instructions(const std::string& program, std::size_t number, int times, const std::string& size) {
  const std::string command = "valgrind --tool=cachegrind --cache-sim=no --cachegrind-out-file=/dev/null '" + program +
                              "' --draw " + size + " " + std::to_string(number) + " " + std::to_string(times) + " 2>&1";
  FILE* told = popen(command.c_str(), "r");
  double count = -1;
  for (char line[512]; told && std::fgets(line, sizeof line, told);) {
    const char* at = std::strstr(line, "I   refs:");
    if (!at) at = std::strstr(line, "I refs:");
    if (!at) continue;
    std::string digits;
    for (; *at; ++at)
      if (*at >= '0' && *at <= '9') digits += *at;
    count = std::atof(digits.c_str());
  }
  return told && pclose(told) == 0 ? count : -1;
}

// The difference of five pictures and one, so that what a program does before it draws is not in it. Software only: a
// driver's own compiler takes another number of instructions in every run.
int count_instructions(const std::string& all, const std::string& only, const std::string& size) {
  std::printf("plain scene, %s, instructions a picture\n", size.c_str());
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (std::strcmp(cases[k].technique, "software") != 0) continue;
    double picture[2];
    for (int i = 0; i < 2; ++i) {
      const std::string& program = i == 0 ? all : only;
      const double one = instructions(program, k, 1, size), five = instructions(program, k, 5, size);
      if (one < 0 || five < 0) {
        std::printf("  %-34s not counted: is Valgrind installed?\n", cases[k].name);
        return 1;
      }
      picture[i] = (five - one) / 4;
    }
    std::printf("  %-34s %12.0f  %.4f times the plain build\n", cases[k].name, picture[0], picture[0] / picture[1]);
    std::fflush(stdout);
  }
  return 0;
}

// A process that works.
class Worker {
 public:
  Worker(const std::string& program, const std::string& size) {
    int to[2], from[2];
    // Closed in the program that is started: the other worker would keep it from ever reading an end.
    if (pipe2(to, O_CLOEXEC) != 0 || pipe2(from, O_CLOEXEC) != 0) std::exit(1);
    if (fork() == 0) {
      dup2(to[0], 0), dup2(from[1], 1);
      execl(program.c_str(), program.c_str(), "--work", size.c_str(), nullptr);
      _exit(127);
    }
    close(to[0]), close(from[1]);
    in_ = fdopen(to[1], "w"), out_ = fdopen(from[0], "r");
  }
  double ms(std::size_t number) {
    std::fprintf(in_, "%zu\n", number);
    std::fflush(in_);
    double v = -1;
    if (std::fscanf(out_, "%lf", &v) != 1) std::exit(1);
    return v;
  }
  void end() { std::fclose(in_), std::fclose(out_), wait(nullptr); }

 private:
  FILE *in_, *out_;
};

}  // namespace

int main(int argc, char** argv) {
  int pairs = 21;
  bool count = false;
  std::string size = "512x512";
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--instructions") == 0) count = true;
    if (i + 1 == argc) break;
    if (std::strcmp(argv[i], "--pairs") == 0) pairs = std::max(1, std::atoi(argv[i + 1]));
    if (std::strcmp(argv[i], "--size") == 0) size = argv[i + 1];
    if (std::strcmp(argv[i], "--work") == 0) {
      View view;
      std::sscanf(argv[i + 1], "%dx%d", &view.width, &view.height);
      return work(view);
    }
    if (std::strcmp(argv[i], "--draw") == 0 && i + 3 < argc) {
      View view;
      std::sscanf(argv[i + 1], "%dx%d", &view.width, &view.height);
      return draw_only(cases.at(std::size_t(std::atoi(argv[i + 2]))), std::atoi(argv[i + 3]), view);
    }
  }
  setenv("LP_NUM_THREADS", "0", 1);  // llvmpipe draws on the thread that calls it
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path plain = self.parent_path() / "bench_plain_only";
  if (count) return count_instructions(self, plain, size);
  std::printf("plain scene, %s, CPU time a picture, %d pairs of %d pictures\n", size.c_str(), pairs, draws);
  for (std::size_t k = 0; k < cases.size(); ++k) {
    std::vector<double> ratios, ms;
    for (int i = 0; i < pairs; ++i) {
      // Of their own: where in memory a process finds its pages decides more than what is to be measured.
      Worker all(self, size), only(plain, size);
      double a = 0, b = 0;
      if (i % 2 == 0)
        a = all.ms(k), b = only.ms(k);
      else
        b = only.ms(k), a = all.ms(k);
      all.end(), only.end();
      if (a < 0 || b < 0) break;
      ratios.push_back(a / b), ms.push_back(a);
    }
    if (ratios.empty()) continue;
    std::sort(ratios.begin(), ratios.end()), std::sort(ms.begin(), ms.end());
    const auto at = [&](double part) { return ratios[std::size_t(part * double(ratios.size() - 1))]; };
    std::printf("  %-34s %8.3f ms  %.4f times the plain build (quartiles %.4f %.4f)\n", cases[k].name,
                ms[ms.size() / 2], at(0.5), at(0.25), at(0.75));
    std::fflush(stdout);
  }
}
