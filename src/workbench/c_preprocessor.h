// The directives of the C preprocessor on tokens: #define and #undef, #if and its relatives.
#pragma once
#include "workbench/c_tokens.h"

namespace cg {

// Tokens in logical lines: line k is tokens[starts[k]] up to tokens[starts[k + 1]]; the last start is the end.
struct CLines {
  std::vector<CToken> tokens;
  std::vector<std::size_t> starts{0};
  std::vector<CComment> comments;
};

// All tokens with the directives carried out and the macros replaced, and `end` behind them.
std::vector<CToken> preprocess(const CLines& lines, Complaints& complaints);

}  // namespace cg
