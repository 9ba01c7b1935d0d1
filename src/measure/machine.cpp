// What the machine is called, as Linux tells it (proc(5), /proc/cpuinfo).
#include "measure/trade.h"
#include "params/file.h"
#include "params/input_error.h"

namespace cg {

std::string cpu_name() {
  constexpr std::string_view key = "model name";
  try {
    const std::string text = read_file("/proc/cpuinfo");
    const std::size_t at = text.find(key), colon = text.find(": ", at), end = text.find('\n', at);
    if (at == text.npos || colon == text.npos || end == text.npos || colon > end) return {};
    return text.substr(colon + 2, end - colon - 2);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace cg
