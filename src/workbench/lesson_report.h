// A lesson's texts with every number in its place, to be read, printed or handed out without the program.
#pragma once
#include <filesystem>
#include <span>

#include "scene/technique.h"

namespace cg {

// Writes NAME.en.md and NAME.ja.md of the lesson in `folder` into `into`, which is made where it is missing. Numbers
// are computed for each step's own scene. Throws InputError and Cancelled.
void write_lesson_report(const std::filesystem::path& folder, const std::filesystem::path& into,
                         std::span<const Technique> techniques, Progress& progress);

}  // namespace cg
