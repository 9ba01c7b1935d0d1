#include "workbench/export.h"

#include <algorithm>

#include "params/file.h"
#include "params/input_error.h"
#include "shading/gl_calls.h"
#include "workbench/preset.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

bool ends_in(const fs::path& file, std::string_view extension) {
  std::string own = file.extension().string();
  std::transform(own.begin(), own.end(), own.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return own == extension;
}

void require_extension(const fs::path& file, const std::string& extension) {
  if (ends_in(file, extension)) return;
  const std::string example = file.stem().string() + extension;
  throw InputError(file.string(),
                   {"this export is a file that ends in " + extension,
                    "この書き出しのファイル名は " + extension + " で終わる必要がある"},
                   {example + " would work", example + " なら書き出せる"});
}

// A program's textures would be files beside it.
void refuse_textures(const Scene& scene, const std::string& where) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].visible && !fixed_function_layers(scene, int(i)).empty())
      throw InputError(where, {"a scene with textures has no C export", "テクスチャのあるシーンは C に書き出せない"},
                       {"without its layers, or as JSON, it would work", "レイヤーを外すか、JSON なら書き出せる"});
}

// The OBJ of a GLUT program may replace an older one, but not a model that the user has.
void refuse_to_replace(const fs::path& obj) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(obj, error))) return;
  if (fs::is_regular_file(obj, error) && read_file(obj).starts_with(exported_obj_begin)) return;
  throw InputError(obj.string(),
                   {"is there already and was not exported by Shadebench: the program's meshes would replace it",
                    "既にあるファイルで、Shadebench が書き出したものではない：メッシュで上書きしてしまう"},
                   {"another name for the .c file would work", ".c のファイルを別の名前にすれば書き出せる"});
}

}  // namespace

std::optional<ExportFormat> export_format_of(const fs::path& file) {
  if (ends_in(file, ".json")) return ExportFormat::json;
  if (ends_in(file, ".c")) return ExportFormat::c;
  if (ends_in(file, ".obj")) return ExportFormat::obj;
  return std::nullopt;
}

std::string export_text(const Scene& scene, ExportFormat format, Language language) {
  switch (format) {
    case ExportFormat::json:
      return to_json(preset_of(scene)) + "\n";
    case ExportFormat::c:
      refuse_textures(scene, "C");
      return export_c(scene, language);
    case ExportFormat::glut:
      refuse_textures(scene, "C");
      return export_glut(scene, "scene.obj", language);
    case ExportFormat::obj:
      return export_obj(scene);
  }
  return "";
}

void save_export(const Scene& scene, ExportFormat format, const fs::path& file, Language language) {
  switch (format) {
    case ExportFormat::json:
      require_extension(file, ".json");
      return save_preset(scene, file);
    case ExportFormat::c:
      require_extension(file, ".c");
      refuse_textures(scene, file.string());
      return save_file(file, export_c(scene, language));
    case ExportFormat::obj:
      require_extension(file, ".obj");
      return save_file(file, export_obj(scene));
    case ExportFormat::glut:
      break;
  }
  require_extension(file, ".c");
  refuse_textures(scene, file.string());
  const fs::path obj = fs::path(file).replace_extension(".obj");
  refuse_to_replace(obj);
  const std::string text = export_glut(scene, obj.filename().string(), language);
  save_file(obj, export_obj(scene));
  save_file(file, text);
}

}  // namespace cg
