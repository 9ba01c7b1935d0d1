#include "workbench/data_folder.h"

#include <cstdlib>
#include <system_error>

namespace cg {

std::filesystem::path data_folder() {
  namespace fs = std::filesystem;
  if (const char* named = std::getenv("SHADEBENCH_DATA"); named && *named) return named;
  std::error_code none;
  const fs::path beside = fs::read_symlink("/proc/self/exe", none).parent_path();
  const fs::path built = SHADEBENCH_DATA;
  for (const fs::path& folder : {beside, beside.parent_path() / "share" / "shadebench", built})
    if (!folder.empty() && fs::is_directory(folder / "models", none)) return folder;
  return built;
}

}  // namespace cg
