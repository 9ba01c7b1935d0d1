// The values of a PLY body one after another, from text or from bytes, with the same functions.
#pragma once
#include <algorithm>
#include <bit>
#include <cstring>

#include "scene/ply_header.h"

namespace cg {

// A body in text: one line for each of an element.
class PlyText {
 public:
  explicit PlyText(TextScanner& in) : in_(in) {}

  void begin(const PlyElement& element, std::uint64_t i) {
    if (in_.next_line()) return;
    in_.fail(phrase({"the file ends after {0} of {1} {2}", "{2}{1}個のうち{0}個で終わっている"},
                    {text_of(i), text_of(element.count), in_quotes(element.name)}));
  }
  void end() {
    in_.expect_end({"one element a line, with the values of the header", "1 行に 1 要素、値の数はヘッダーのとおり"});
  }
  double number(PlyType, const Words& what) { return in_.number(what); }
  std::int64_t integer(PlyType, const Words& what) { return in_.integer(what); }
  void skip(PlyType) {
    if (in_.word().empty())
      fail({"the line has too few values", "行の値が足りない"},
           {"as many as the header has", "ヘッダーと同じ数が必要"});
  }
  void expect_end() {
    if (in_.next_line()) fail({"more lines than the header announces", "ヘッダーの個数より多くの行がある"});
  }
  [[noreturn]] void fail(Text found, Text accepted = {}) const { in_.fail(std::move(found), std::move(accepted)); }

 private:
  TextScanner& in_;
};

// A body in bytes, in either order.
class PlyBytes {
 public:
  PlyBytes(std::string_view bytes, const PlyHeader& header, const std::string& where)
      : bytes_(bytes),
        where_(where),
        at_(header.body),
        last_(header.body),
        swap_((header.format == PlyFormat::binary_big_endian) == (std::endian::native == std::endian::little)) {}

  void begin(const PlyElement& element, std::uint64_t i) { element_ = &element, number_ = i; }
  void end() {}
  double number(PlyType type, const Words& what) {
    const double value = load(type);
    if (value - value != 0)
      fail(phrase({"{0} of {1} number {2} is not finite", "{1}の{2}番目: {0}が有限の数ではない"},
                  {what, in_quotes(element_->name), text_of(number_)}),
           {"a finite number is expected", "有限の数が必要"});
    return value;
  }
  std::int64_t integer(PlyType type, const Words&) { return std::int64_t(load(type)); }
  void skip(PlyType type) { advance(size_of(type)); }
  std::uint64_t bytes_left() const { return bytes_.size() - at_; }
  void expect_end() {
    last_ = at_;
    if (bytes_.substr(at_).find_first_not_of("\r\n") != bytes_.npos)
      fail(phrase({"{0} bytes more than the header announces", "ヘッダーの個数より {0} バイト多い"},
                  {text_of(bytes_left())}));
  }
  [[noreturn]] void fail(Text found, Text accepted = {}) const {
    throw InputError(where_, std::move(found), std::move(accepted), 0, static_cast<long long>(last_));
  }

 private:
  void advance(std::size_t n) {
    last_ = at_;
    if (bytes_left() < n)
      fail(phrase({"the file ends in {0} number {1} of {2}", "{0}{2}個のうち{1}番目の途中で終わっている"},
                  {in_quotes(element_->name), text_of(number_), text_of(element_->count)}));
    at_ += n;
  }
  template <class T>
  double load_as() {
    advance(sizeof(T));
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data() + last_, sizeof(T));
    if (swap_) std::reverse(raw, raw + sizeof(T));
    return double(std::bit_cast<T>(raw));
  }
  // Every type's values are whole in a double.
  double load(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return load_as<std::int8_t>();
      case PlyType::uint8:
        return load_as<std::uint8_t>();
      case PlyType::int16:
        return load_as<std::int16_t>();
      case PlyType::uint16:
        return load_as<std::uint16_t>();
      case PlyType::int32:
        return load_as<std::int32_t>();
      case PlyType::uint32:
        return load_as<std::uint32_t>();
      case PlyType::float32:
        return load_as<float>();
      case PlyType::float64:
        return load_as<double>();
    }
    return 0;
  }

  std::string_view bytes_;
  const std::string& where_;
  std::size_t at_, last_;  // of the next value and of the one read last
  bool swap_;
  const PlyElement* element_ = nullptr;
  std::uint64_t number_ = 0;
};

}  // namespace cg
