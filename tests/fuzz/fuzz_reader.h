// What every fuzzed reader must hold: bytes come to a model whose numbers agree with each other, or to one InputError
// that fits on a line and says where. Anything else (another exception, a sanitizer's report, a hang) is a finding.
#pragma once
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "scene/model_file.h"

namespace cg {

inline void require(bool holds) {
  if (!holds) std::abort();
}

// One line in both languages, which begins with where.
inline void check_line(const InputError& e) {
  for (Language language : {Language::english, Language::japanese}) {
    const std::string message = e.message(language);
    require(message.size() > e.where.size() && message.size() < 1000);
    require(message.starts_with(e.where) && message.find('\n') == message.npos);
  }
}

inline void check_message(const InputError& e) {
  require(e.line > 0 || e.byte >= 0);
  check_line(e);
}

inline void check_model(const Model& model) {
  require(!model.parts.empty());
  for (const ModelPart& part : model.parts) {
    require(part.mesh != nullptr && part.mesh->data().face_count() > 0);
    require(model.parts.size() == 1 || !part.name.empty());
    for (const Triangle& t : part.mesh->triangles())
      for (std::uint32_t corner : t.corner) require(corner < part.mesh->data().corners.size());
  }
  for (const Text& note : model.notes) require(!note.en.empty() && !note.ja.empty());
}

// One execution: `read` takes the bytes as a string_view.
template <class Read>
int fuzz(const std::uint8_t* data, std::size_t size, Read read) {
  try {
    read(std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const InputError& e) {
    check_message(e);
  }
  return 0;
}

}  // namespace cg
