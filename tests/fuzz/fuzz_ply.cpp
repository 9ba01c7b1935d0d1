#include "tests/fuzz/fuzz_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return cg::fuzz(data, size, [](std::string_view bytes) { cg::check_model(cg::read_ply(bytes, "fuzz.ply")); });
}
