#include "workbench/export_command.h"

#include "workbench/command_parts.h"
#include "workbench/export.h"

namespace cg {

namespace {

std::string known_formats() {
  std::string names;
  for (const Name& name : names_of<ExportFormat>) names += (names.empty() ? "" : ", ") + std::string(name.id);
  return names;
}

// What --as names, or else what the file's name asks for.
ExportFormat format_for(const Arguments& a) {
  for (std::size_t i = 0; i < names_of<ExportFormat>.size(); ++i)
    if (names_of<ExportFormat>[i].id == a.format) return ExportFormat(i);
  const Text known{"known are: " + known_formats(), "使えるのは " + known_formats() + " です"};
  if (!a.format.empty()) throw bad_option("--as", a.format, known);
  if (const auto format = export_format_of(a.output)) return *format;
  throw InputError("--as", {"no format is named", "形式の指定がありません"}, known);
}

}  // namespace

int run_export(const Arguments& a, std::span<const Technique>, Language language) {
  if (a.output.empty())
    throw InputError("-o", {"no file is named", "保存先の指定がありません"},
                     {"name one: -o scene.c", "-o scene.c のように指定してください"});
  const ExportFormat format = format_for(a);
  save_export(scene_for(a, language), format, a.output, language);
  return 0;
}

}  // namespace cg
