#include "workbench/import_command.h"

#include <cstdio>
#include <filesystem>

#include "params/input_error.h"
#include "workbench/import.h"
#include "workbench/model_library.h"
#include "workbench/preset.h"

namespace cg {

std::string text_of(const std::vector<Complaint>& complaints, const std::string& where, Language language) {
  std::string out;
  for (const Complaint& c : complaints)
    out += where + (c.line > 0 ? ":" + std::to_string(c.line) : "") + ": " + c.text.in(language) + "\n";
  return out;
}

int run_import(const Arguments& a, std::span<const Technique>, Language language) {
  if (a.scene.empty())
    throw InputError("FILE.c", {"no program is named", "プログラムの指定がない"},
                     {"name a C file: shadebench import main.c -o scene.json",
                      "C のファイルを指定すること：shadebench import main.c -o scene.json"});
  if (std::filesystem::path(a.output).extension() != ".json")
    throw InputError("-o",
                     a.output.empty()
                         ? Text{"no file is named", "保存先の指定がない"}
                         : Text{"\"" + a.output + "\" is not possible", "「" + a.output + "」には保存できない"},
                     {"name a preset: -o scene.json", "-o scene.json のように指定すること"});
  ImportReport report = import_file(a.scene);
  load_meshes(report.scene);
  save_preset(report.scene, a.output);
  std::fputs(text_of(report.complaints, a.scene, language).c_str(), stderr);
  return 0;
}

}  // namespace cg
