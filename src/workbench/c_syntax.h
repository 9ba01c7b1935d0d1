// The syntax tree of a C program, as far as a course's programs need it (ISO/IEC 9899:1990, 6.3 to 6.7). Names and
// texts point into the source.
#pragma once
#include <string_view>
#include <vector>

#include "workbench/c_tokens.h"

namespace cg {

struct CExpression {
  enum Kind {
    number,       // value, integer
    text,         // a string
    variable,     // name
    unary,        // op, 1 operand: + - ! ~ * & ++ --
    postfix,      // op, 1 operand: ++ --
    binary,       // op, 2 operands, also the comma
    conditional,  // 3 operands
    assign,       // op, 2 operands: = += -= ...
    index,        // 2 operands
    call,         // the function, then its arguments
    member,       // op (. or ->), name, 1 operand
    cast,         // integer, 1 operand; of a compound literal the operand is a list
    list          // { ... }
  };
  Kind kind = number;
  long line = 0;
  std::string_view op, name;
  double value = 0;
  bool integer = false;
  int height = 1;  // of the tree below, this included
  std::vector<CExpression> operands;
};

struct CDeclaration {
  long line = 0;
  std::string_view name;
  bool integer = false;  // int, char, GLint, ...: numbers are cut
  bool known = true;     // false: of a struct or another type that holds no number
  bool pointer = false;
  bool is_static = false;
  bool is_extern = false;
  bool is_parameter = false;         // an array then is a pointer
  std::vector<CExpression> lengths;  // of an array, one each dimension; of [] an empty list
  std::vector<CExpression> initial;  // one, or none
};

struct CStatement {
  enum Kind {
    empty,
    expression,   // expressions[0]
    declaration,  // declarations
    block,        // body
    branch,       // if: expressions[0], body[0], body[1] if there is an else
    loop,         // for: expressions[0..2], each perhaps an empty list; body[0]; body[1] what stands first, if any
    do_loop,      // expressions[0], body[0]
    choice,       // switch: expressions[0], body[0]
    label,        // case: expressions[0]; default: none
    break_,
    continue_,
    return_  // expressions[0], or none
  };
  Kind kind = empty;
  long line = 0;
  std::vector<CExpression> expressions;
  std::vector<CDeclaration> declarations;
  std::vector<CStatement> body;
};

struct CRoutine {
  long line = 0;
  std::string_view name;
  std::vector<CDeclaration> parameters;
  CStatement body;  // a block
};

struct CProgram {
  std::vector<CRoutine> routines;
  std::vector<CStatement> top;  // declarations, and statements outside functions, as in a part of a program
  long last_line = 1;
};

// What cannot be read is a complaint with its line and is left out, up to the next semicolon or brace.
CProgram parse_c(const CTokens& tokens, Complaints& complaints);

}  // namespace cg
