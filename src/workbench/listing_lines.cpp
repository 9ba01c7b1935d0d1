#include "workbench/listing_lines.h"

#include "params/numbers.h"

namespace cg {

namespace {

ListingLine line_of(const GlCall& call) {
  ListingLine line;
  line.quantity = call.quantity, line.light = call.light, line.path = call.path;
  line.guilty = !call.mistake.empty(), line.mistake = call.mistake;
  return line;
}

// Adds ", " between the words of a list.
void begin_item(std::string& text, bool& first) {
  if (!first) text += ", ";
  first = false;
}

void add_number(ListingLine& line, const GlNumber& n) {
  if (n.times_aspect && n.path.empty() && n.value == 1) {
    line.text += "aspect";
    return;
  }
  const std::size_t begin = line.text.size();
  line.text += c_literal(n.value);
  line.numbers.push_back({begin, line.text.size(), n.path, n.component, n.value, n.factor});
  if (n.times_aspect) line.text += " * aspect";
}

void add_numbers(ListingLine& line, const std::vector<GlNumber>& numbers, bool& first) {
  for (const GlNumber& n : numbers) {
    begin_item(line.text, first);
    add_number(line, n);
  }
}

// glClear takes its bits as one argument; all other words are arguments of their own.
std::string joined(const GlCall& call) {
  std::string bits;
  for (const std::string& token : call.tokens) bits += (bits.empty() ? "" : " | ") + token;
  return bits;
}

}  // namespace

ListingLine declaration(const GlCall& call) {
  ListingLine line = line_of(call);
  line.text = "float " + call.variable + "[] = { ";
  bool first = true;
  add_numbers(line, call.numbers, first);
  line.text += " };";
  return line;
}

ListingLine statement(const GlCall& call) {
  ListingLine line = line_of(call);
  line.text = std::string(call.function) + "(";
  std::vector<std::string> tokens = call.tokens;
  if (call.function == "glClear") tokens = {joined(call)};
  if (!call.variable.empty()) tokens.push_back(call.variable);
  bool first = true;
  for (const std::string& token : tokens) {
    line.text += first ? " " : "";
    begin_item(line.text, first);
    line.text += token;
  }
  if (call.variable.empty()) {
    if (first && !call.numbers.empty()) line.text += " ";
    add_numbers(line, call.numbers, first);
  }
  line.text += first ? ");" : " );";
  return line;
}

std::vector<ListingLine> comments(const GlCall& call, Language language) {
  std::vector<ListingLine> lines;
  for (const Text& note : call.notes) {
    lines.push_back(comment_line(note.in(language)));
    lines.back().light = call.light, lines.back().quantity = call.quantity;
  }
  return lines;
}

ListingLine comment_line(std::string_view text) {
  ListingLine line;
  line.text = "/* " + std::string(text) + " */";
  line.comment = true;
  return line;
}

ListingLine indented(ListingLine line, std::size_t columns) {
  line.text.insert(0, columns, ' ');
  for (ListingNumber& n : line.numbers) n.begin += columns, n.end += columns;
  return line;
}

}  // namespace cg
