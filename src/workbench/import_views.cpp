// The matrix calls of a program that is read, and GLUT's own.
#include <cmath>

#include "math/transform.h"
#include "workbench/import_constants.h"
#include "workbench/import_machine.h"

namespace cg {

namespace {

constexpr std::size_t most_calls = 1000, deepest_stack = 64;

MatrixCalls* current(GlState& s) {
  return s.matrix_mode == gl_constant::modelview    ? &s.modelview
         : s.matrix_mode == gl_constant::projection ? &s.projection
                                                    : nullptr;
}

void multiply(GlState& s, GlCallReader& call, MatrixCall::Kind kind, std::vector<double> numbers) {
  MatrixCalls* calls = current(s);
  if (!calls) return;
  if (calls->size() >= most_calls) return call.refuse({"too many matrices are multiplied", "行列の掛け算が多すぎる"});
  calls->push_back({kind, std::move(numbers), call.line});
}

void push(GlState& s, GlCallReader& call) {
  auto& stack = s.matrix_mode == gl_constant::projection ? s.projection_stack : s.modelview_stack;
  MatrixCalls* calls = current(s);
  if (!calls) return;
  if (stack.size() >= deepest_stack) return call.refuse({"the matrix stack is full", "行列スタックがあふれる"});
  stack.push_back(*calls);
}

void pop(GlState& s, GlCallReader& call) {
  auto& stack = s.matrix_mode == gl_constant::projection ? s.projection_stack : s.modelview_stack;
  MatrixCalls* calls = current(s);
  if (!calls) return;
  if (stack.empty()) return call.refuse({"there is no glPushMatrix before it", "対応する glPushMatrix がない"});
  *calls = std::move(stack.back());
  stack.pop_back();
}

void look(GlState& s, GlCallReader& call) {
  auto v = call.numbers(0, 9, false);
  if (!v) return;
  if (s.matrix_mode == gl_constant::projection) {
    call.complain(
        {"gluLookAt is given to GL_PROJECTION: light is computed before it, as if the eye stood at the origin",
         "gluLookAt を GL_PROJECTION に掛けている：光源計算では視点が原点にあることになる"});
    s.projection_view = {{MatrixCall::look_at, std::move(*v), call.line}};
    return;
  }
  multiply(s, call, MatrixCall::look_at, std::move(*v));
}

void set_lens(GlState& s, GlCallReader& call, GlState::Projection lens) {
  if (s.matrix_mode != gl_constant::projection)
    call.complain({"{0} is given to GL_MODELVIEW", "{0} を GL_MODELVIEW に掛けている"},
                  {{std::string(call.function), std::string(call.function)}});
  lens.line = call.line;
  s.lens = lens;
}

// The aspect may depend on the window: it is not asked for.
void perspective_call(GlState& s, GlCallReader& call) {
  const auto fov = call.number(0), near_plane = call.number(2), far_plane = call.number(3);
  if (fov && near_plane && far_plane) set_lens(s, call, {0, false, *fov, 0, *near_plane, *far_plane});
}

// Left and right of the same size, where they are known: they may depend on the window.
void box(GlState& s, GlCallReader& call, bool orthographic, bool has_depth) {
  const auto bottom = call.number(2), top = call.number(3);
  const auto near_plane = has_depth ? call.number(4) : std::optional(-1.0);
  const auto far_plane = has_depth ? call.number(5) : std::optional(1.0);
  if (!bottom || !top || !near_plane || !far_plane) return;
  const auto uneven = [&](double a, double b) { return std::abs(a + b) > 1e-6 * (std::abs(a) + std::abs(b)); };
  const CValue &left = call.arguments[0], &right = call.arguments[1];
  const bool sides_known = left.state != CValue::unknown && right.state != CValue::unknown;
  if (uneven(*bottom, *top) || (sides_known && uneven(left.number, right.number)))
    call.complain({"the view is not symmetric: taken as centred", "視野が左右上下対称でない：中央にそろえる"});
  GlState::Projection lens{0, orthographic, 0, *top - *bottom, *near_plane, *far_plane};
  lens.fov = degrees(2 * std::atan(0.5 * lens.height / *near_plane));
  set_lens(s, call, lens);
}

}  // namespace

bool read_matrix_call(GlState& s, GlCallReader& call) {
  const std::string_view f = call.function;
  const auto product = [&](std::string_view stem, MatrixCall::Kind kind, std::size_t n, bool array) {
    if (f.size() != stem.size() + 1 || !f.starts_with(stem) || (f.back() != 'f' && f.back() != 'd')) return false;
    if (auto v = call.numbers(0, n, array)) multiply(s, call, kind, std::move(*v));
    return true;
  };
  if (f == "glMatrixMode") {
    if (const auto mode = call.token(0)) s.matrix_mode = *mode;
  } else if (f == "glLoadIdentity") {
    if (MatrixCalls* calls = current(s)) calls->clear();
    if (s.matrix_mode == gl_constant::projection) s.projection_view.clear();
  } else if (f == "glPushMatrix") {
    push(s, call);
  } else if (f == "glPopMatrix") {
    pop(s, call);
  } else if (f == "gluLookAt") {
    look(s, call);
  } else if (f == "glLoadMatrixd" && s.own.used) {
    if (s.matrix_mode == gl_constant::modelview) s.modelview = s.own.calls;
  } else if (f == "glRotated" && s.own.used && !call.arguments.empty() && call.arguments[0].number == 0) {
    return true;  // what a key turns later
  } else if (f == "glLoadMatrixf" || f == "glLoadMatrixd") {
    auto v = call.numbers(0, 16, true);
    MatrixCalls* calls = current(s);
    if (v && calls) *calls = {{MatrixCall::matrix, std::move(*v), call.line}};
  } else {
    return product("glTranslate", MatrixCall::translate, 3, false) ||
           product("glRotate", MatrixCall::rotate, 4, false) || product("glScale", MatrixCall::scale, 3, false) ||
           product("glMultMatrix", MatrixCall::matrix, 16, true);
  }
  return true;
}

bool read_projection_call(GlState& s, GlCallReader& call) {
  if (call.function == "gluPerspective")
    perspective_call(s, call);
  else if (call.function == "glOrtho" || call.function == "glFrustum")
    box(s, call, call.function == "glOrtho", true);
  else if (call.function == "gluOrtho2D")
    box(s, call, true, false);
  else
    return false;
  return true;
}

bool read_glut_call(GlState& s, GlCallReader& call) {
  const std::string_view f = call.function;
  if (!f.starts_with("glut")) return false;
  if (f == "glutInitWindowSize") {
    const auto width = call.token(0), height = call.token(1);
    if (width && height) s.width = std::max(1, *width), s.height = std::max(1, *height);
  } else if (f == "glutMainLoop") {
    s.main_loop = true;
    call.run.stop();
  } else if (f.ends_with("Func") || f == "glutCreateMenu") {
    for (const CValue& a : call.arguments)
      if (!a.function.empty()) s.callbacks[f] = a.function;
  }
  return true;
}

}  // namespace cg
