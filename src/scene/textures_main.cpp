// shadebench-textures FOLDER: writes the files of textures/ into the folder.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "image/image_file.h"
#include "params/file.h"
#include "params/input_error.h"
#include "scene/bundled_textures.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "shadebench-textures: one folder to write the textures into\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    const auto textures = cg::bundled_textures_made();
    for (const cg::BundledTexture& t : textures)
      t.alpha ? cg::write_image_with_alpha(folder / t.name, t.picture) : cg::write_image(folder / t.name, t.picture);
    cg::save_file(folder / "SOURCES.md", cg::texture_sources(textures));
  } catch (const cg::InputError& e) {
    std::fprintf(stderr, "%s\n", e.message(cg::Language::english).c_str());
    return 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "shadebench-textures: %s\n", e.what());
    return 2;
  }
}
