// The right side, opened when it is asked for: what each technique does for this scene, and what the mesh is like.
#include <string>

#include "ui/app.h"
#include "ui/formula.h"
#include "ui/layout.h"
#include "ui/widgets.h"

namespace cg {
namespace {

std::string bytes_text(std::size_t n) {
  const double d = double(n);
  char buffer[32];
  if (n < 1000) return std::to_string(n) + " B";
  const char* unit = n < 1000000 ? "kB" : n < 1000000000 ? "MB" : "GB";
  const double v = n < 1000000 ? d / 1e3 : n < 1000000000 ? d / 1e6 : d / 1e9;
  std::snprintf(buffer, sizeof buffer, v < 9.95 ? "%.1f %s" : "%.0f %s", v, unit);
  for (char* p = buffer; *p; ++p)
    if (*p == ',') *p = '.';
  return buffer;
}

// A line with a text to the left and a figure to the right.
void pair_line(App& app, std::string_view left, std::string_view right, ImU32 colour) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, baseline = at.y + look.px(19);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  set_text(draw, look.fonts.text, {at.x, baseline}, colour, noted(app, left));
  const float w = text_width(look.fonts.mono, noted(app, right));
  set_text(draw, look.fonts.mono, {at.x + room - w, baseline}, colour, right);
  ImGui::Dummy({room, look.px(22)});
}

void small_text(App& app, std::string_view text, ImU32 colour) {
  ImGui::PushFont(app.look.fonts.small);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::PushTextWrapPos(0);
  write(app, text);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void draw_plan(App& app, const Plan& plan) {
  const Language l = app.language();
  const Palette& p = app.look.palette;
  std::string_view name = plan.technique;
  for (const Technique& t : app.techniques)
    if (t.id == plan.technique) name = t.name.in(l);
  ImGui::PushFont(app.look.fonts.bold);
  write(app, name);
  ImGui::PopFont();
  for (const bool needed : {true, false}) {
    bool any = false;
    for (const Pass& pass : plan.passes) any = any || pass.needed == needed;
    if (!any) continue;
    heading(app, (needed ? Words{"Runs", "必要なもの"} : Words{"Left out", "省いたもの"}).in(l));
    for (const Pass& pass : plan.passes) {
      if (pass.needed != needed) continue;
      pair_line(app, pass.name.in(l), needed && pass.bytes > 0 ? bytes_text(pass.bytes) : "", needed ? p.text : p.dim);
      small_text(app, pass.reason.in(l), p.dim);
    }
  }
  for (const Text& note : plan.notes) small_text(app, note.in(l), p.text);
  ImGui::Dummy({1, app.look.px(14)});
}

void draw_mesh(App& app) {
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

}  // namespace

void draw_side_panel(App& app) {
  if (app.settings.side == Side::mesh) return draw_mesh(app);
  for (const Plan& plan : app.plans) draw_plan(app, plan);
  if (app.plans.empty())
    small_text(app,
               Words{"The plan comes with the first picture.", "計画は最初の絵とともに表示される。"}.in(app.language()),
               app.look.palette.dim);
}

}  // namespace cg
