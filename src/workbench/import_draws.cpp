// What a program that is read draws: GLUT's and GLU's shapes as shapes of the workbench, and meshes of its own.
#include <algorithm>
#include <cmath>

#include "scene/shape.h"
#include "scene/text_scanner.h"
#include "workbench/import_machine.h"

namespace cg {

namespace {

constexpr std::size_t most_draws = 1000;

MatrixCall translate(const glm::dvec3& v) { return {MatrixCall::translate, {v.x, v.y, v.z}, 0}; }
MatrixCall scale(double x, double y, double z) { return {MatrixCall::scale, {x, y, z}, 0}; }
MatrixCall rotate(double angle, const glm::dvec3& a) { return {MatrixCall::rotate, {angle, a.x, a.y, a.z}, 0}; }

// GLUT's teapot of size 1 is Newell's at half its size, lowered by 1.5 first (freeglut, fg_teapot.c). Ours was moved
// and scaled into the unit ball: by how much is read off the height, 3.15, and the knob, which is above the middle.
MatrixCalls teapot_fit(double size) {
  static const auto [radius, centre] = [] {
    const MeshHandle mesh = make_shape(*find_shape("teapot"));
    const double r = 3.15 / (mesh->high().y - mesh->low().y);
    const auto& p = mesh->data().positions;
    const auto knob = std::max_element(p.begin(), p.end(), [](auto& a, auto& b) { return a.y < b.y; });
    return std::pair(r, glm::dvec3(-knob->x * r, -mesh->low().y * r, 0));
  }();
  const double half = 0.5 * size, s = half * radius;
  const glm::dvec3 t = half * (centre - glm::dvec3(0, 1.5, 0));
  const auto rounded = [](double v) { return std::round(v * 1e6) / 1e6 + 0.0; };  // to a thousandth of a millimetre
  return {translate({rounded(t.x), rounded(t.y), rounded(t.z)}), scale(rounded(s), rounded(s), rounded(s))};
}

int level_within(std::string_view shape, double level) {
  const Shape& s = *find_shape(shape);
  return int(std::clamp(level, double(s.min_level), double(s.max_level)));
}

void teapot(GlDraw& draw, GlCallReader& call) {
  const auto size = call.number(0);
  if (!size) return;
  draw.model = "teapot", draw.fit = teapot_fit(*size);
}

void sphere(GlDraw& draw, GlCallReader& call, std::size_t first) {
  const auto r = call.number(first), slices = call.number(first + 1), stacks = call.number(first + 2);
  if (!r || !slices || !stacks) return;
  draw.model = "uv-sphere", draw.tessellation = level_within("uv-sphere", *slices);
  if (*r != 1) draw.fit = {scale(*r, *r, *r)};
  if (*stacks != std::max(2, draw.tessellation / 2) || *slices != draw.tessellation)
    call.complain(
        {"a sphere of {0} by {1} faces is here one of {2} by {3}", "{0}×{1} 面の球は、ここでは {2}×{3} 面になる"},
        {text_of(int(*slices)), text_of(int(*stacks)), text_of(draw.tessellation),
         text_of(std::max(2, draw.tessellation / 2))});
}

// The shape's ring has the radii 0.7 and 0.3.
void torus(GlDraw& draw, GlCallReader& call) {
  const auto inner = call.number(0), outer = call.number(1), sides = call.number(2), rings = call.number(3);
  if (!inner || !outer || !sides || !rings) return;
  draw.model = "torus", draw.tessellation = level_within("torus", *rings);
  const double size = *inner + *outer;
  if (size != 1) draw.fit = {scale(size, size, size)};
  if (std::abs(*inner - 0.3 * size) > 1e-6 * std::abs(size))
    call.complain({"the shape's torus is 0.3 : 0.7 thick: this one comes with the same outer size",
                   "ここのトーラスの太さは 0.3 : 0.7：外径だけを合わせる"});
}

void cube(GlDraw& draw, GlCallReader& call) {
  const auto size = call.number(0);
  if (!size) return;
  const double s = *size * std::sqrt(3.0) / 2;
  draw.model = "cube", draw.fit = {scale(s, s, s)};
}

// The shape stands on y = -0.8 with the radius 0.6; GLUT's lies along z from 0.
void cone(GlDraw& draw, GlCallReader& call) {
  const auto base = call.number(0), height = call.number(1), slices = call.number(2);
  if (!base || !height || !slices) return;
  draw.model = "cone", draw.tessellation = level_within("cone", *slices);
  draw.fit = {translate({0, 0, *height / 2}), rotate(90, {1, 0, 0}), scale(*base / 0.6, *height / 1.6, *base / 0.6)};
}

void cylinder(GlDraw& draw, GlCallReader& call, bool of_glu) {
  const auto base = call.number(of_glu), top = of_glu ? call.number(2) : base;
  const auto height = call.number(of_glu ? 3 : 1), slices = call.number(of_glu ? 4 : 2);
  if (!base || !top || !height || !slices) return;
  if (*base != *top)
    return call.refuse({"a cylinder with two radii is no shape here", "上下の半径が違う円柱はここの形にない"});
  if (of_glu) call.complain({"the cylinder comes with both ends closed", "円柱は両端を閉じた形になる"});
  draw.model = "cylinder", draw.tessellation = level_within("cylinder", *slices);
  draw.fit = {translate({0, 0, *height / 2}), rotate(90, {1, 0, 0}), scale(*base / 0.6, *height / 1.6, *base / 0.6)};
}

// A shape's name behind glutSolid or glutWire, drawn into `draw`; false where it is none that we have.
bool glut_shape(std::string_view name, GlDraw& draw, GlCallReader& call) {
  if (name == "Teapot")
    teapot(draw, call);
  else if (name == "Sphere")
    sphere(draw, call, 0);
  else if (name == "Torus")
    torus(draw, call);
  else if (name == "Cube")
    cube(draw, call);
  else if (name == "Cone")
    cone(draw, call);
  else if (name == "Cylinder")
    cylinder(draw, call, false);
  else
    return false;
  return true;
}

}  // namespace

// The parts of a mesh, one glBegin after the other, are one.
void add_mesh(GlState& s, long line) {
  GlDraw draw = begin_draw(s, line);
  const bool goes_on = !s.drawn.empty() && s.drawn.back().model.empty() && s.drawn.back().modelview == draw.modelview;
  if (!goes_on && s.drawn.size() < most_draws) s.drawn.push_back(std::move(draw));
}

bool read_draw_call(GlState& s, GlCallReader& call) {
  const std::string_view f = call.function;
  GlDraw draw = begin_draw(s, call.line);
  const bool solid = f.starts_with("glutSolid"), wire = f.starts_with("glutWire");
  if (f == "glBegin" && !call.arguments.empty() && call.arguments[0].number < 4) {
    call.complain({"lines and points are not drawn here", "線と点は描けない"});
    return true;
  }
  const bool begins = f == "glBegin" || f.starts_with("glDraw") || f == "glCallList";
  if (solid || wire) {
    if (wire) call.complain({"lines are not drawn here: the shape comes solid", "線では描けない：面のある形になる"});
    if (!glut_shape(f.substr(solid ? 9 : 8), draw, call))
      call.refuse({"the workbench has no such shape", "この形はここにない"});
  } else if (f == "gluSphere") {
    sphere(draw, call, 1);
  } else if (f == "gluCylinder") {
    cylinder(draw, call, true);
  } else if (!begins) {
    return f.starts_with("glVertex") || f.starts_with("glNormal") || f.starts_with("glTexCoord") || f == "glEnd" ||
           f.starts_with("glEnableClientState") || f.starts_with("glDisableClientState") || f.ends_with("Pointer");
  }
  if (draw.model.empty() && !begins) return true;
  // The parts of a mesh, one glBegin after the other, are one.
  const bool goes_on =
      begins && !s.drawn.empty() && s.drawn.back().model.empty() && s.drawn.back().modelview == draw.modelview;
  if (!goes_on && s.drawn.size() < most_draws) s.drawn.push_back(std::move(draw));
  return true;
}

}  // namespace cg
