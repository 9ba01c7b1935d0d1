// States of a solver to come back to: the denser the younger they are, so that a step back is short and few are kept.
#pragma once
#include "radiosity/iteration.h"

namespace cg {

class SolverHistory {
 public:
  struct State {
    std::size_t step = 0;
    double seconds = 0;
    std::unique_ptr<Iteration> iteration;
  };

  // Nothing from now on.
  void close() {
    states_.clear();
    spare_.reset();
    closed_ = true;
  }

  // Forgets what is younger, and of the older what lies close together.
  void remember(std::size_t step, double seconds, const Iteration& iteration) {
    if (closed_) return;
    forget_after(step);
    if (!states_.empty() && states_.back().step == step) return;
    states_.push_back({step, seconds, copy_of(iteration)});
    bytes_ += iteration.bytes();
    thin();
  }

  // The youngest that is not younger than `step`; null: none.
  const State* nearest(std::size_t step) const {
    for (std::size_t i = states_.size(); i-- > 0;)
      if (states_[i].step <= step) return &states_[i];
    return nullptr;
  }

 private:
  static constexpr std::size_t most_bytes = std::size_t(256) << 20;

  void forget_after(std::size_t step) {
    while (!states_.empty() && states_.back().step > step) erase(states_.size() - 1);
  }

  // Three neighbours become two where they lie closer together than half of what they lie back. The oldest, the
  // beginning, stays.
  void thin() {
    const std::size_t now = states_.back().step;
    for (std::size_t i = 1; i + 1 < states_.size();) {
      const std::size_t span = states_[i + 1].step - states_[i - 1].step, age = now - states_[i + 1].step;
      span <= age / 2 ? erase(i) : void(++i);
    }
    const auto held = [&] { return bytes_ + (spare_ ? spare_->bytes() : 0); };
    while (held() > most_bytes && states_.size() > 2) erase(1);
  }

  // In the memory of the state that was forgotten last: fresh memory costs more than to copy.
  std::unique_ptr<Iteration> copy_of(const Iteration& iteration) {
    if (!spare_) return iteration.copy();
    spare_->become(iteration);
    return std::move(spare_);
  }

  void erase(std::size_t i) {
    bytes_ -= states_[i].iteration->bytes();
    spare_ = std::move(states_[i].iteration);
    states_.erase(states_.begin() + std::ptrdiff_t(i));
  }

  std::vector<State> states_;
  std::unique_ptr<Iteration> spare_;
  std::size_t bytes_ = 0;
  bool closed_ = false;
};

}  // namespace cg
