// Students' C: any bytes come to a scene that its description accepts, with complaints of one line each, or to one
// InputError; and the scene exported comes back the same.
#include <algorithm>

#include "params/slots.h"
#include "tests/fuzz/fuzz_reader.h"
#include "workbench/export.h"
#include "workbench/import.h"

namespace {

void check_text(const cg::Text& text) {
  for (const std::string* side : {&text.en, &text.ja}) {
    cg::require(!side->empty() && side->size() < 1000);
    for (const char c : *side) cg::require(static_cast<unsigned char>(c) >= 0x20);
  }
}

void check_report(cg::ImportReport& report, std::string_view bytes) {
  const long lines = 1 + std::count(bytes.begin(), bytes.end(), '\n') + std::count(bytes.begin(), bytes.end(), '\r');
  for (const cg::Complaint& complaint : report.complaints) {
    cg::require(complaint.line >= 0 && complaint.line <= lines);
    check_text(complaint.text);
  }
  cg::require(!report.scene.objects.empty());
  for (const cg::Slot& slot : cg::slots(report.scene)) cg::assign(slot, cg::slot_tree(slot));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  cg::ImportReport report;
  try {
    report = cg::import_c(bytes, "fuzz.c");
  } catch (const cg::InputError& e) {
    check_text({e.message(cg::Language::english), e.message(cg::Language::japanese)});
    return 0;
  }
  check_report(report, bytes);
  const std::string text = cg::export_c(report.scene);
  const cg::ImportReport again = cg::import_c(text, "again.c");
  if (text.size() < cg::largest_c_file) cg::require(again.scene == report.scene);
  return 0;
}
