// Undo and redo as a stack of values. A drag is one step, however many values it went through.
#pragma once
#include <cassert>
#include <cstddef>
#include <deque>
#include <string>
#include <utility>

namespace cg {

template <class Value>
class History {
 public:
  // `limit` >= 1: how many steps back are kept; the oldest are forgotten.
  explicit History(Value start, std::size_t limit = 500) : now_(std::move(start)), limit_(limit) { assert(limit >= 1); }

  const Value& now() const { return now_; }
  bool can_undo() const { return !before_.empty(); }
  bool can_redo() const { return !after_.empty(); }

  // The value is now this. Where `gesture` is not empty and that of the last change (the path that a slider edits,
  // while the mouse is down), the two are one step. Nothing happens where the value is the same.
  void change(Value value, const std::string& gesture = {}) {
    if (value == now_) return;
    if (gesture.empty() || gesture != gesture_ || before_.empty()) {
      before_.push_back(std::move(now_));
      if (before_.size() > limit_) before_.pop_front();
    }
    now_ = std::move(value);
    gesture_ = gesture;
    after_.clear();
    // A drag that came back to where it began is no step.
    if (now_ == before_.back()) before_.pop_back(), gesture_.clear();
  }
  // The mouse is up: the next change is a step of its own.
  void end_gesture() { gesture_.clear(); }

  // Each returns now(); without a step to go they change nothing.
  const Value& undo() { return move(before_, after_); }
  const Value& redo() { return move(after_, before_); }

  // Forgets all steps: another scene was opened.
  void restart(Value value) { *this = History(std::move(value), limit_); }

 private:
  const Value& move(std::deque<Value>& from, std::deque<Value>& to) {
    end_gesture();
    if (from.empty()) return now_;
    to.push_back(std::exchange(now_, std::move(from.back())));
    from.pop_back();
    return now_;
  }

  Value now_;
  std::size_t limit_;
  std::deque<Value> before_, after_;
  std::string gesture_;
};

}  // namespace cg
