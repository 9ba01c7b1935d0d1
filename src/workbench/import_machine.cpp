#include "workbench/import_machine.h"

#include <algorithm>
#include <cmath>

#include "math/transform.h"
#include "scene/text_scanner.h"
#include "workbench/import_constants.h"

namespace cg {

namespace {

// Functions without an effect on a scene.
constexpr std::string_view harmless[] = {
    "glClear",        "glClearDepth",     "glClearStencil",   "glFlush",           "glFinish",
    "glViewport",     "glHint",           "glDepthFunc",      "glDepthMask",       "glLineWidth",
    "glPointSize",    "glRasterPos2f",    "glRasterPos3f",    "glGetError",        "glPixelStorei",
    "glCullFace",     "glGetString",      "glBlendFunc",      "glGenLists",        "glEndList",
    "glDeleteLists",  "gluNewQuadric",    "gluDeleteQuadric", "gluQuadricNormals", "gluQuadricDrawStyle",
    "gluErrorString", "gluQuadricTexture"};
constexpr std::string_view plain_c[] = {"printf", "fprintf", "puts",  "putchar", "fflush", "free", "srand",
                                        "time",   "perror",  "fputs", "sprintf", "system", "exit", "abort"};

template <std::size_t n>
bool contains(const std::string_view (&list)[n], std::string_view word) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

Text code(std::string_view word) { return {readable(word), readable(word)}; }

// A glBegin or one of its relatives somewhere in it, and no call that sets what a scene has.
struct MeshSigns {
  bool draws = false, sets = false;
  void look(const CExpression& e) {
    if (e.kind == CExpression::call) {
      const std::string_view f = e.operands[0].name;
      // Axes and grids are lines: no mesh.
      const std::string_view kind = e.operands.size() > 1 ? e.operands[1].name : std::string_view();
      const bool lines = kind.starts_with("GL_LINE") || kind.starts_with("GL_POINT");
      draws = draws || (f == "glBegin" && !lines) || f.starts_with("glDraw") || f == "glCallList";
      for (const std::string_view stem : {"glLight", "glMaterial", "glTranslate", "glRotate", "glScale", "glPushMatrix",
                                          "glLoad", "glMult", "glu", "glEnable", "glDisable", "glClear", "glFog"})
        sets = sets || f.starts_with(stem);
    }
    for (const CExpression& o : e.operands) look(o);
  }
  void look(const CStatement& s) {
    for (const CExpression& e : s.expressions) look(e);
    for (const CStatement& b : s.body) look(b);
  }
};

}  // namespace

// ---- one call ----

void GlCallReader::complain(const Words& text, std::initializer_list<Text> values) {
  run.complain(line, phrase(text, values));
}

void GlCallReader::refuse(const Words& why, std::initializer_list<Text> values) {
  if (refused_) return;
  refused_ = true;
  run.complain(line, phrase({"{0}: this {1} is left out", "{0}：この {1} は読み込まない"},
                            {phrase(why, values), code(function)}));
}

bool GlCallReader::has(std::size_t n) {
  if (arguments.size() >= n) return true;
  refuse({"{0} arguments are expected", "引数は {0} 個必要"}, {text_of(n)});
  return false;
}

std::optional<double> GlCallReader::number(std::size_t i) {
  if (!has(i + 1)) return std::nullopt;
  const CValue& v = arguments[i];
  if ((v.state == CValue::known || (first_picture && v.state == CValue::at_start)) && v.is_number()) return v.number;
  const Text why = v.state != CValue::known ? run.memory.reason_text(v.reason)
                                            : Text{"an argument is not a number", "引数が数ではない"};
  refuse({"{0}", "{0}"}, {why});
  return std::nullopt;
}

std::optional<int> GlCallReader::token(std::size_t i) {
  const auto v = number(i);
  if (!v) return std::nullopt;
  if (*v == std::floor(*v) && *v >= 0 && *v < 1e9) return int(*v);
  refuse({"an argument is not a constant of OpenGL", "引数が OpenGL の定数ではない"});
  return std::nullopt;
}

std::optional<std::vector<double>> GlCallReader::numbers(std::size_t i, std::size_t n, bool array) {
  std::vector<double> out;
  if (!array) {
    for (std::size_t k = 0; k < n; ++k) {
      const auto v = number(i + k);
      if (!v) return std::nullopt;
      out.push_back(*v);
    }
    return out;
  }
  if (!has(i + 1)) return std::nullopt;
  const CValue& a = arguments[i];
  if (!a.is_address()) {
    if (a.state != CValue::known)
      refuse({"{0}", "{0}"}, {run.memory.reason_text(a.reason)});
    else
      refuse({"an array is expected", "配列が必要"});
    return std::nullopt;
  }
  for (const CValue& v : run.memory.read(a.address, n)) {
    if (v.state != CValue::known || !v.is_number()) {
      refuse({"{0}", "{0}"}, {run.memory.reason_text(v.reason)});
      return std::nullopt;
    }
    out.push_back(v.number);
  }
  if (out.size() == n) return out;
  refuse({"the array has {0} values, OpenGL reads {1}", "配列の値は {0} 個だが、OpenGL は {1} 個読む"},
         {text_of(out.size()), text_of(n)});
  return std::nullopt;
}

std::optional<glm::dvec3> GlCallReader::colour(std::size_t i) {
  const bool address = arguments.size() > i && arguments[i].is_address();
  const bool short_one = address && run.memory.read(arguments[i].address, 4).size() == 3;
  const auto v = numbers(i, 3, true);
  if (!v) return std::nullopt;
  if (short_one) complain({"the array has 3 values, OpenGL reads 4", "配列の値は 3 個だが、OpenGL は 4 個読む"});
  return glm::dvec3((*v)[0], (*v)[1], (*v)[2]);
}

std::optional<GlSuffix> gl_suffix(std::string_view function, std::string_view stem) {
  if (!function.starts_with(stem)) return std::nullopt;
  std::string_view rest = function.substr(stem.size());
  GlSuffix out;
  if (!rest.empty() && rest[0] >= '2' && rest[0] <= '4') out.count = rest[0] - '0', rest.remove_prefix(1);
  if (rest.size() > 1 && rest.ends_with('v')) out.array = true, rest.remove_suffix(1);
  for (const std::string_view type : {"f", "d", "i", "b", "ub", "s", "us", "ui"})
    if (rest == type) {
      out.type = type;
      return out;
    }
  return std::nullopt;
}

GlDraw begin_draw(const GlState& s, long line) {
  GlDraw draw;
  draw.line = line, draw.modelview = s.modelview, draw.material = s.material;
  draw.color_material = s.enabled.contains(gl_constant::color_material) ? s.color_material : 0;
  draw.lit = s.enabled.contains(gl_constant::lighting);
  return draw;
}

// ---- the machine ----

std::optional<CValue> GlMachine::constant(std::string_view name) {
  const std::pair<std::string_view, double> numbers[] = {
      {"M_PI", pi}, {"M_PI_2", pi / 2}, {"M_PI_4", pi / 4}, {"M_SQRT2", std::sqrt(2.0)}, {"M_SQRT1_2", std::sqrt(0.5)}};
  for (const auto& [known, value] : numbers)
    if (known == name) return c_real(value);
  const auto value = gl_constant_value(name);
  return value ? std::optional(c_integer(*value)) : std::nullopt;
}

bool GlMachine::only_reads(std::string_view f) const {
  return (f.starts_with("gl") && !f.starts_with("glGet") && !f.starts_with("glRead") && f != "gluUnProject") ||
         (contains(plain_c, f) && f != "sprintf");
}

CValue GlMachine::call(CRun& run, std::string_view function, const std::vector<CValue>& arguments, long line) {
  GlCallReader call(run, function, arguments, line);
  run.charge(state.modelview.size() / 2);  // it may be kept with what is set
  state.any_call = state.any_call || function.starts_with("gl");
  if (function == "glNewList" || function == "glEndList") state.in_list = function == "glNewList";
  if (state.in_list) return run.memory.unknown({"this is in a display list", "ディスプレイリストの中にある"});
  for (const auto read : {read_light_call, read_material_call, read_state_call, read_matrix_call, read_projection_call,
                          read_draw_call, read_glut_call})
    if (read(state, call)) return run.memory.unknown_result(function);
  if (function == "exit" || function == "abort") run.stop();
  if (function == "memcpy" && state.own.used) state.own.view = state.own.calls;
  if (function.starts_with("gl") && !contains(harmless, function) && !contains(plain_c, function))
    call.complain({"{0} is not read", "{0} は読み込めない"}, {code(function)});
  return run.memory.unknown_result(function);
}

// A routine that only gives vertices is a mesh of the program's own: it is not followed.
bool GlMachine::plays(CRun& run, const CRoutine& routine, const std::vector<CValue>& arguments, long line) {
  if (state.in_list) return true;
  GlCallReader call(run, routine.name, arguments, line);
  if (state.own.used && play_own_matrices(state, call)) return true;
  const auto [at, added] = meshes_.try_emplace(&routine, false);
  if (added) {
    MeshSigns signs;
    signs.look(routine.body);
    at->second = signs.draws && !signs.sets;
  }
  if (at->second) add_mesh(state, line);
  return at->second;
}

}  // namespace cg
