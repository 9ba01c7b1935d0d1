#include "workbench/environment.h"

#include <cstdlib>
#include <string_view>

namespace cg {

namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

std::optional<std::filesystem::path> xdg_folder(const char* name, const char* below_home) {
  // The specification: a relative path is to be ignored.
  if (const std::filesystem::path named = variable(name); named.is_absolute()) return named / "shadebench";
  if (const std::filesystem::path home = variable("HOME"); home.is_absolute()) return home / below_home / "shadebench";
  return std::nullopt;
}

}  // namespace

Language language_of_environment() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
    if (const std::string_view value = variable(name); !value.empty())
      return value.starts_with("ja") ? Language::japanese : Language::english;
  return Language::english;
}

std::optional<std::filesystem::path> config_folder() { return xdg_folder("XDG_CONFIG_HOME", ".config"); }
std::optional<std::filesystem::path> state_folder() { return xdg_folder("XDG_STATE_HOME", ".local/state"); }
std::optional<std::filesystem::path> data_home_folder() { return xdg_folder("XDG_DATA_HOME", ".local/share"); }
std::optional<std::filesystem::path> cache_folder() { return xdg_folder("XDG_CACHE_HOME", ".cache"); }

}  // namespace cg
