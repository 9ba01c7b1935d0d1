// What the commands have in common: reading the arguments that several of them take, and telling the user.
#pragma once
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>

#include "params/input_error.h"
#include "workbench/commands.h"

namespace cg {

void print(const std::string& text);  // to stdout

// The whole number that all of `text` spells, if it lies within the limits.
std::optional<int> whole_number(std::string_view text, int least, int most);

// "option: value is not possible; accepted".
InputError bad_option(const std::string& option, const std::string& value, Text accepted);

// --size and --threads.
View view_of(const Arguments& arguments);

// A number >= 0, also as a fraction: "2/255". Nothing where `text` is empty.
std::optional<double> limit_of(const std::string& option, const std::string& text);

// The scene that is named, with --set; what is odd about a model file goes to stderr.
Scene scene_for(const Arguments& arguments, Language language);

// Solves the scene's radiosity where its ambient term asks for it, its progress shown on a terminal; what the solution
// has to say goes to stderr.
void solve_for_command(Scene& scene, const View& view, const Arguments& arguments, Language language);

// The technique of that id, or else the first of `usual` that can draw the scene.
const Technique& technique_for(const std::string& id, std::initializer_list<std::string_view> usual,
                               std::span<const Technique> all, const Scene& scene);

std::string label_of(const Technique& technique, Language language);

// To stderr: the plan's notes, and that NaN or infinity was replaced by 0.
void tell_notes(const Plan& plan, Language language);
// The picture, its progress shown on a terminal; what the plan and the picture have to say goes to stderr.
Frame draw_for_command(const Technique& technique, const Scene& scene, const View& view, Progress& progress,
                       Language language);
void tell_nan(const std::string& technique, const Frame& frame, Language language);

}  // namespace cg
