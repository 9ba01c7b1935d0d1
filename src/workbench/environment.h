// What the environment says: the user's language, and the folders of the XDG Base Directory Specification.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "params/words.h"

namespace cg {

// Japanese where the first of LC_ALL, LC_MESSAGES and LANG that is not empty begins with "ja"; else English.
Language language_of_environment();

// XDG_CONFIG_HOME, XDG_STATE_HOME, XDG_CACHE_HOME, each with /shadebench; nothing where neither it nor HOME names an
// absolute path. The folders may not exist yet.
std::optional<std::filesystem::path> config_folder();
std::optional<std::filesystem::path> state_folder();
std::optional<std::filesystem::path> cache_folder();
std::optional<std::filesystem::path> data_home_folder();  // XDG_DATA_HOME: lessons of one's own

// What a person types as a file: "~/" is the home folder.
std::filesystem::path typed_path(std::string_view text);
// As a person finds it again: absolute, the home folder as "~".
std::string shown_path(const std::filesystem::path& file);

}  // namespace cg
