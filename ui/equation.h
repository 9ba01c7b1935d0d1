// The equation of the light model with rows of numbers under its terms, fitted into the room that there is.
#pragma once
#include <imgui.h>

#include <array>
#include <string>
#include <vector>

#include "params/field.h"

namespace cg {

struct App;

// What a piece of the equation is; numbers stand under the pieces that have one.
enum class Part { sum, emission, ambient, diffuse, specular, sign, rays };
inline constexpr std::size_t parts_with_numbers = 5;

struct NumberRow {
  std::string label;                                  // to the left of it; may be empty
  std::array<std::string, parts_with_numbers> cells;  // by Part, markup of formula.h
  bool signs = true;                                  // = and + between them
};

// Draws at `at`, at most `width` wide: shrinks, and leaves out what needs rays, rather than being cut; `large` is the
// type that is tried first. The terms are buttons: a click draws one alone, resting on it too while the mouse is
// there. Where `rows` do not fit, `narrow_rows` stand in their place. Returns the height.
float draw_equation(App& app, ImVec2 at, float width, bool large, const std::vector<NumberRow>& rows,
                    const std::vector<NumberRow>& narrow_rows);

// The letters of the ambient term as it is drawn: I_a k_a, or what of a radiosity solution stands for it.
std::string ambient_term(const App& app);

// How high the equation is without rows, and each row.
float equation_height(const App& app, bool large);
float row_height(const App& app);

}  // namespace cg
