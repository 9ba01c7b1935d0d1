// The scene that fuzzed solutions are of, and solutions altered and signed anew: what a checksum cannot keep out.
#pragma once
#include <string>

#include "radiosity/solution_format.h"
#include "tests/radiosity/scenes.h"

namespace cg::testing {

// A square and a triangle before it.
inline Scene forged_scene() {
  Scene scene = scene_of({object_of({rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})}, "square"),
                          object_of({{{0, 0, 1}, {0, 1, 1}, {1, 0, 1}}}, "triangle")});
  scene.material.k_d = {0.25, 0.5, 0.75};
  scene.objects[1].own_material = true;
  scene.objects[1].material.emission = {1, 0.5, 0.25};
  return scene;
}

// With the size and the checksum that the bytes have now, where their keys stand in the header.
inline std::string signed_anew(std::string bytes) {
  namespace format = solution_format;
  const auto put = [&](std::string_view key, std::uint64_t value) {
    const std::size_t at = bytes.find("\n" + std::string(key));
    if (at == bytes.npos || at + 1 + key.size() + format::digits > bytes.size()) return;
    bytes.replace(at + 1 + key.size(), format::digits, format::hexadecimal(value));
  };
  put(format::size_key, bytes.size());
  put(format::checksum_key, 0);
  put(format::checksum_key, format::checksum(bytes));
  return bytes;
}

}  // namespace cg::testing
