// One description per parameter. Slider, tooltip, JSON, --set, uniform, C export, reset, undo and the
// property tests all walk this description; none of them repeats it.
#pragma once
#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "params/words.h"

namespace cg {

enum class Scale { linear, logarithmic };

// What the three numbers of a vector mean; decides the widget and what a single number stands for.
enum class Meaning { number, colour, position, direction };

// The term of the light model that a parameter feeds. Each has one colour on the whole screen.
enum class Quantity { none, ambient, diffuse, specular, reflection, transmission, emission };

struct Range {
  double min = 0, max = 1;  // inclusive
  // Written so that NaN is outside.
  constexpr bool contains(double v) const { return v >= min && v <= max; }
};

// What a reader must know about one parameter. The default is not here: it is the member initialiser of
// the struct, so it is written exactly once.
struct About {
  std::string_view name;             // JSON key = --set path = GLSL uniform = C name
  std::string_view symbol = {};      // as on the blackboard: "k_d", "n"; _ begins a subscript
  std::string_view unit = "1";       // SI, or "deg"; "1" is a pure number
  Range range = {0, 1};              // what is accepted, each component; not used by bool, enum and string
  std::optional<Range> slider = {};  // where a slider ends; the range if there is none
  std::optional<double> also = {};   // one more value that is accepted (GL_SPOT_CUTOFF: 0..90 and 180)
  std::size_t most = 0;              // of a list: how many items it may have
  Scale scale = Scale::linear;       // how a slider moves
  Meaning meaning = Meaning::number;
  Quantity quantity = Quantity::none;
  std::string_view gl = {};  // "GL_SPOT_CUTOFF", where OpenGL has it
  Words label = {};
  Words help = {};  // a sentence or two: what turning it does

  constexpr bool accepts(double v) const { return range.contains(v) || (also && *also == v); }
  constexpr Range slider_range() const { return slider.value_or(range); }
};

template <class Owner, class Value>
struct Field {
  Value Owner::*member;
  About about;
};

template <class Owner, class Value>
constexpr Field<Owner, Value> field(Value Owner::*member, About about) {
  return {member, about};
}

// One value of an enumeration: its name in files, and what a person reads.
struct Name {
  std::string_view id;
  Words label;
  std::string_view formerly = {};  // what older files call it; "true" and "false" are also read where they are no text
};

// Specialised next to each parameter struct and each enum (see scene/material.h).
struct NotDescribed {};
template <class T>
inline constexpr NotDescribed fields_of{};
template <class E>
inline constexpr NotDescribed names_of{};

template <class T>
concept Described = !std::same_as<std::remove_cvref_t<decltype(fields_of<T>)>, NotDescribed>;

template <class T>
struct ListOf : std::false_type {};
template <Described T>
struct ListOf<std::vector<T>> : std::true_type {};

// For static_assert beside the description: unique names, both languages, the default inside its range.
template <Described T>
constexpr bool well_described() {
  const T defaults{};
  std::array<std::string_view, std::tuple_size_v<std::remove_cvref_t<decltype(fields_of<T>)>>> seen{};
  std::size_t n = 0;
  bool ok = true;
  auto check = [&](const auto& value, const About& a) {
    using V = std::remove_cvref_t<decltype(value)>;
    for (std::size_t i = 0; i < n; ++i) ok = ok && seen[i] != a.name;
    seen[n++] = a.name;
    ok = ok && !a.name.empty() && !a.label.en.empty() && !a.label.ja.empty();
    if constexpr (std::same_as<V, int> || std::same_as<V, double>) {
      ok = ok && a.range.min < a.range.max && a.accepts(double(value));
      ok = ok && (a.scale == Scale::linear || a.slider_range().min > 0);
      ok = ok && a.slider_range().min >= a.range.min && a.slider_range().max <= a.range.max;
    }
    if constexpr (std::same_as<V, glm::dvec3>)
      ok = ok && a.accepts(value.x) && a.accepts(value.y) && a.accepts(value.z);
  };
  std::apply([&](const auto&... f) { (check(defaults.*f.member, f.about), ...); }, fields_of<T>);
  return ok;
}

}  // namespace cg
