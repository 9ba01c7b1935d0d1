// The command that reads a student's program.
#pragma once
#include <span>

#include "workbench/commands.h"

namespace cg {

// FILE.c as a preset; complaints on stderr, one a line, with the line of the file.
int run_import(const Arguments& arguments, std::span<const Technique> techniques, Language language);

// The complaints as lines of text: "FILE.c:12: ...".
std::string text_of(const std::vector<struct Complaint>& complaints, const std::string& where, Language language);

}  // namespace cg
