#include "tests/fuzz/fuzz_reader.h"
#include "workbench/lesson_json.h"
#include "workbench/lesson_text.h"

// JSON begins with a brace; all else is a text. What was read can be filled in and asked for its numbers.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return cg::fuzz(data, size, [](std::string_view bytes) {
    if (bytes.starts_with('{')) {
      cg::require(!cg::parse_lesson_json(bytes, "fuzz.json").empty());
      return;
    }
    const cg::LessonText text = cg::parse_lesson_text(bytes, "fuzz.md");
    cg::require(!text.sections.empty());
    for (const cg::TextSection& section : text.sections) {
      const auto filled = cg::filled(section.blocks, [](std::string_view) { return std::string("1"); });
      cg::require(cg::numbers_in(filled).empty() && filled.size() == section.blocks.size());
    }
  });
}
