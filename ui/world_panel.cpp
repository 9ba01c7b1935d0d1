// The scene from outside: the camera, the lights and the mesh.
#include <algorithm>
#include <array>

#include "params/numbers.h"
#include "ui/app.h"
#include "ui/layout.h"
#include "ui/lines.h"
#include "ui/number.h"
#include "ui/widgets.h"
#include "ui/world_view.h"

namespace cg {

namespace {

std::string vector_text(const glm::dvec3& v) {
  const auto one = [](double x) { return number_text(x, 1, 5); };
  return one(v.x) + ", " + one(v.y) + ", " + one(v.z);
}

}  // namespace

void draw_world_panel(App& app) {
  if (!app.panes) return;  // without pictures there is no OpenGL to draw with
  if (!app.world) app.world = std::make_shared<WorldView>(app);
  const Language l = app.language();
  const Palette& p = app.look.palette;
  constexpr std::array<Name, 2> views{
      {{"world", {"World", "ワールド"}}, {"divided", {"After the division by w", "w で割った後"}}}};
  int view = app.settings.divided_by_w;
  if (choose(app, "view", views, view)) app.settings.divided_by_w = view == 1;
  ImGui::Dummy({1, app.look.px(2)});
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const bool divided = app.settings.divided_by_w;
  const float least = app.look.px(160), height = room.y - app.look.px(142);
  app.world->draw(app, {room.x, std::clamp(height, least, std::max(1.2f * room.x, least))}, divided);
  ImGui::Dummy({1, app.look.px(4)});
  const Camera& camera = app.scene.camera;
  pair_line(app, Words{"Eye", "視点"}.in(l), vector_text(camera.position), p.text);
  pair_line(app, Words{"Target", "注視点"}.in(l), vector_text(camera.target), p.text);
  pair_line(app, Words{"Near, far", "前方面・後方面"}.in(l),
            number_text(camera.near_plane, 0, 6) + ", " + number_text(camera.far_plane, 0, 6) + " m", p.text);
  constexpr Words in_cube{"Inside the cube from −1 to 1 is what the picture shows.",
                          "−1 から 1 の立方体の中が画像に写る。"};
  if (divided) return small_text(app, in_cube.in(l), p.dim);
  small_text(app,
             Words{"Drag to look from elsewhere; drag lights and camera. Double click: all of it.",
                   "ドラッグで見る向きを変える。光源とカメラもつかめる。ダブルクリックで全体。"}
                 .in(l),
             p.dim);
}

}  // namespace cg
