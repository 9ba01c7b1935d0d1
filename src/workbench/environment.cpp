#include "workbench/environment.h"

#include <cstdlib>
#include <string_view>
#include <system_error>

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

std::filesystem::path typed_path(std::string_view text) {
  const std::filesystem::path home = variable("HOME");
  return text.starts_with("~/") && home.is_absolute() ? home / text.substr(2) : std::filesystem::path(text);
}

std::string shown_path(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(file, error).lexically_normal();
  if (error) return file.string();
  const std::string home = (std::filesystem::path(variable("HOME")) / "").string(), text = whole.string();
  return home.size() > 2 && text.starts_with(home) ? "~/" + text.substr(home.size()) : text;
}

}  // namespace cg
