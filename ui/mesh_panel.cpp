// What the scene's meshes are like.
#include <string>

#include "ui/app.h"
#include "ui/layout.h"
#include "ui/lines.h"

namespace cg {

void draw_mesh_panel(App& app) {
  const Language l = app.language();
  const Palette& p = app.look.palette;
  // The picture's objects have the meshes that were really drawn; the scene's may still be older.
  const std::vector<Object>& objects = app.drawings[0] ? app.drawings[0]->scene.objects : app.scene.objects;
  for (const Object& o : objects) {
    ImGui::PushFont(app.look.fonts.bold);
    write(app, o.name.empty() ? std::string_view(o.model) : std::string_view(o.name));
    ImGui::PopFont();
    if (!o.mesh) continue;
    const Mesh& m = *o.mesh;
    const auto count = [&](const Words& w, std::size_t n, ImU32 colour) {
      pair_line(app, w.in(l), std::to_string(n), colour);
    };
    count({"Faces", "面"}, m.data().face_count(), p.text);
    count({"Triangles", "三角形"}, m.triangles().size(), p.text);
    count({"Positions", "頂点位置"}, m.data().positions.size(), p.text);
    count({"Normals in the file", "ファイルの法線"}, m.data().normals.size(), m.has_normals() ? p.text : p.dim);
    count({"uv in the file", "ファイルの uv"}, m.data().uvs.size(), m.has_uvs() ? p.text : p.dim);
    const MeshReport& r = m.report();
    count({"Degenerate faces", "退化した面"}, r.degenerate_faces, r.degenerate_faces ? p.error : p.dim);
    count({"Repeated corners", "重複した角"}, r.repeated_corners, r.repeated_corners ? p.error : p.dim);
    count({"Zero normals", "長さ 0 の法線"}, r.bad_normals, r.bad_normals ? p.error : p.dim);
    ImGui::Dummy({1, app.look.px(10)});
  }
}

}  // namespace cg
