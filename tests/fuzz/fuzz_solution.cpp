#include "radiosity/solution_file.h"
#include "tests/fuzz/fuzz_reader.h"
#include "tests/fuzz/solution_forgery.h"

// As it is, and with the right size and checksum: a solution whose lists fit together, and which can be drawn and
// written again, or one line that says why not.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const cg::Scene scene = cg::testing::forged_scene();
  const auto read = [](std::string_view bytes) {
    cg::Progress progress;
    try {
      const cg::SolutionHandle s = cg::solution_of(bytes, "fuzz.ply", scene, progress);
      cg::require(s->radiosity.size() == s->patches->patches.size());
      cg::require(s->element_radiosity.size() == s->patches->elements.size());
      if (bytes.size() % 8 != 0) return;  // what follows takes longer than the reading
      cg::require(cg::drawable(scene, *s)->objects.size() == scene.objects.size());
      const std::string again = cg::solution_bytes(*s);
      cg::require(cg::solution_bytes(*cg::solution_of(again, "again.ply", scene, progress)) == again);
    } catch (const cg::InputError& e) {
      cg::check_line(e);
    }
  };
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  read(bytes);
  read(cg::testing::signed_anew(bytes));
  return 0;
}
