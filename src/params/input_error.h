// The one exception for a mistake in what a user gave us: a file, a preset, an option.
// It says where, what was found and what would have been accepted, in both languages.
#pragma once
#include <stdexcept>
#include <string>

#include "params/words.h"

namespace cg {

class InputError : public std::runtime_error {
 public:
  // `where` is the file's name, or the option or key; `line` is 1-based, 0 if it has none; `byte` is the
  // offset in a binary file, -1 if it has none. `found` and `accepted` are phrases without a full stop.
  InputError(std::string where, Text found, Text accepted = {}, long line = 0, long long byte = -1);

  // One line without a line break: "teapot.obj:12: found; accepted".
  std::string message(Language language) const;

  std::string where;
  Text found, accepted;
  long line = 0;
  long long byte = -1;
};

}  // namespace cg
