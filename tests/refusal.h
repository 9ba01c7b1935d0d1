// What a user would be told.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "params/input_error.h"

namespace cg {

// The English message of the InputError that f throws, which has both languages and one line each; empty where it
// throws none.
template <class F>
std::string refusal_of(const F& f) {
  try {
    f();
  } catch (const InputError& e) {
    EXPECT_FALSE(e.found.ja.empty());
    EXPECT_EQ(e.accepted.en.empty(), e.accepted.ja.empty());
    for (const Language language : {Language::english, Language::japanese})
      EXPECT_EQ(e.message(language).find('\n'), std::string::npos) << e.message(language);
    return e.message(Language::english);
  }
  return "";
}

}  // namespace cg
