#include "workbench/listing.h"

#include "shading/own_light_model.h"
#include "workbench/listing_lines.h"

namespace cg {

namespace {

// The function of a GLUT program where the calls of a section stand.
std::string_view function_of(GlSection section) {
  switch (section) {
    case GlSection::state:
    case GlSection::light_model:
      return "init()";
    case GlSection::projection:
      return "reshape()";
    case GlSection::mesh:
      return "draw_mesh()";
    default:
      return "display()";
  }
}

// Calls that stand together, without a gap: of one section, of one light, of one object.
bool together(const GlCall& a, const GlCall& b) {
  if (a.object >= 0 || b.object >= 0) return a.object == b.object;
  return a.section == b.section && a.light == b.light;
}

// The light model of the program's own, where there is one.
void add_own_light_model(const Mistakes& mistakes, std::vector<ListingLine>& lines) {
  if (!lights_by_hand(mistakes)) return;
  lines.emplace_back();
  for (const SourceLine& source : own_light_model(mistakes)) {
    ListingLine line;
    const std::size_t indent = std::min(source.text.find_first_not_of(' '), source.text.size());
    line.text =
        source.missing ? source.text.substr(0, indent) + "/* " + source.text.substr(indent) + " */" : source.text;
    line.guilty = !source.mistake.empty(), line.mistake = source.mistake;
    line.comment = source.missing || source.text.compare(indent, 2, "/*") == 0;
    lines.push_back(std::move(line));
  }
}

void add_call(const GlCall& call, Language language, std::vector<ListingLine>& lines) {
  for (ListingLine& comment : comments(call, language)) lines.push_back(std::move(comment));
  if (call.function.empty()) return;
  ListingLine line = statement(call);
  if (call.missing) {
    line.text = "/* " + line.text + " */";
    line.numbers.clear();
    line.comment = true;
  } else if (!call.variable.empty()) {
    lines.push_back(declaration(call));
  }
  lines.push_back(std::move(line));
}

}  // namespace

Listing listing(const Scene& scene, Language language) {
  Listing out;
  const GlCall* before = nullptr;
  const std::vector<GlCall> calls = gl_calls(scene);
  for (const GlCall& call : calls) {
    const std::string_view function = function_of(call.section);
    const bool new_function = !before || function_of(before->section) != function;
    if (before && (new_function || !together(*before, call))) out.lines.emplace_back();
    if (new_function) out.lines.push_back(comment_line(function));
    add_call(call, language, out.lines);
    before = &call;
  }
  add_own_light_model(scene.mistakes, out.lines);
  return out;
}

}  // namespace cg
