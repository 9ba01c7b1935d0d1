#include "workbench/c_memory.h"

#include "scene/text_scanner.h"

namespace cg {

int CMemory::reason(const Text& text) {
  const auto [at, added] = reason_index_.try_emplace(text.en, int(reasons_.size()));
  if (added) reasons_.push_back(text);
  return at->second;
}

const Text& CMemory::reason_text(int reason) const {
  static const Text none{"its value is not known", "値が分からない"};
  return reason >= 0 ? reasons_[std::size_t(reason)] : none;
}

CValue CMemory::unknown_result(std::string_view function) {
  const auto [at, added] = result_reasons_.try_emplace(function, -1);
  if (added)
    at->second = reason(
        phrase({"the result of {0} is known only to the running program", "{0} の結果は実行しなければ分からない"},
               {{readable(function), readable(function)}}));
  return {CValue::unknown, false, at->second, 0, {}, {}};
}

int CMemory::declare(std::string_view name, bool integer, std::vector<std::size_t> lengths, const CValue& value) {
  std::size_t cells = 1;
  for (const std::size_t length : lengths) {
    if (length > most_cells) return -1;
    cells *= length;
    if (cells > most_cells) return -1;
  }
  if (cells_ + cells > most_cells) return -1;
  cells_ += cells;
  variables_.push_back({name, integer, std::move(lengths), std::vector<CValue>(cells, value)});
  const int index = int(variables_.size()) - 1;
  bind(name, index);
  return index;
}

void CMemory::bind(std::string_view name, int variable) { scopes_.back()[name] = variable; }

int CMemory::find(std::string_view name) const {
  for (std::size_t i = scopes_.size(); i > 0; --i) {
    if (i - 1 < function_ && i > 1) continue;
    if (const auto at = scopes_[i - 1].find(name); at != scopes_[i - 1].end()) return at->second;
  }
  return -1;
}

int CMemory::find_global(std::string_view name) const {
  const auto at = scopes_[0].find(name);
  return at == scopes_[0].end() ? -1 : at->second;
}

std::size_t CMemory::enter_function() {
  const std::size_t before = function_;
  function_ = scopes_.size();
  scopes_.emplace_back();
  return before;
}

void CMemory::leave_function(std::size_t before) {
  scopes_.resize(function_);
  function_ = before;
}

CValue* CMemory::cell(const CAddress& a) {
  if (a.variable < 0) return nullptr;
  CVariable& v = variable(a.variable);
  return std::size_t(a.level) >= v.lengths.size() && a.offset < v.cells.size() ? &v.cells[a.offset] : nullptr;
}

std::size_t CMemory::stride(const CAddress& a) const {
  const std::vector<std::size_t>& lengths = variables_[std::size_t(a.variable)].lengths;
  std::size_t cells = 1;
  for (std::size_t i = std::size_t(a.level); i < lengths.size(); ++i) cells *= lengths[i];
  return cells;
}

CValue CMemory::load(const CAddress& a) {
  const CVariable& v = variable(a.variable);
  if (std::size_t(a.level) < v.lengths.size()) {
    CValue first;
    first.address = {a.variable, a.offset, a.level + 1};
    return first;
  }
  if (const CValue* value = cell(a)) return *value;
  return unknown(
      {"the array '" + std::string(v.name) + "' is shorter", "配列「" + std::string(v.name) + "」の範囲の外を読む"});
}

std::vector<CValue> CMemory::read(const CAddress& a, std::size_t n) {
  std::vector<CValue> out;
  if (a.variable < 0) return out;
  const CVariable& v = variable(a.variable);
  for (std::size_t i = a.offset; i < v.cells.size() && out.size() < n; ++i) out.push_back(v.cells[i]);
  return out;
}

void CMemory::forget(int index, const Text& why) {
  const CValue value = unknown(why);
  for (CValue& cell : variable(index).cells) cell = value;
}

void CMemory::change_later(int index, const Text& why) {
  const int because = reason(why);
  for (CValue& cell : variable(index).cells)
    if (cell.state == CValue::known) cell.state = CValue::at_start, cell.reason = because;
}

}  // namespace cg
