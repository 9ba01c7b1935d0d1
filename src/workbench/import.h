// A student's C program for OpenGL and GLUT, read back as a scene: its first picture, as far as its values are known.
// What is not understood is a complaint with its line, and is left out; classic mistakes are told and become the
// scene's.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "workbench/complaint.h"

namespace cg {

struct ImportReport {
  Scene scene;  // meshes are not loaded
  std::vector<Complaint> complaints;
};

inline constexpr std::size_t largest_c_file = 256 << 10;  // bytes

// Follows main() up to glutMainLoop(), then the functions for reshaping and displaying, once. Of a part of a program,
// without main(): the functions that nothing calls, init and display among them in this order, those that place the
// camera first. `where` names the text in errors. Throws InputError where the text is larger than largest_c_file or
// says nothing to OpenGL.
ImportReport import_c(std::string_view text, const std::string& where);

// What a program cannot say in OpenGL's calls, as a comment of C for its end, by which import_c(text + comment) gives
// `scene` again; empty where import_c(text) does already. A number that was edited in the program since then stays.
std::string import_comment(const Scene& scene, std::string_view text);

// A file's text, as import_c.
ImportReport import_file(const std::filesystem::path& file);

}  // namespace cg
