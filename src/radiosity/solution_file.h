// Solutions in files: PLY with the radiosity of every vertex, as floats and as colours, so that other programs show it,
// and what is needed to go on with it here. Binary, little-endian: doubles stay what they are, and a file is a third of
// its size in text.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "radiosity/solution.h"

namespace cg {

// The file. Comments in the header hold the geometry's key, the parameters, the figures, the size and a checksum.
//   vertex: world position, radiosity over pi, and that as sRGB, the brightest reflected light being 1
//   face:   an element: its outline, patch, level, radiosity over pi
//   patch:  object and face that it is of, area, reflectance, emission, radiosity over pi
std::string solution_bytes(const RadiositySolution& solution);

// Throws InputError as save_file().
void save_solution(const RadiositySolution& solution, const std::filesystem::path& file);

// The solution for `scene`, with the parameters that it was computed with; it has no matrix. Where the scene's
// materials are others now, a note says so. Throws InputError where the file is none of ours, is cut short or altered,
// or was computed for another geometry; Cancelled.
SolutionHandle read_solution(const std::filesystem::path& file, const Scene& scene, Progress& progress);
// The same from bytes; `where` is the file's name in messages.
SolutionHandle solution_of(std::string_view bytes, const std::string& where, const Scene& scene, Progress& progress);

}  // namespace cg
