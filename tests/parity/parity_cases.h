// The scenes that software and OpenGL are compared on, and what parity means: at 512x512 the coverage differs in at
// most 5 pixels, no channel of a covered pixel by more than 2/255, and at least 99.9 % of them by at most 1/255.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "image/difference.h"
#include "scene/technique.h"

namespace cg::parity {

inline constexpr int size = 512;

// A model fitted into the unit ball.
struct Model {
  std::string name;
  std::vector<Object> objects;
};

// Every shape, every models/*.obj, and the meshes of the folder beside the sources, where there is one.
std::vector<Model> all_models();
Model shape_model(const std::string& id);
Model file_model(const std::filesystem::path& file);

// What makes a picture, but for the model.
struct Setting {
  int camera;  // 0 in front of it; 1 close, cut by the picture's edges; 2 orthographic, mirrored, both sides lit
  LightKind light;
  ShadingMode mode;
  Reflection reflection;
};
std::vector<Setting> all_settings();
std::string name_of(const Setting& setting);

Scene scene_of(const Model& model, const Setting& setting);

struct Result {
  std::string what;  // model, setting, technique and precision
  std::size_t coverage_mismatch = 0, covered = 0, over_1_255 = 0;
  double max_error = 0;          // 0..1
  std::size_t on_cone_edge = 0;  // pixels left out: see Comparison
  std::size_t over_3_255 = 0;
  bool passes() const {
    return coverage_mismatch <= 5 && max_error <= 2.0 / 255 + 1e-6 && over_1_255 * 1000 <= covered;
  }
};

// Draws a scene in each technique. A spot's cone has a hard edge: a point or vertex that lies on it to within float's
// rounding is lit in one technique and dark in the other, and both are right. So pixels whose colour changes when
// the cut-off changes by a ten-thousandth of a degree are counted and left out.
class Comparison {
 public:
  Comparison();  // throws InputError where there is no OpenGL

  // Each technique that can draw the scene against the software in both precisions. Where `pictures` is not empty,
  // a failure leaves its difference there.
  std::vector<Result> compare(const Scene& scene, const std::string& what, const std::filesystem::path& pictures = {});

 private:
  Frame draw(const Technique& technique, const Scene& scene) const;
  std::vector<std::size_t> cone_edge(const Scene& scene) const;
  Technique software_;
  std::vector<Technique> gl_;
};

}  // namespace cg::parity
