// What was odd in a text that was read all the same: where, and why.
#pragma once
#include <string>
#include <vector>

#include "params/words.h"

namespace cg {

struct Complaint {
  long line = 0;  // 1-based; 0: the text as a whole
  Text text;      // a phrase without a full stop
  friend bool operator==(const Complaint&, const Complaint&) = default;
};

// Complaints in the order in which they came up, each once, at most `most`; one more then says that there are more.
class Complaints {
 public:
  static constexpr std::size_t most = 200;
  void add(long line, Text text);
  // By line; those of one line in the order in which they came up.
  std::vector<Complaint> take();

 private:
  std::vector<Complaint> all_;
};

}  // namespace cg
