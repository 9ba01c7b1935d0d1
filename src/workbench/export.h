// What leaves the workbench for an assignment: a preset, C for a program of one's own, a whole GLUT program, the
// meshes.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "params/field.h"
#include "params/words.h"
#include "scene/scene.h"

namespace cg {

enum class ExportFormat { json, c, glut, obj };
template <>
inline constexpr std::array<Name, 4> names_of<ExportFormat>{{{"json", {"Preset (JSON)", "プリセット（JSON）"}},
                                                             {"c", {"C functions", "C の関数"}},
                                                             {"glut", {"GLUT program", "GLUT プログラム"}},
                                                             {"obj", {"Meshes (OBJ)", "メッシュ（OBJ）"}}}};

// The functions set_camera, set_lights and set_material in C89, for a program that a student has already; comments in
// `language`. OpenGL's limits are respected and said in a comment.
std::string export_c(const Scene& scene, Language language = Language::english);

// A complete C89 program for GLUT that draws the scene as the technique gl-fixed does. It reads the meshes from the
// file `obj_name`, which is to hold export_obj(scene), in its own folder.
std::string export_glut(const Scene& scene, const std::string& obj_name, Language language = Language::english);

// The meshes of the visible objects, each as an `o` in its own coordinates (its transform is said in a comment), with
// the normals by the scene's rule at each corner: of flat shading, the face's. Faces are fans around their last corner;
// a face that is not has been cut into triangles.
std::string export_obj(const Scene& scene);
inline constexpr std::string_view exported_obj_begin = "# Exported by Shadebench";  // how each begins

// Any of them as text, for the clipboard. A GLUT program reads "scene.obj".
std::string export_text(const Scene& scene, ExportFormat format, Language language = Language::english);

// Any of them as a file, whole or not at all; of a GLUT program, which is named .c, the OBJ is written beside it first.
// Throws InputError where the file's name does not end as it must (it says how), where the OBJ beside it would replace
// a file that was not exported, or where it cannot be written.
void save_export(const Scene& scene, ExportFormat format, const std::filesystem::path& file,
                 Language language = Language::english);

// The format that a file's name asks for: .json, .c or .obj.
std::optional<ExportFormat> export_format_of(const std::filesystem::path& file);

}  // namespace cg
