// Whole files in and out: the one place that opens what a user named, and the one way anything is saved.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "params/words.h"

namespace cg {

// The bytes of a regular file of at most `max_bytes`. Throws InputError that names the file where it is missing, a
// folder, a pipe or a device, may not be read, is larger or does not fit into memory.
std::string read_file(const std::filesystem::path& file, std::size_t max_bytes = std::size_t(1) << 30);

// Replaces `file` by `bytes`: written beside it, flushed to the disk, then renamed, so that after any fault the file is
// either the old or the new one, complete. A symbolic link stays one; an existing file keeps its permissions. Throws
// InputError that names the file and the reason (disk full, read-only, no such folder); the old file is intact then.
void save_file(const std::filesystem::path& file, std::string_view bytes);

// What an errno means to a user.
Text system_text(int error);

}  // namespace cg
