#include "workbench/complaint.h"

#include <algorithm>

namespace cg {

void Complaints::add(long line, Text text) {
  if (all_.size() > most) return;
  Complaint complaint{line, std::move(text)};
  if (std::find(all_.begin(), all_.end(), complaint) != all_.end()) return;
  if (all_.size() == most)
    complaint = {0, {"there are more complaints, which are left out here", "指摘はほかにもあるが、ここでは省く"}};
  all_.push_back(std::move(complaint));
}

std::vector<Complaint> Complaints::take() {
  std::stable_sort(all_.begin(), all_.end(), [](const Complaint& a, const Complaint& b) { return a.line < b.line; });
  return std::move(all_);
}

}  // namespace cg
