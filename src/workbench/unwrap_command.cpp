// shadebench unwrap: a model cut into charts and laid flat, what that is worth in numbers, and the files to paint over.
#include "workbench/unwrap_command.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "image/image_file.h"
#include "mapping/layout_drawing.h"
#include "mapping/mesh_union.h"
#include "mapping/unwrap.h"
#include "params/file.h"
#include "params/numbers.h"
#include "params/slots.h"
#include "scene/write_obj.h"
#include "workbench/command_parts.h"
#include "workbench/open.h"

namespace cg {

namespace {

constexpr int largest_layout = 8192;

struct Measured {
  LayoutFigures figures;
  std::uint32_t charts;
  std::size_t seams;
  double seconds;
  std::vector<Text> notes;
};

Unwrapping options_of(const Arguments& a) {
  Unwrapping out;
  for (const std::string& set : a.set) {
    const std::size_t equals = set.find('=');
    if (equals == set.npos)
      throw bad_option("--set", set, {"give NAME=VALUE: margin=8", "margin=8 のように 名前=値 で指定すること"});
    const Slots all = slots(out);
    assign_text(find_slot(all, set.substr(0, equals)), std::string_view(set).substr(equals + 1));
  }
  return out;
}

int layout_size(const Arguments& a) {
  if (a.size.empty()) return 1024;
  const auto size = whole_number(a.size, 16, largest_layout);
  if (!size)
    throw bad_option("--size", a.size,
                     {"give the pixels of a side, from 16 to 8192", "一辺の画素数を 16 から 8192 で指定すること"});
  return *size;
}

// What is odd about the mesh, but no mistake.
std::vector<Text> notes_of(const MeshHandle& mesh) {
  std::vector<Text> out;
  if (const std::size_t n = UnwrapSurface(mesh, "").turned_edges())
    out.emplace_back("the faces at " + std::to_string(n) + " edges look opposite ways: cut there",
                     "隣の面と向きが逆の辺が " + std::to_string(n) + " 本ある。そこで切った");
  if (const std::size_t n = mesh->report().degenerate_faces)
    out.emplace_back(std::to_string(n) + " faces have no area: they lie at their neighbours' corners",
                     "面積のない面が " + std::to_string(n) + " 枚ある。隣の面の角に置いた");
  return out;
}

void save(const Arguments& a, const Scene& scene, std::span<const MeshHandle> meshes, const UvLayout& layout) {
  const std::string extension = std::filesystem::path(a.output).extension().string();
  if (extension == ".svg") return save_file(a.output, layout_svg(layout, layout_size(a)));
  if (extension == ".png") return write_image(a.output, layout_picture(layout, layout_size(a)));
  const std::vector<MeshData> parted = parted_uv(meshes, layout.uv);
  std::vector<ObjPart> parts;
  for (std::size_t i = 0; i < parted.size(); ++i) parts.push_back({scene.objects[i].name, {}, &parted[i]});
  save_file(a.output, obj_text(parts, "Shadebench: " + a.scene + ", unwrapped"));
}

void check_output(const Arguments& a) {
  const std::string extension = std::filesystem::path(a.output).extension().string();
  if (!a.output.empty() && extension != ".obj" && extension != ".svg" && extension != ".png")
    throw bad_option("--output", a.output,
                     {"the name ends in .obj (the model with uv), .svg or .png (the layout)",
                      "名前の終わりは .obj（uv 付きのモデル）、.svg か .png（展開図）のどれか"});
}

Tree json_of(const Arguments& a, const Unwrapping& options, const Measured& m) {
  const DistortionSum& d = m.figures.distortion;
  Tree::List notes;
  for (const Text& note : m.notes) notes.emplace_back(note.en);
  return Tree::Members{{"model", a.scene},
                       {"method", names_of<UnwrapMethod>[std::size_t(options.method)].id},
                       {"triangles", d.triangles},
                       {"charts", std::size_t(m.charts)},
                       {"seam_edges", m.seams},
                       {"flipped", d.flipped},
                       {"overlapping_pixels", m.figures.overlapping_pixels},
                       {"mean_quasi_conformal", d.mean_quasi_conformal()},
                       {"worst_quasi_conformal", d.worst_quasi_conformal},
                       {"area_distortion", d.area_distortion()},
                       {"share_used", m.figures.share_used()},
                       {"seconds", m.seconds},
                       {"notes", notes}};
}

std::string text_of(const Unwrapping& options, const Measured& m, Language l) {
  const DistortionSum& d = m.figures.distortion;
  const auto rounded = [](double v, double steps) { return number_text(std::round(v * steps) / steps); };
  std::string out;
  const auto line = [&](Words label, const std::string& value) {
    out += std::string(label.in(l)) + (l == Language::japanese ? "：" : ": ") + value + "\n";
  };
  line({"triangles", "三角形"}, std::to_string(d.triangles));
  line({"flattened by", "展開の方法"}, std::string(names_of<UnwrapMethod>[std::size_t(options.method)].label.in(l)));
  line({"charts", "展開図の部分の数"}, std::to_string(m.charts));
  line({"seam edges", "縫い目の辺"}, std::to_string(m.seams));
  line({"flipped triangles", "裏返った三角形"}, std::to_string(d.flipped));
  line({"overlapping pixels of 2048 x 2048", "重なる画素（2048 x 2048 中）"},
       std::to_string(m.figures.overlapping_pixels));
  line({"angle distortion, mean", "角度の歪み、平均"}, rounded(d.mean_quasi_conformal(), 1e4));
  line({"angle distortion, worst", "角度の歪み、最大"}, rounded(d.worst_quasi_conformal, 1e3));
  line({"area distortion", "面積の歪み"}, rounded(d.area_distortion(), 1e4));
  line({"share of the texture used", "テクスチャの使用率"}, rounded(100 * m.figures.share_used(), 10) + " %");
  line({"time", "時間"}, rounded(m.seconds, 1e3) + " s");
  return out;
}

}  // namespace

int run_unwrap(const Arguments& a, std::span<const Technique>, Language language) {
  check_output(a);
  layout_size(a);
  const Unwrapping options = options_of(a);
  Arguments model = a;
  model.set.clear();
  const Scene scene = scene_for(model, language);
  std::vector<MeshHandle> meshes;
  for (const Object& object : scene.objects) meshes.push_back(object.mesh);
  const MeshHandle mesh = joined_meshes(meshes);
  const auto begin = std::chrono::steady_clock::now();
  const UvLayout layout = unwrap(mesh, options, a.scene);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const Measured measured{figures_of(layout), layout.charts, seams_of(layout).size(), seconds, notes_of(mesh)};
  if (!a.output.empty()) save(a, scene, meshes, layout);
  print(a.json ? to_json(json_of(a, options, measured)) + "\n" : text_of(options, measured, language));
  for (const Text& note : measured.notes)
    std::fprintf(stderr, "shadebench: %s: %s\n", a.scene.c_str(), note.in(language).c_str());
  return 0;
}

}  // namespace cg
