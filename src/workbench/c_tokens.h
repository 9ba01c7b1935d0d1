// C source as tokens, after what the preprocessor does with it: comments, #define, #if (ISO/IEC 9899:1990, 5.1.1.2 and
// 6.1). For programs of a course: #include is skipped, and a macro with parameters is expanded only if it is simple.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "workbench/complaint.h"

namespace cg {

struct CToken {
  enum Kind { name, number, text, punctuation, end };
  Kind kind = end;
  std::string_view spelling;  // in the source, or of a macro's body there; of a number the whole pp-number
  long line = 0;              // of the source; of a macro's token, where the macro is used
  bool is(std::string_view s) const { return kind != end && kind != text && spelling == s; }
};

struct CComment {
  long line = 0;
  std::string_view text;  // between its marks, without the spaces around it
};

struct CTokens {
  std::vector<CToken> tokens;  // the last is `end`
  std::vector<CComment> comments;
};

// The spellings point into `source`, which must outlive them. What is not C is a complaint and is skipped; any bytes
// are accepted: comments and strings may be in any encoding (Shift_JIS, EUC).
CTokens c_tokens(std::string_view source, Complaints& complaints);

}  // namespace cg
