// Normals of any length, faces without area, faces that agree with no neighbour.
#include "measure/extreme_scenes.h"
#include "measure/extreme_tables.h"
#include "params/numbers.h"

namespace cg {

namespace {

using Positions = std::vector<glm::dvec3>;
using Polygons = std::vector<std::vector<std::uint32_t>>;

Change with_normals(double length) {
  return [length](Scene& s) { mesh_change(changed_mesh(*s.objects[0].mesh, 1, glm::dvec3(0), length))(s); };
}

Change with_normals_of_all_lengths() {
  return [](Scene& s) {
    MeshData data = s.objects[0].mesh->data();
    constexpr double lengths[] = {1, 1e-20, 1e20, 1e-30, 3e30};
    for (std::size_t i = 0; i < data.normals.size(); ++i) data.normals[i] *= lengths[i % 5];
    mesh_change(Mesh::make(std::move(data)))(s);
  };
}

// A square of one polygon, or of what is given instead.
Scene polygon_square() {
  Scene s = square_scene();
  mesh_change(mesh_of_faces({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2, 3}}))(s);
  return s;
}

Change faces(Positions positions, Polygons polygons) {
  return mesh_change(mesh_of_faces(std::move(positions), polygons));
}

PictureRow mesh_row(std::string id, const char* group, Words name, std::string value, Text right, Change change,
                    Change same) {
  PictureRow row{std::move(id), group, name, "objects.0.model", std::move(value), std::move(right)};
  row.change = std::move(change), row.same = std::move(same);
  return row;
}

// All of `polygons`, lit by their face's normal, beside each as an object of its own.
PictureRow as_single_faces(std::string id, Words name, std::string value, const Positions& positions,
                           const Polygons& polygons) {
  PictureRow row = mesh_row(std::move(id), "meshes", name, std::move(value),
                            Words{"Every face is drawn, as if each were an object of its own.",
                                  "どの面も、それぞれ別の物体であるかのように描かれる。"},
                            faces(positions, polygons), [=](Scene& s) {
                              const Object one = s.objects[0];
                              s.objects.assign(polygons.size(), one);
                              for (std::size_t i = 0; i < polygons.size(); ++i)
                                s.objects[i].mesh = mesh_of_faces(positions, {polygons[i]});
                            });
  row.start = [positions, polygons] {
    Scene s = sphere_scene();
    faces(positions, polygons)(s);
    s.shading.normals = NormalRule::face, s.shading.two_sided = true, s.camera.position = {0.5, 1.5, 3.5};
    return s;
  };
  return row;
}

void add_odd_faces(ExtremeTable& all) {
  const Positions corners{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0.3, -1 + 1e-30, 0}, {0, -1, 0}};
  const auto add = [&](std::string id, Words name, std::string value, Polygons polygons) {
    PictureRow row = mesh_row("mesh-" + std::move(id), "meshes", name, std::move(value),
                              Words{"As the square alone: a face without area is kept, counted and not drawn.",
                                    "正方形だけのときと同じ。面積のない面は残して数え、描かない。"},
                              faces(corners, std::move(polygons)), nothing_changed());
    row.start = polygon_square;
    all.push_back(picture_case(std::move(row)));
  };
  add("sliver", {"A sliver, and a face without area", "極端に細い面と、面積のない面"}, "1e-30",
      {{0, 1, 2, 3}, {0, 1, 4}, {0, 5, 1}});
  add("corner-twice", {"A corner named twice in a row", "同じ頂点が続けて現れる面"}, "f 1 1 2 2 2 3 4 1",
      {{0, 0, 1, 1, 1, 2, 3, 0}});
  add("vertex-thrice", {"A face of one vertex", "一つの頂点だけの面"}, "f 3 3 3", {{0, 1, 2, 3}, {2, 2, 2}});
}

void add_concave(ExtremeTable& all) {
  // Under a directional light, as a face is lit at its last corner.
  const Positions dart{{0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {0.6, 0, 0}};
  const Polygons quads{{0, 1, 2, 3}, {1, 2, 3, 0}, {2, 3, 0, 1}, {3, 0, 1, 2}};
  for (std::size_t i = 0; i < quads.size(); ++i) {
    PictureRow row = mesh_row("mesh-concave-" + std::to_string(i), "meshes",
                              {"A concave quadrilateral", "凹んだ四角形"}, "from corner " + std::to_string(i),
                              Words{"Cut at the reflex corner, wherever the face begins: nothing outside is covered.",
                                    "どの頂点から始めても、へこんだ角で切る。外側は覆わない。"},
                              faces(dart, {quads[i]}), faces(dart, {{0, 1, 3}, {3, 1, 2}}));
    row.start = [] {
      Scene s = polygon_square();
      light_kind(LightKind::directional)(s);
      return s;
    };
    all.push_back(picture_case(std::move(row)));
  }
}

void add_mirrors(ExtremeTable& all) {
  const auto add = [&](std::string id, Words name, std::string value, Change change, std::function<Scene()> start) {
    PictureRow row{"scale-" + std::move(id),
                   "normals",
                   name,
                   "objects.0.transform.scale",
                   std::move(value),
                   Words{"Normals follow M^-T; a mirror turns the winding, not the normal.",
                         "法線は M^-T で変換する。鏡像では頂点の回り順だけが逆になる。"}};
    row.start = std::move(start), row.change = std::move(change);
    all.push_back(picture_case(std::move(row)));
  };
  const auto scale = [](const glm::dvec3& v) { return [v](Scene& s) { s.objects[0].transform.scale = v; }; };
  add("stretched", {"Scaled in one direction", "一方向だけの拡大縮小"}, "1, 1e-3, 1", scale({1, 1e-3, 1}),
      sphere_scene);
  add("mirrored", {"A mirror, scaled unevenly", "不均等な鏡像"}, "-1, 1.5, 0.5", scale({-1, 1.5, 0.5}), sphere_scene);
  add("mirrored-twice", {"Mirrored twice", "二回の鏡像"}, "-1, -1, 1", scale({-1, -1, 1}), sphere_scene);
  add("nothing", {"Scaled to nothing", "大きさ 0"}, "0, 0, 0", scale({0, 0, 0}), sphere_scene);
  all.back().right = Words{"Nothing is left to see.", "何も見えない。"};
  all.back().scene->check = nothing_covered();
  for (const double x : {1.0, -1.0})
    add(
        x > 0 ? "two-sides" : "mirrored-two-sides", {"Both sides lit, seen from behind", "両面を照らし、裏から見る"},
        x > 0 ? "1, 1, 1" : "-1, 1, 1",
        [x](Scene& s) {
          s.objects[0].transform.scale = {x, 1, 1}, s.objects[0].transform.rotate = {0, 160, 0};
          s.shading.two_sided = true;
        },
        polygon_square);
}

}  // namespace

void add_normal_extremes(ExtremeTable& all) {
  const Words name{"The length of a file's normals", "ファイルの法線の長さ"};
  const Text right =
      Words{"GL_NORMALIZE makes them unit: as the ordinary sphere.", "GL_NORMALIZE で単位長になり、通常の球と同じ。"};
  for (const double length : {1e-30, 1e-20, 1e20, 1e30})
    all.push_back(picture_case(mesh_row("normals-" + number_text(length), "normals", name, number_text(length), right,
                                        with_normals(length), nothing_changed())));
  all.push_back(picture_case(mesh_row("normals-mixed", "normals", name, "1e-30 … 3e30", right,
                                      with_normals_of_all_lengths(), nothing_changed())));
  PictureRow none = mesh_row("normals-0", "normals", name, "0",
                             Words{"No direction: no diffuse light and no highlight, and the plan counts them.",
                                   "向きがないので拡散光もハイライトもなく、処理計画が数を告げる。"},
                             with_normals(0), unlit);
  none.note = "no normal";
  none.variants = {{ShadingMode::gouraud, true}, {ShadingMode::phong, true}, {ShadingMode::gouraud, false}};
  all.push_back(picture_case(std::move(none)));
  add_mirrors(all);
}

void add_mesh_extremes(ExtremeTable& all) {
  add_odd_faces(all);
  add_concave(all);
  const Positions fan{{0, -1, 0}, {0, 1, 0}, {1, 0, 0.3}, {-1, 0, 0.3}, {0, 0, 1}};
  all.push_back(picture_case(as_single_faces("mesh-edge-of-three", {"An edge of three faces", "三つの面が接する辺"},
                                             "non-manifold", fan, {{0, 2, 1}, {0, 1, 3}, {0, 4, 1}})));
  all.push_back(picture_case(as_single_faces("mesh-face-twice", {"A face that is there twice", "二重の面"}, "duplicate",
                                             fan, {{0, 2, 1}, {0, 2, 1}, {0, 1, 3}})));
  all.push_back(
      picture_case(as_single_faces("mesh-flipped", {"Neighbours wound against one another", "向きの食い違う隣の面"},
                                   "flipped", fan, {{0, 2, 1}, {0, 3, 1}})));
}

}  // namespace cg
