// The fixed function's state while a program is read: what its calls set, as they set it (The OpenGL Graphics System
// 2.1, sections 2.11 and 2.14, and the state tables of chapter 6). Calls whose values are not known are left out with a
// complaint.
#pragma once
#include <array>
#include <functional>
#include <map>
#include <set>

#include "workbench/c_run.h"
#include "workbench/import_matrices.h"

namespace cg {

// A light of OpenGL with OpenGL's defaults; only GL_LIGHT0 begins white.
struct GlLightState {
  bool touched = false, enabled = false, disabled = false;  // disabled: by a call
  bool coned = false, fading = false;                       // a cone, an attenuation was set
  bool position_left_out = false;
  glm::dvec3 ambient{0}, diffuse{0}, specular{0};
  glm::dvec4 position{0, 0, 1, 0};
  MatrixCalls position_matrix;
  glm::dvec3 direction{0, 0, -1};
  MatrixCalls direction_matrix;
  double exponent = 0, cutoff = 180, k_0 = 1, k_1 = 0, k_2 = 0;
  long line = 0, position_line = 0, direction_line = 0;  // of the first call, and the last; 0: none
};

struct GlMaterialState {
  glm::dvec3 k_a{0.2}, k_d{0.8}, k_s{0}, emission{0}, color{1};
  double n = 0;
  bool diffuse_set = false, ambient_set = false;
  long color_line = 0;  // of glColor; 0: not called
};

// Something that is drawn.
struct GlDraw {
  long line = 0;
  std::string model;  // a shape's id; empty: a mesh of the program's own
  int tessellation = 0;
  MatrixCalls modelview;
  MatrixCalls fit;  // from the shape as the workbench makes it to the one that GLUT draws
  GlMaterialState material;
  int color_material = 0;  // what follows glColor (GL_DIFFUSE, ...); 0: nothing
  bool lit = false;
};

struct GlState {
  std::array<GlLightState, 8> lights;
  GlMaterialState material;
  std::set<int> enabled;
  int color_material = 0x1602;  // GL_AMBIENT_AND_DIFFUSE, where it is enabled
  glm::dvec3 ambient{0.2}, background{0};
  bool local_viewer = false, two_sided = false, flat = false, clockwise = false, clamp = true;
  long front_face_line = 0;
  int matrix_mode = 0x1700;  // GL_MODELVIEW
  MatrixCalls modelview, projection;
  std::vector<MatrixCalls> modelview_stack, projection_stack;
  // The last gluPerspective, glFrustum or glOrtho; the numbers as Camera has them.
  struct Projection {
    long line = 0;
    bool orthographic = false;
    double fov = 0, height = 0, near_plane = 0, far_plane = 0;
  } lens;
  MatrixCalls projection_view;  // gluLookAt given to the projection matrix
  std::vector<GlDraw> drawn;
  // GLUT
  int width = 300, height = 300;
  std::map<std::string_view, std::string_view> callbacks;  // "glutDisplayFunc": the program's function
  bool main_loop = false;
  bool in_list = false;  // between glNewList and glEndList
  // Of an exported program: the matrix that it multiplies itself, and the one that it keeps as its view.
  struct {
    bool used = false;
    MatrixCalls calls, view;
  } own;
  bool any_call = false;
};

class GlMachine : public CHost {
 public:
  std::optional<CValue> constant(std::string_view name) override;
  CValue call(CRun& run, std::string_view function, const std::vector<CValue>& arguments, long line) override;
  bool only_reads(std::string_view function) const override;
  bool plays(CRun& run, const CRoutine& routine, const std::vector<CValue>& arguments, long line) override;

  GlState state;

 private:
  std::map<const CRoutine*, bool> meshes_;
};

// One call while it is carried out.
class GlCallReader {
 public:
  GlCallReader(CRun& run, std::string_view function, const std::vector<CValue>& arguments, long line)
      : run(run), function(function), arguments(arguments), line(line) {}

  // The argument's number, or a complaint (one a call) and nothing.
  std::optional<double> number(std::size_t i);
  std::optional<int> token(std::size_t i);
  // `n` numbers: the arguments from `i` on, or where `array`, what the argument points to.
  std::optional<std::vector<double>> numbers(std::size_t i, std::size_t n, bool array);
  // Of a colour with alpha, which has no meaning here: three are enough, but told.
  std::optional<glm::dvec3> colour(std::size_t i);
  bool has(std::size_t n);
  bool first_picture = false;  // numbers that change later are taken as they are at first
  // Where the call starts a complaint: "this glLightfv is left out".
  void refuse(const Words& why, std::initializer_list<Text> values = {});
  void complain(const Words& text, std::initializer_list<Text> values = {});

  CRun& run;
  const std::string_view function;
  const std::vector<CValue>& arguments;
  const long line;

 private:
  const CValue& checked(const CValue& v);
  bool refused_ = false;
};

// Each returns whether the call is one of its own.
bool read_light_call(GlState& state, GlCallReader& call);
bool read_material_call(GlState& state, GlCallReader& call);
bool read_state_call(GlState& state, GlCallReader& call);
bool read_matrix_call(GlState& state, GlCallReader& call);
bool read_projection_call(GlState& state, GlCallReader& call);
bool read_draw_call(GlState& state, GlCallReader& call);
bool read_glut_call(GlState& state, GlCallReader& call);

// Whether the program is an exported one, and a call of one of its routines that stand for OpenGL's.
bool has_own_matrices(const CProgram& program);
bool play_own_matrices(GlState& state, GlCallReader& call);

// What is drawn now, but for its shape; a mesh of the program's own.
GlDraw begin_draw(const GlState& state, long line);
void add_mesh(GlState& state, long line);

// What the name ends in behind `stem`: of "glColor3fv" behind "glColor" count 3, type "f", array.
struct GlSuffix {
  int count = 0;
  std::string_view type;
  bool array = false;
};
std::optional<GlSuffix> gl_suffix(std::string_view function, std::string_view stem);

}  // namespace cg
