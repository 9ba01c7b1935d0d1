// Sizes and places that leave float, cameras that look nowhere, pictures without pixels.
#include "measure/extreme_scenes.h"
#include "measure/extreme_tables.h"
#include "params/numbers.h"

namespace cg {

namespace {

PictureRow row_of(std::string id, const char* group, Words name, std::string parameter, std::string value, Text right,
                  Change change, Change same = {}) {
  PictureRow row{std::move(id), group, name, std::move(parameter), std::move(value), std::move(right)};
  row.change = std::move(change), row.same = std::move(same);
  return row;
}

// Camera and clipping planes of a scene `size` times as large.
void see(Scene& s, double size) {
  s.lights[0].kind = LightKind::directional;
  s.camera.position *= size, s.camera.near_plane *= size, s.camera.far_plane *= size;
}

void add_offsets(ExtremeTable& all) {
  for (const double offset : {1e6, 1e9}) {
    const glm::dvec3 far = glm::dvec3(1, -2, 3) * offset;
    const auto moved = [far](Scene& s) {
      s.camera.position += far, s.camera.target += far, s.lights[0].position += far;
    };
    const Text right = Words{"As at the origin: what is large is subtracted in double, before float.",
                             "原点にあるときと同じ。大きな値は float にする前に double で引く。"};
    const Words name{"Far from the origin", "原点から遠い場所"};
    all.push_back(picture_case(
        row_of("place-vertices-" + number_text(offset), "places", name, "OBJ file, v", number_text(offset), right,
               both(moved, [far](Scene& s) { mesh_change(changed_mesh(*s.objects[0].mesh, 1, far))(s); }),
               nothing_changed())));
    all.push_back(picture_case(row_of(
        "place-moved-" + number_text(offset), "places", name, "objects.0.transform.translate", number_text(offset),
        right, both(moved, [far](Scene& s) { s.objects[0].transform.translate = far; }), nothing_changed())));
  }
}

void floor_under_the_eye(Scene& s) {
  s.objects[0].transform.rotate = {0, 0, 0}, s.objects[0].transform.scale = glm::dvec3(70);
  s.camera.position = {0, 1, 0}, s.camera.target = {0, 0.8, -1};
}

ExtremeError all_covered(const ExtremePicture& p) {
  std::size_t open = 0;
  for (const std::uint8_t c : p.frame.covered.pixels()) open += c == 0;
  const std::string n = std::to_string(open);
  return {open == 0 && p.frame.covered.size() > 0 ? 0.0 : 1.0,
          {n + " pixels show the background", n + " 画素に背景が見える"}};
}

void add_degenerate_cameras(ExtremeTable& all) {
  const auto at_3 = [](Scene& s) { s.camera.position = {0, 0, 3}; };
  all.push_back(picture_case(row_of(
      "camera-eye-at-target", "cameras", {"Eye and target in one place", "視点と注視点が同じ"}, "camera.target",
      "camera.position", Words{"It looks along -z, instead of nowhere.", "向きがないので -z を向く。"},
      [](Scene& s) {
        s.camera.position = s.camera.target = {0, 0, 3};
      },
      [](Scene& s) {
        s.camera.position = {0, 0, 3}, s.camera.target = {0, 0, 2};
      })));
  for (const double up : {1.0, 0.0}) {
    const glm::dvec3 given{0, 0, up};
    all.push_back(picture_case(row_of(
        up == 0 ? "camera-no-up" : "camera-up-along-view", "cameras", {"An up that is none", "上方向が定まらない"},
        "camera.up", up == 0 ? "0, 0, 0" : "along the view",
        Words{"The axis least parallel to the view is taken: here y.", "視線から最も離れた軸を使う。ここでは y 軸。"},
        both(at_3, [given](Scene& s) { s.camera.up = given; }), at_3)));
  }
}

void add_planes(ExtremeTable& all) {
  for (const double near_plane : {1e-4, 2.8}) {
    const std::string value = number_text(near_plane);
    all.push_back(
        picture_case(row_of("camera-near-" + value, "cameras", {"The near plane", "前方クリップ面"}, "camera.near",
                            value, as_the_reference(), [near_plane](Scene& s) { s.camera.near_plane = near_plane; })));
  }
  // 1 - 2 near/z is 1 in float.
  PictureRow nearest = row_of(
      "camera-near-1e-20", "cameras", {"A near plane at the eye", "視点にある前方クリップ面"}, "camera.near", "1e-20",
      Words{"Every depth rounds to 1, the far plane's: nothing passes the depth test, as in OpenGL.",
            "奥行きがすべて 1（後方クリップ面）に丸められ、OpenGL と同じく何も描かれない。"},
      [](Scene& s) { s.camera.near_plane = 1e-20; });
  nearest.check = nothing_covered();
  all.push_back(picture_case(std::move(nearest)));
  for (const double near_plane : {100.0, 1e20}) {
    PictureRow row = row_of("camera-near-" + number_text(near_plane), "cameras",
                            {"A near plane beyond all things", "すべてより遠い前方クリップ面"}, "camera.near",
                            number_text(near_plane), Words{"Nothing is left to see.", "何も見えない。"},
                            [near_plane](Scene& s) { s.camera.near_plane = near_plane; });
    row.check = nothing_covered();
    all.push_back(picture_case(std::move(row)));
  }
  all.push_back(picture_case(row_of("camera-far-before-near", "cameras",
                                    {"The far plane before the near one", "前方より近い後方クリップ面"},
                                    "camera.near, far", "100, 0.1",
                                    Words{"A thin slice behind the near plane is left, and the matrix stays finite.",
                                          "前方クリップ面のすぐ後ろだけが残り、行列は有限のまま。"},
                                    [](Scene& s) { s.camera.near_plane = 100, s.camera.far_plane = 0.1; })));
  all.back().scene->check = nothing_covered();
}

}  // namespace

void add_place_extremes(ExtremeTable& all) {
  const Text right = Words{"As the scene of size 1: it is brought to size 1 in double, before float.",
                           "大きさ 1 のときと同じ。float にする前に double で大きさをそろえる。"};
  const Change parallel = light_kind(LightKind::directional);
  for (const double size : {1e-20, 1e-6, 1e6, 1e20}) {
    const std::string value = number_text(size);
    const auto seen = [size](Scene& s) { see(s, size); };
    all.push_back(picture_case(
        row_of("size-vertices-" + value, "places", {"Vertices of extreme size", "極端な大きさの頂点座標"},
               "OBJ file, v", value, right,
               both(seen, [size](Scene& s) { mesh_change(changed_mesh(*s.objects[0].mesh, size, glm::dvec3(0)))(s); }),
               parallel)));
    all.push_back(picture_case(
        row_of("size-scaled-" + value, "places", {"An object scaled to extreme size", "極端な拡大縮小"},
               "objects.0.transform.scale", value, right,
               both(seen, [size](Scene& s) { s.objects[0].transform.scale = glm::dvec3(size); }), parallel)));
  }
  add_offsets(all);
}

void add_camera_extremes(ExtremeTable& all) {
  PictureRow floor =
      row_of("camera-floor", "cameras", {"A floor under and behind the eye", "視点の下から後ろまで続く床"},
             "objects.0.transform.scale", "50",
             Words{"Clipped in homogeneous space, before the division by w ≤ 0.",
                   "w ≤ 0 で割る前に、同次座標でクリップする。"},
             floor_under_the_eye);
  floor.start = square_scene;
  all.push_back(picture_case(std::move(floor)));
  all.push_back(picture_case(row_of("camera-inside", "cameras", {"The eye inside the object", "物体の中の視点"},
                                    "camera.position", "0, 0, 0.1", as_the_reference(), [](Scene& s) {
                                      s.camera.position = {0, 0, 0.1}, s.shading.two_sided = true;
                                    })));
  all.back().scene->check = both_checks(all.back().scene->check, all_covered);
  add_degenerate_cameras(all);
  add_planes(all);
  for (const double fov : {1.0, 170.0})
    all.push_back(picture_case(row_of("camera-fov-" + number_text(fov), "cameras", {"The field of view", "画角"},
                                      "camera.fov", number_text(fov) + "°", as_the_reference(), [fov](Scene& s) {
                                        s.camera.fov = fov, s.camera.position = {0, 0, 1.2};
                                      })));
  for (const double height : {1e-20, 1e20})
    all.push_back(picture_case(row_of("camera-height-" + number_text(height), "cameras",
                                      {"The height of an orthographic view", "平行投影の視野の高さ"}, "camera.height",
                                      number_text(height), as_the_reference(), [height](Scene& s) {
                                        s.camera.projection = Projection::orthographic, s.camera.height = height;
                                      })));
  all.back().right = Words{"All is smaller than a pixel: nothing is seen.", "すべてが画素より小さく、何も見えない。"};
  all.back().scene->check = nothing_covered();
}

void add_picture_extremes(ExtremeTable& all) {
  for (const auto& [w, h] : {std::pair(0, 0), {0, 5}, {5, 0}, {1, 1}, {64, 1}, {1, 64}}) {
    const std::string size = std::to_string(w) + "x" + std::to_string(h);
    PictureRow row =
        row_of("picture-" + size, "pictures", {"The picture's size", "画像の大きさ"}, "--size", size,
               w * h == 0 ? Text(Words{"An empty picture, and no error.", "空の画像。エラーにはならない。"})
                          : as_the_reference(),
               [](Scene& s) {
                 s.camera.position = {0, 0, 0.1}, s.shading.two_sided = true;
               });
    row.variants = {{ShadingMode::gouraud}};
    if (w * h == 0)
      row.check = [w = w, h = h](const ExtremePicture& p) -> ExtremeError {
        const ColourImage& c = p.frame.colour;
        const std::string found = std::to_string(c.width()) + "x" + std::to_string(c.height());
        return {c.width() == w && c.height() == h ? 0.0 : 1.0, {found, found}};
      };
    ExtremeCase c = picture_case(std::move(row));
    c.scene->width = w, c.scene->height = h;
    all.push_back(std::move(c));
  }
  PictureRow huge = row_of(
      "picture-20000x20000", "pictures", {"A picture larger than any memory for it", "大きすぎる画像"}, "--size",
      "20000x20000", Words{"An error that says what size is possible.", "可能な大きさを告げるエラーになる。"}, {});
  huge.variants = {{ShadingMode::gouraud}};
  ExtremeCase c = picture_case(std::move(huge));
  c.scene->width = c.scene->height = 20000;
  c.scene->refusal = "20000x20000";
  all.push_back(std::move(c));
}

}  // namespace cg
