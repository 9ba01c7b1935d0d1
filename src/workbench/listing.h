// The scene's lighting as the C that a student writes: the calls of shading/gl_calls.h as text, in the order, the names
// and the spacing of the course. The calls are what the fixed function plays, so the text says what it draws.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "params/field.h"
#include "params/words.h"
#include "scene/scene.h"

namespace cg {

// A number in the text of a line: the bytes begin..end-1.
struct ListingNumber {
  std::size_t begin = 0, end = 0;
  std::string path;    // of the parameter that it is ("lights.0.position"); empty: not a parameter of its own
  int component = -1;  // 0..2 of a vector; -1: the parameter is one number
  double value = 0;    // what the text says
  double factor = 1;   // value = factor * parameter (glOrtho is given half the height)
  friend bool operator==(const ListingNumber&, const ListingNumber&) = default;
};

struct ListingLine {
  std::string text;                    // without a line break; empty: a gap between sections
  std::vector<ListingNumber> numbers;  // from left to right
  Quantity quantity = Quantity::none;  // the term that the line feeds
  int light = -1;                      // index into Scene::lights
  std::string path;                    // of the parameter that the line is about, also where it has no number; or empty
  bool comment = false;                // says something and does nothing
  bool guilty = false;                 // a mistake that was put in on purpose is in this line:
  std::string_view mistake = {};       // the name of the member of Mistakes
  friend bool operator==(const ListingLine&, const ListingLine&) = default;
};

struct Listing {
  std::vector<ListingLine> lines;
};

// Where OpenGL cannot do what the scene says (an n over 128, a ninth light, R·V), a comment in `language` says so.
Listing listing(const Scene& scene, Language language = Language::english);

// Gives the parameter that `number` of the listing is what was dragged or typed in its place. Throws InputError that
// names the parameter and what is accepted; the scene is unchanged then.
void assign_number(Scene& scene, const ListingNumber& number, double value);
// `text`: a number as C has it, also with an f behind it: "1.0", ".5f", "1e3".
void assign_number(Scene& scene, const ListingNumber& number, std::string_view text);

}  // namespace cg
