// Markdown as a flat list of blocks: what parse_lesson_text() divides into sections.
#pragma once
#include "workbench/lesson_text.h"

namespace cg {

// Headings of all levels, `level` 1 to 6. The blocks of a list stand one after the other, the deeper ones behind their
// item. Throws InputError with `where` and the line, as parse_lesson_text() does.
std::vector<TextBlock> markdown_blocks(std::string_view markdown, const std::string& where);

// "Title {#id}": takes the id off the end of the runs; empty: there is none.
std::string take_id(std::vector<TextRun>& runs);

}  // namespace cg
