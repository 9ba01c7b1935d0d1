#include <algorithm>

#include "params/numbers.h"
#include "scene/mesh.h"
#include "shading/own_light_model.h"
#include "workbench/export.h"
#include "workbench/export_functions.h"
#include "workbench/glut_program.h"
#include "workbench/import.h"

namespace cg {

namespace {

// A file's name as a word of a Makefile and of a shell's line.
std::string as_word(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80 ||
                       std::string_view("._+-").find(c) != std::string_view::npos;
    if (!plain) out += '\\';
    out += c;
  }
  return out;
}

class GlutProgram {
 public:
  GlutProgram(const Scene& scene, const std::string& obj_name, Language language)
      : scene_(scene), obj_name_(obj_name), language_(language), parts_(scene, language) {}

  std::string text() const {
    return head() + parts_.left_out_comments() + globals() + in_language(glut_matrices) + std::string(projection()) +
           vectors() + std::string(glut_look_at) + in_language(glut_meshes) + heading({"The scene", "シーン"}) +
           std::string(glut_modelview) + parts_.state_and_lights() + camera() + parts_.materials() + places() +
           helpers() + draw_mesh() + draw_scene() + in_language(glut_window);
  }

 private:
  std::string say(const Text& text) const { return text.in(language_); }
  std::string heading(const Text& text) const { return "\n/* ---- " + say(text) + " ---- */\n"; }

  // The text with each {{English|Japanese}} in the language.
  std::string in_language(std::string_view text) const {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t open = std::min(text.find("{{", at), text.size()), bar = text.find('|', open),
                        close = text.find("}}", open);
      out += text.substr(at, open - at);
      if (open == text.size()) break;
      out += say(Words{text.substr(open + 2, bar - open - 2), text.substr(bar + 1, close - bar - 1)});
      at = close + 2;
    }
    return out;
  }

  std::string head() const {
    const std::string stem = obj_name_.substr(0, obj_name_.rfind('.')), word = in_comment(as_word(stem)),
                      obj = in_comment(obj_name_), ppm = in_comment(stem) + ".ppm";
    return "/* " + in_comment(stem) + ".c: " + say({"exported by Shadebench", "Shadebench が書き出したプログラム"}) +
           "\n *\n * Makefile:\n *   " + word + ": " + word + ".c\n" +  //
           " *   \tcc -o " + word + " " + word + ".c -lglut -lGLU -lGL -lm\n *\n * " +
           say({"It needs freeglut (Debian, Ubuntu: sudo apt install freeglut3-dev) and " + obj + " in its own folder.",
                "freeglut（Debian、Ubuntu では sudo apt install freeglut3-dev）と、同じフォルダの " + obj +
                    " が必要。"}) +
           "\n *\n * " +
           say({"Drag: turn the view. Wheel: nearer, farther. a: the lights turn. m: the model turns.",
                "ドラッグで視点を回す。ホイールで近づく・離れる。a で光源、m でモデルが回る。"}) +
           "\n * " +
           say({"s: save the picture as " + ppm + ". q: end.", "s で画像を " + ppm + " に保存する。q で終わる。"}) +
           " */\n";
  }

  std::string globals() const {
    const std::string stem = obj_name_.substr(0, obj_name_.rfind('.'));
    std::string out = "\n" + parts_.prototypes() +
                      "#include <GL/glut.h>\n#include <math.h>\n#include <stdio.h>\n#include <stdlib.h>\n"
                      "#include <string.h>\n\n"
                      "#define OBJ_NAME \"" +
                      in_string(obj_name_) + "\"\n#define PICTURE_NAME \"" + in_string(stem) + ".ppm\"\n" +
                      "#define MOST_CORNERS " + std::to_string(most_corners()) + " /* " +
                      say({"of a face", "一つの面の頂点数の最大"}) + " */\n\nenum { ";
    for (const int object : parts_.drawn()) out += mesh_name(object) + ", ";
    return out + "meshes };\n\n" + camera_globals() + "double aspect = 1.0; /* " +
           say({"the window's width / height", "ウィンドウの 幅 / 高さ"}) + " */\n" + "double view[16];     /* " +
           say({"world to eye", "ワールドから視点へ"}) + " */\n" + "double light_angle = 0.0, model_angle = 0.0; /* " +
           say({"degrees about the y axis", "y 軸まわりの角度（度）"}) + " */\n";
  }

  std::size_t most_corners() const {
    std::size_t most = 3;
    for (const int object : parts_.drawn())
      if (const MeshHandle& mesh = scene_.objects[std::size_t(object)].mesh) {
        const std::vector<std::uint32_t>& first = mesh->data().first_corner;
        for (std::size_t f = 0; f + 1 < first.size(); ++f) most = std::max<std::size_t>(most, first[f + 1] - first[f]);
      }
    return most;
  }

  static std::string mesh_name(int object) { return "mesh" + std::to_string(object); }

  GlCall look_at() const {
    for (const GlCall& call : parts_.calls(GlSection::view))
      if (call.function == "gluLookAt") return call;
    return {};
  }

  // The nine numbers of gluLookAt, which the mouse changes.
  std::string camera_globals() const {
    const GlCall call = look_at();
    std::string out;
    const char* names[] = {"eye", "target", "up"};
    for (std::size_t v = 0; v < 3; ++v) {
      out += "double " + std::string(names[v]) + "[] = { ";
      for (std::size_t i = 0; i < 3; ++i) out += (i ? ", " : "") + c_literal(call.numbers[3 * v + i].value);
      out += " };\n";
    }
    return out;
  }

  std::string_view projection() const {
    const bool flat = scene_.camera.projection == Projection::orthographic;
    return flat ? glut_orthographic : glut_perspective;
  }

  // The function of the program that does in double what one of OpenGL does in float; OpenGL's own where there is none.
  static std::string_view in_double(std::string_view function) {
    for (const auto& [gl, own] : {std::pair<std::string_view, std::string_view>("glLoadIdentity", "load_identity"),
                                  {"gluPerspective", "perspective"},
                                  {"glOrtho", "orthographic"},
                                  {"glTranslated", "translate"},
                                  {"glRotated", "rotate"},
                                  {"glScaled", "scale"}})
      if (function == gl) return own;
    return function;
  }

  std::string camera() const {
    CFunction f("void set_camera( void )", {}, language_);
    for (const GlCall& call : parts_.calls(GlSection::projection)) f.say(call, in_double(call.function));
    f.say("glLoadMatrixd( matrix );").gap();
    f.say("glMatrixMode( GL_MODELVIEW );").say("load_identity();");
    f.say("look_at( eye[0], eye[1], eye[2], target[0], target[1], target[2], up[0], up[1], up[2] );");
    return f.say("glLoadMatrixd( matrix );").say("copy( view, matrix );").text();
  }

  // The transform of an object; empty where it has none.
  std::string place(int object) const {
    CFunction f("void place_" + mesh_name(object) + "( void )", {}, language_);
    for (const GlCall& call : parts_.calls(GlSection::transform))
      if (call.object == object && in_double(call.function) != call.function) f.say(call, in_double(call.function));
    return f.empty() ? "" : f.text();
  }
  std::string places() const {
    std::string out;
    for (const int object : parts_.drawn()) out += place(object);
    return out;
  }

  // dot and normalize: the light model of the program's own, where it has one, brings them.
  std::string vectors() const {
    if (!lights_by_hand(scene_.mistakes)) return std::string(glut_vectors);
    std::string out = "\n";
    for (const SourceLine& line : own_light_model(scene_.mistakes))
      if (!line.missing) out += line.text + "\n";
    return out;
  }

  // What the mesh's calls name beside OpenGL and that light model.
  std::string helpers() const {
    if (mesh_calls_name("no_normal")) return "\nconst float no_normal[] = { 0.0, 0.0, 1.0 };\n";
    if (!mesh_calls_name("flipped(")) return "";
    return CFunction("const float *flipped( const float n[3] )", {}, language_)
        .declare("static float f[3];")
        .say("f[0] = -n[0], f[1] = -n[1], f[2] = -n[2];")
        .say("return f;")
        .text();
  }
  bool mesh_calls_name(std::string_view word) const {
    for (const GlCall& call : parts_.calls(GlSection::mesh))
      for (const std::string& token : call.tokens)
        if (!call.missing && token.find(word) != token.npos) return true;
    return false;
  }

  std::string draw_mesh() const {
    CFunction f("void draw_mesh( int mesh )", {}, language_);
    f.declare("long i;");
    if (lights_by_hand(scene_.mistakes)) f.say("read_lights();");
    std::vector<GlCall> calls = parts_.calls(GlSection::mesh);
    std::erase_if(calls, [](const GlCall& call) { return call.missing; });
    for (std::size_t i = 0; i < calls.size(); ++i) {
      if (i + 1 == calls.size()) f.say("}");  // before glEnd
      f.say((i > 0 && i + 1 < calls.size() ? "    " : "") + statement(calls[i]).text);
      if (i > 0) continue;
      f.say("for ( i = first[mesh]; i < first[mesh + 1]; i++ ) {");
      f.say("    const float *vertex = vertices.numbers + 3 * i;");
      if (mesh_calls_name("normal") && !mesh_calls_name("no_normal"))
        f.say("    const float *normal = normals.numbers + 3 * i;");
      f.gap();
    }
    return f.text();
  }

  std::string draw_scene() const {
    CFunction f("void draw_scene( void )", {}, language_);
    for (const GlCall& call : parts_.calls(GlSection::view))
      if (call.function == "glClear") f.say(call);
    if (parts_.lights_come_first())
      f.say("glMatrixMode( GL_MODELVIEW );").say("glLoadIdentity();");
    else
      f.say("set_camera();");
    f.say("glPushMatrix();").say("glRotated( light_angle, 0.0, 1.0, 0.0 );").say("set_lights();");
    f.say("glPopMatrix();");
    if (parts_.lights_come_first()) f.say("set_camera();");
    for (const int object : parts_.drawn()) {
      f.gap().say("begin_object();");
      if (!place(object).empty()) f.say("place_" + mesh_name(object) + "();");
      f.say("load_modelview();");
      f.say(parts_.material_function(object) + "();").say("draw_mesh( " + mesh_name(object) + " );");
    }
    return f.text();
  }

  const Scene& scene_;
  const std::string& obj_name_;
  const Language language_;
  const CParts parts_;
};

}  // namespace

std::string export_glut(const Scene& scene, const std::string& obj_name, Language language) {
  const std::string text = GlutProgram(scene, obj_name, language).text();
  return text + import_comment(scene, text);
}

}  // namespace cg
