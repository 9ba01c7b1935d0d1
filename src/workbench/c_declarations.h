// Types and declarators of C (ISO/IEC 9899:1990, 6.5): of a type only whether its values are numbers, and whole ones.
#pragma once
#include <map>
#include <utility>

#include "workbench/c_expressions.h"

namespace cg {

struct CType {
  bool integer = false, known = true, is_static = false, is_extern = false, is_typedef = false;
};

class CDeclarations {
 public:
  explicit CDeclarations(CCursor& cursor) : c_(cursor) {}

  // Two names, or a name and a *: the first must be a type that we do not know.
  bool at_declaration() const;
  // The words of a type; structures are skipped, the constants of an enumeration kept for enumerations().
  CType type();
  // * name [ n ] ..., of the type.
  CDeclaration declarator(const CType& type);
  void name_type(const CDeclaration& declaration, CType type);  // typedef
  // Behind a ), from the ( on.
  void skip_parentheses();
  // The enumerations since the last call, as declarations.
  std::vector<CStatement> enumerations() { return std::exchange(enums_, {}); }

 private:
  void compound(bool is_enum);
  void enumerators(long line);
  CDeclaration function_pointer(CDeclaration d);

  CCursor& c_;
  std::map<std::string_view, CType> typedefs_;
  std::vector<CStatement> enums_;
};

}  // namespace cg
