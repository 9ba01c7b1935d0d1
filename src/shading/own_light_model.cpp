#include "shading/own_light_model.h"

#include <stdexcept>

#include "embedded_c.h"

namespace cg {

namespace {

struct Condition {
  std::string_view macro, mistake;
  bool on;
};

}  // namespace

std::vector<SourceLine> own_light_model(const Mistakes& mistakes) {
  const Condition conditions[] = {{"NO_GATE", "no_gate", mistakes.no_gate},
                                  {"LONG_LIGHT_VECTOR", "long_light_vector", mistakes.long_light_vector}};
  std::vector<SourceLine> lines;
  const Condition* inside = nullptr;  // what the current lines depend on
  bool right = true;                  // whether they are those without the mistake
  std::string_view text = own_light_model_c;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.starts_with("#ifndef ")) {
      for (const Condition& c : conditions)
        if (line.substr(8) == c.macro) inside = &c, right = true;
      if (!inside) throw std::logic_error("own_light_model.c: " + std::string(line));
    } else if (line == "#else") {
      right = false;
    } else if (line == "#endif") {
      inside = nullptr;
    } else if (!inside) {
      lines.push_back({std::string(line)});
    } else if (inside->on) {
      lines.push_back({std::string(line), inside->mistake, right});
    } else if (right) {
      lines.push_back({std::string(line)});
    }
  }
  return lines;
}

}  // namespace cg
