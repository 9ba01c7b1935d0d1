// The functions of an exported C text, made from the calls of the listing. C89: declarations stand before statements.
#pragma once
#include <string>
#include <vector>

#include "workbench/listing_lines.h"

namespace cg {

// A C function while it is written, line by line.
class CFunction {
 public:
  // `head`: "void set_lights( void )"; `comment` stands in the line before it, if there is one.
  CFunction(std::string head, Words comment, Language language)
      : head_(std::move(head)), comment_(comment.in(language)), language_(language) {}

  CFunction& declare(const std::string& line);
  CFunction& say(const std::string& line);
  CFunction& gap();
  // The call with its notes and its array; one that is missing by mistake is left out.
  CFunction& say(const GlCall& call);
  CFunction& say(const GlCall& call, std::string_view function);  // another function with the same arguments

  bool empty() const { return statements_.empty(); }
  std::string text() const;

 private:
  void say_notes(const GlCall& call);
  std::string head_, comment_, declarations_, statements_;
  Language language_;
};

// What the exports of C have in common. The ambient term is the constant one: meshes are exported as they are, without
// the elements and the light of a radiosity solution.
class CParts {
 public:
  CParts(const Scene& scene, Language language);

  std::vector<GlCall> calls(GlSection section) const;
  // The functions set_state and set_lights, and a set_material for each material.
  std::string state_and_lights() const;
  std::string materials() const;
  // "set_material2" for the object whose material it is.
  std::string material_function(int object) const { return "set_" + gl_material_variable(scene_, object); }
  // The indices of the objects that are drawn.
  std::vector<int> drawn() const;
  // By mistake the lights are set before the view.
  bool lights_come_first() const;
  // A function whose declaration is there only where it is asked for: a line before the #include, or none.
  std::string prototypes() const;
  // What of the scene no program of OpenGL draws, as comments: a radiosity solution, for which the constant ambient
  // term stands, and a photographic display.
  std::string left_out_comments() const;

 private:
  const Scene& scene_;
  const Language language_;
  const std::vector<GlCall> calls_;
};

// A text that may stand in a comment, and one between quotation marks.
std::string in_comment(std::string_view text);
std::string in_string(std::string_view text);

}  // namespace cg
