// One described parameter as a row: symbol in its quantity's colour, slider, exact value, reset. Everything it
// shows comes from the description; everything it stores goes through assign().
#pragma once
#include "params/slots.h"
#include "scene/scene.h"

namespace cg {

struct App;

// Draws `slot` as wide as the room there is: a number as one row, a position or direction as a row a coordinate, a
// colour as brightness and swatch, an enumeration as buttons or a list, a bool as a switch. Without a symbol its label
// stands above it; `labelled` false leaves that of a position out, where a heading has said it.
void parameter(App& app, const Slot& slot, bool labelled = true);

// The tessellation of `object`: the same row, with the ends that its shape has; nothing where there is no choice.
void tessellation(App& app, const Slot& slot, const Object& object);

// The same for the slots whose path is `prefix` + one of `names`, in the order of `names`.
void parameters(App& app, const Slots& all, std::string_view prefix, std::initializer_list<std::string_view> names,
                bool labelled = true);

}  // namespace cg
