// bench_unwrap [--method M] [--svg FOLDER] MODEL...: a table of what the unwrap of each model is worth and what it
// costs. A shape's name or a model file; all parts of a file are one mesh.
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>

#include "mapping/layout_drawing.h"
#include "mapping/mesh_union.h"
#include "mapping/unwrap.h"
#include "params/file.h"
#include "params/input_error.h"
#include "scene/cpu_clock.h"
#include "scene/model_file.h"
#include "scene/shape.h"

namespace {

using namespace cg;

MeshHandle mesh_of(const std::string& name) {
  if (const Shape* shape = find_shape(name)) return make_shape(*shape);
  std::vector<MeshHandle> meshes;
  for (const ModelPart& part : read_model(name).parts) meshes.push_back(part.mesh);
  return joined_meshes(meshes);
}

void measure(const std::string& name, const Unwrapping& options, const std::string& svg_folder) {
  const std::string label = std::filesystem::path(name).stem().string();
  try {
    const MeshHandle mesh = mesh_of(name);
    CpuClock cpu;
    const auto begin = std::chrono::steady_clock::now();
    const UvLayout layout = unwrap(mesh, options, label);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const double cpu_s = cpu.lap_ms() / 1e3;
    const LayoutFigures f = figures_of(layout);
    if (!svg_folder.empty()) save_file(svg_folder + "/" + label + ".svg", layout_svg(layout, 1024));
    std::printf("%-22s %7zu %6u %7zu %8zu %7.4f %9.3f %7.4f %5.1f%% %7.2f %7.2f\n", label.c_str(),
                mesh->triangles().size(), layout.charts, f.distortion.flipped, f.overlapping_pixels,
                f.distortion.mean_quasi_conformal(), f.distortion.worst_quasi_conformal, f.distortion.area_distortion(),
                100 * f.share_used(), seconds, cpu_s);
  } catch (const InputError& e) {
    std::printf("%-22s %s\n", label.c_str(), e.message(Language::english).c_str());
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  Unwrapping options;
  std::string svg_folder;
  std::printf("%-22s %7s %6s %7s %8s %7s %9s %7s %6s %7s %7s\n", "model", "tri", "charts", "flipped", "overlap",
              "qc mean", "qc worst", "area", "used", "s", "CPU s");
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--method") == 0 && i + 1 < argc) {
      const std::string id = argv[++i];
      for (std::size_t m = 0; m < names_of<UnwrapMethod>.size(); ++m)
        if (names_of<UnwrapMethod>[m].id == id) options.method = UnwrapMethod(m);
    } else if (std::strcmp(argv[i], "--svg") == 0 && i + 1 < argc) {
      svg_folder = argv[++i];
    } else {
      measure(argv[i], options, svg_folder);
    }
  }
  return 0;
}
