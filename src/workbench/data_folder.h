// Where the files stand that come with the program: models/, and later textures/ and lessons/.
#pragma once
#include <filesystem>

namespace cg {

// The environment's SHADEBENCH_DATA if it is set; else the first of these that has a models/ in it: the folder of
// the executable, share/shadebench beside its folder, the folder that the build was told. Never throws; the folder
// may be missing.
std::filesystem::path data_folder();

}  // namespace cg
