// shadebench-models FOLDER: writes the files of models/ into the folder.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "params/file.h"
#include "params/input_error.h"
#include "scene/bundled_models.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "shadebench-models: one folder to write the models into\n");
    return 2;
  }
  try {
    for (const cg::BundledFile& file : cg::bundled_models())
      cg::save_file(std::filesystem::path(argv[1]) / file.name, file.text);
  } catch (const cg::InputError& e) {
    std::fprintf(stderr, "%s\n", e.message(cg::Language::english).c_str());
    return 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "shadebench-models: %s\n", e.what());
    return 2;
  }
}
