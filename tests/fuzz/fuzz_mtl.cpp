#include "params/slots.h"
#include "tests/fuzz/fuzz_reader.h"

// Besides: every value must be one that the material's description accepts.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return cg::fuzz(data, size, [](std::string_view bytes) {
    std::vector<cg::Text> notes;
    cg::Materials materials = cg::read_mtl(bytes, "fuzz.mtl", notes);
    for (auto& [name, material] : materials)
      for (const cg::Slot& slot : cg::slots(material)) cg::assign(slot, cg::slot_tree(slot));
  });
}
