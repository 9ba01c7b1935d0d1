// One OpenGL call as C text: what the listing, the functions and the program of an export are made of.
#pragma once
#include <vector>

#include "shading/gl_calls.h"
#include "workbench/listing.h"

namespace cg {

// "float light0_position[] = { 10.0, 10.0, 10.0, 1.0 };" of a call that takes its numbers from an array.
ListingLine declaration(const GlCall& call);
// "glLightfv( GL_LIGHT0, GL_POSITION, light0_position );"
ListingLine statement(const GlCall& call);
// The notes as comments, one a line.
std::vector<ListingLine> comments(const GlCall& call, Language language);

ListingLine comment_line(std::string_view text);
ListingLine indented(ListingLine line, std::size_t columns);

}  // namespace cg
