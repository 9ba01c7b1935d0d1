#include "scene/model_file.h"

#include <algorithm>

#include "params/file.h"
#include "scene/text_scanner.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_model_bytes = std::size_t(1) << 30, max_mtl_bytes = std::size_t(1) << 24;

std::string extension_of(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return extension;
}

// The extension that would fit the first bytes; empty where nothing is recognised.
std::string extension_from(std::string_view bytes) {
  const std::string_view first = bytes.substr(0, std::min(bytes.find_first_of(" \t\r\n"), std::size_t(16)));
  if (first == "ply") return ".ply";
  if (first == "solid") return ".stl";
  if (first.ends_with("OFF")) return ".off";
  if (first == "v" || first == "mtllib" || first == "o" || first == "g") return ".obj";
  return "";
}

// The file that `name` means, in `folder` or below it; empty where it leads out of it or is not there.
fs::path file_inside(const fs::path& folder, std::string_view name) {
  std::string portable(name);
  std::replace(portable.begin(), portable.end(), '\\', '/');
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error || fs::path(portable).is_absolute() || portable.find('\0') != portable.npos) return {};
  const fs::path file = fs::canonical(root / portable, error);
  if (error || std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first != root.end()) return {};
  return fs::is_regular_file(file, error) ? file : fs::path();
}

// The rest of an mtllib line is one name with spaces in it or, where there is no such file, several names.
Materials load_materials(const fs::path& folder, std::string_view names, std::vector<Text>& notes) {
  Materials all;
  const auto load = [&](std::string_view name) {
    const fs::path file = file_inside(folder, name);
    if (file.empty()) return false;
    const std::string where = readable(file.filename().string());
    try {
      all.merge(read_mtl(read_file(file, max_mtl_bytes), where, notes));
    } catch (const InputError& e) {
      notes.push_back(phrase({"materials are left out: {0}", "素材を省いた: {0}"},
                             {{e.message(Language::english), e.message(Language::japanese)}}));
    }
    return true;
  };
  if (load(names)) return all;
  TextScanner words(names, "", {});
  words.next_line();
  for (std::string_view name = words.word(); !name.empty(); name = words.word())
    if (!load(name))
      notes.push_back(phrase(
          {"the material file {0} is not in the model's folder", "マテリアルファイル{0}がモデルのフォルダーにない"},
          {in_quotes(name)}));
  return all;
}

// Says what is odd about the meshes that were made.
void note_odd_faces(Model& model) {
  MeshReport all;
  std::size_t faces = 0;
  for (const ModelPart& part : model.parts) {
    const MeshReport& one = part.mesh->report();
    faces += part.mesh->data().face_count();
    all.degenerate_faces += one.degenerate_faces;
    all.repeated_corners += one.repeated_corners;
    all.bad_normals += one.bad_normals;
  }
  const auto note = [&](std::size_t n, const Words& words) {
    if (n > 0) model.notes.push_back(phrase(words, {text_of(n), text_of(faces)}));
  };
  note(all.degenerate_faces,
       {"{0} of {1} faces have no area: nothing of them is drawn", "面{1}個のうち{0}個は面積がなく、何も描かれない"});
  note(all.repeated_corners, {"corners that repeat the vertex before them, taken once: {0}",
                              "直前と同じ頂点を使う角が{0}個ある。1 つとして扱う"});
  note(all.bad_normals, {"normals without a length: {0}", "長さのない法線が{0}個ある"});
}

// `where` is the file's name in messages.
Model read_known(const fs::path& file, const std::string& where, const std::string& bytes) {
  std::string extension = extension_of(file);
  if (extension != ".obj" && extension != ".ply" && extension != ".off" && extension != ".stl")
    extension = extension_from(bytes);
  if (extension == ".ply") return read_ply(bytes, where);
  if (extension == ".off") return read_off(bytes, where);
  if (extension == ".stl") return read_stl(bytes, where);
  if (extension == ".obj")
    return read_obj(bytes, where, [&](std::string_view name, std::vector<Text>& notes) {
      return load_materials(file.parent_path().empty() ? "." : file.parent_path(), name, notes);
    });
  throw InputError(where, {"not a model file that is known", "知らない種類のモデルファイル"},
                   {"OBJ, PLY, OFF and STL are read", "OBJ, PLY, OFF, STL なら読める"}, 0, 0);
}

}  // namespace

Model read_model(const fs::path& file) {
  Model model = read_known(file, readable(file.string()), read_file(file, max_model_bytes));
  note_odd_faces(model);
  return model;
}

}  // namespace cg
