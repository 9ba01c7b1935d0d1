// OpenGL's errors as exceptions.
#pragma once

namespace cg {

// Throws InputError where OpenGL ran out of memory, and std::logic_error naming `where` and the error's token for
// any other error: those are ours.
void check_gl(const char* where);

}  // namespace cg
