#include "workbench/export.h"
#include "workbench/export_functions.h"
#include "workbench/import.h"

namespace cg {

namespace {

std::string camera(const CParts& parts, Language language) {
  CFunction f("void set_camera( double aspect )",
              {"For every picture, after glClear; aspect is the window's width / height",
               "描くたびに、glClear の後で呼ぶ。aspect はウィンドウの 幅 / 高さ"},
              language);
  for (const GlCall& call : parts.calls(GlSection::projection)) f.say(call);
  f.gap();
  for (const GlCall& call : parts.calls(GlSection::view)) {
    if (call.function == "glClear") continue;
    if (call.function == "gluLookAt" && parts.lights_come_first()) f.say("set_lights();");
    f.say(call);
  }
  return f.text();
}

std::string place_function(int object) { return "place_mesh" + std::to_string(object); }

// The transforms of the objects that have one.
std::vector<std::pair<int, std::string>> places(const CParts& parts, Language language) {
  std::vector<std::pair<int, std::string>> out;
  for (const int object : parts.drawn()) {
    CFunction f("void " + place_function(object) + "( void )", {}, language);
    for (const GlCall& call : parts.calls(GlSection::transform))
      if (call.object == object && !call.function.ends_with("Matrix")) f.say(call);
    if (!f.empty()) out.emplace_back(object, f.text());
  }
  return out;
}

// How a program calls the functions, as a comment.
std::string usage(const CParts& parts, const std::vector<std::pair<int, std::string>>& places, Language language) {
  const auto say = [&](const Text& text) { return text.in(language); };
  std::string out =
      "/* " +
      say({"Exported by Shadebench. In your display():", "Shadebench が書き出した関数。display() の中での使い方："}) +
      "\n *\n *     glClear( GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT );\n"
      " *     set_camera( (double) width / height );\n";
  if (!parts.lights_come_first()) out += " *     set_lights();\n";
  for (const int object : parts.drawn()) {
    const std::string n = std::to_string(object);
    bool placed = false;
    for (const auto& place : places) placed = placed || place.first == object;
    if (placed) out += " *     glPushMatrix();\n *     " + place_function(object) + "();\n";
    out += " *     " + parts.material_function(object) + "();\n *     ... " +
           say({"draw mesh" + n, "mesh" + n + " を描く"}) + "\n";
    if (placed) out += " *     glPopMatrix();\n";
  }
  return out + " *     glutSwapBuffers();\n */\n";
}

}  // namespace

std::string export_c(const Scene& scene, Language language) {
  const CParts parts(scene, language);
  const auto placed = places(parts, language);
  std::string out = usage(parts, placed, language) + parts.left_out_comments() + "\n" + parts.prototypes() +
                    "#include <GL/glut.h>\n" + parts.state_and_lights() + camera(parts, language) + parts.materials();
  for (const auto& place : placed) out += place.second;
  return out + import_comment(scene, out);
}

}  // namespace cg
