// A trade held against an earlier run of it: the errors must be the same bits, and each median time should lie within
// the spread that the earlier run states.
#pragma once
#include "measure/trade.h"

namespace cg {

struct Repetition {
  struct Outlier {
    std::string id;  // of the setting
    double ms = 0;   // the median now
    Spread earlier;
  };
  std::size_t settings = 0;
  std::size_t same_errors = 0;     // settings whose errors are the same bits
  std::vector<std::string> other;  // settings whose errors are not
  std::vector<Outlier> outliers;   // settings whose time is outside the earlier spread
};

// Throws InputError that names the file where it holds no trade, or one of another knob or scene.
void check_same_trade(const Tree& earlier, const Knob& knob, const std::string& scene, const std::string& file);

// `earlier` is what json_of(Trade) gave. Throws InputError where it has other settings, or another size.
Repetition hold_against(const Trade& now, const Tree& earlier, const std::string& file);

Tree json_of(const Repetition& repetition);
std::string text_of(const Repetition& repetition, Language language);

}  // namespace cg
