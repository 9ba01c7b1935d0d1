// The scene as the OpenGL calls that a student of the course writes, as data: the technique gl-fixed plays this list
// and the listing prints it, so that they cannot disagree. The OpenGL Graphics System 2.1, sections 2.11 and 2.14.
//
// What the list says. Always: what a student always writes, which are the light model's ambient colour, glShadeModel,
// GL_DEPTH_TEST, glClearColor, and each light's position, ambient, diffuse and specular colour (so it does not matter
// that GL_LIGHT0 begins white and the others black), and each material's ambient, diffuse and specular colour and
// shininess. Anything else only where it differs from OpenGL's default: attenuation, cone, emission, GL_NORMALIZE,
// local viewer, two sides, clamping, each step of a transform. A reflectance that follows glColor has no glMaterial.
// Where a radiosity solution is drawn (ambient_term.h), the emission of the objects that take part follows a glColor at
// each vertex, and every reflectance has its glMaterial.
// A texture unit has its four choices of wraps and filters and its environment always, its matrix where some layer of
// the scene has one, and glActiveTexture where the scene has more than one. Objects that are not visible are left out;
// objects of one material, one after the other, share its calls.
//
// Which GL_LIGHTi is a light of the scene: its own index, where the scene has at most 8; a light that is off is then
// said too, with glDisable. In larger scenes the lights that are on are numbered in order, and those from the ninth
// are left out with a note.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace cg {

// In the order of the list.
enum class GlSection {
  state,        // init(): what is set once
  light_model,  // init(): glEnable( GL_LIGHTING ), glLightModel, colour material
  projection,   // reshape(): gluPerspective or glOrtho
  view,         // display(): glClear, GL_MODELVIEW, gluLookAt
  lights,       // display(): after the view, or by mistake before gluLookAt
  transform,    // of one object: glPushMatrix, glTranslated, ... and at the end glPopMatrix
  material,     // of one object
  draw,         // of one object: "draw_mesh", the function below, its mesh as the one token ("mesh0")
  // The body of draw_mesh, once, at the end of the list: glBegin, and for each corner of the triangles one glNormal3fv(
  // normal ) and one glVertex3fv( vertex ), glEnd. Where the program lights by hand, glColor3fv( shade( vertex, normal
  // ) ) stands for the normal; "no_normal" there is (0, 0, 1), and flipped( normal ) is -normal. Where a radiosity
  // solution is drawn, glColor3fv( radiosity ) comes first: the material's emission and the solution's light there.
  // With textures, glTexCoord2fv( uv ) stands before the normal, and for each unit after the first
  // glMultiTexCoord2fv( GL_TEXTUREi, uvi ).
  mesh
};

struct GlNumber {
  double value = 0;
  std::string path;           // of the parameter ("lights.0.position"); empty: fixed by the call
  int component = -1;         // 0..2 of a vector, -1 of a number
  double factor = 1;          // value = factor * parameter (glOrtho takes half the height)
  bool times_aspect = false;  // the program multiplies by `aspect`, the picture's width / height; 1 is just `aspect`
  friend bool operator==(const GlNumber&, const GlNumber&) = default;
};

// function( tokens..., numbers... ); an empty function is a place for notes alone.
struct GlCall {
  std::string_view function;        // "glLightfv"
  std::vector<std::string> tokens;  // "GL_LIGHT0", "GL_POSITION"
  std::vector<GlNumber> numbers;
  std::string variable;  // the array that holds the numbers ("light0_position"); empty: they stand in the call
  GlSection section = GlSection::state;
  Quantity quantity = Quantity::none;
  std::string path;               // of the parameter that the call as a whole says ("shading.mode"), else empty
  int light = -1;                 // into Scene::lights
  int object = -1;                // into Scene::objects
  int layer = -1;                 // into the layers of the object's material
  std::string_view mistake = {};  // this is the guilty line: the name of the member of Mistakes
  bool missing = false;           // the mistake is that this call is not there: not played, not in the program
  std::vector<Text> notes = {};   // OpenGL's limits that it meets, to be written as comments before it
  friend bool operator==(const GlCall&, const GlCall&) = default;
};

// Numbers are those that OpenGL is given: a shininess over 128 is 128 here, with a note; all are finite.
std::vector<GlCall> gl_calls(const Scene& scene);

// The mistakes that the fixed function cannot make: the program then has a light model of its own, in C, that lights
// each vertex (shading/own_light_model.h), and GL_LIGHTING is off. What glLight and glMaterial said is read back there.
inline bool lights_by_hand(const Mistakes& m) { return m.no_gate || m.long_light_vector; }

// The layers of textures that the fixed function draws of an object, one a texture unit: those of the lit colour. It
// has at most 8 units (Mesa's number; The OpenGL Graphics System 2.1, section 3.8.15, promises 2).
inline constexpr int gl_texture_unit_limit = 8;
std::vector<const TextureLayer*> fixed_function_layers(const Scene& scene, int object);

// The name in the program of GL_LIGHTi ("light0"), and of an object's material: "material", or "material2" where object
// 2 has its own.
std::string gl_light_variable(int gl_light);
std::string gl_material_variable(const Scene& scene, int object);

}  // namespace cg
