// An exported program multiplies its matrices itself, in double. Its routines stand for the calls of OpenGL that they
// replace, and are not followed.
#include <algorithm>

#include "workbench/import_machine.h"

namespace cg {

namespace {

void append(GlState& s, GlCallReader& call, MatrixCall::Kind kind, std::size_t n) {
  call.first_picture = true;  // the mouse moves the eye
  if (auto v = call.numbers(0, n, false); v && s.own.calls.size() < 100)
    s.own.calls.push_back({kind, std::move(*v), call.line});
}

}  // namespace

bool has_own_matrices(const CProgram& program) {
  const auto has = [&](std::string_view name, std::size_t parameters) {
    return std::any_of(program.routines.begin(), program.routines.end(),
                       [&](const CRoutine& r) { return r.name == name && r.parameters.size() == parameters; });
  };
  return has("load_identity", 0) && has("multiply_by", 12) && has("look_at", 9) && has("load_modelview", 0);
}

bool play_own_matrices(GlState& s, GlCallReader& call) {
  const std::string_view f = call.function;
  if (f == "load_identity" || f == "begin_object") {
    s.own.calls.clear();
  } else if (f == "translate") {
    append(s, call, MatrixCall::translate, 3);
  } else if (f == "rotate") {
    append(s, call, MatrixCall::rotate, 4);
  } else if (f == "scale") {
    append(s, call, MatrixCall::scale, 3);
  } else if (f == "look_at") {
    append(s, call, MatrixCall::look_at, 9);
  } else if (f == "copy") {
    s.own.view = s.own.calls;
  } else if (f == "load_modelview") {
    s.modelview = s.own.view;
    s.modelview.insert(s.modelview.end(), s.own.calls.begin(), s.own.calls.end());
  } else if (f == "perspective" || f == "orthographic") {
    GlCallReader as_gl(call.run, f == "perspective" ? "gluPerspective" : "glOrtho", call.arguments, call.line);
    read_projection_call(s, as_gl);
  } else {
    return f == "read_obj";
  }
  return true;
}

}  // namespace cg
