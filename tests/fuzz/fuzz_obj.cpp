#include "tests/fuzz/fuzz_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const cg::MtlLoader load = [](std::string_view, std::vector<cg::Text>& notes) {
    return cg::read_mtl("newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n", "fuzz.mtl", notes);
  };
  return cg::fuzz(data, size, [&](std::string_view bytes) { cg::check_model(cg::read_obj(bytes, "fuzz.obj", load)); });
}
