#include "ui/code_view.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace cg {
namespace {

bool about_material(const ListingLine& line) {
  const auto material = [](const std::string& path) { return path.find("material.") != std::string::npos; };
  return material(line.path) || (!line.numbers.empty() && material(line.numbers[0].path));
}

bool about_camera(const ListingLine& line) {
  return !line.numbers.empty() && line.numbers[0].path.starts_with("camera.");
}

bool word_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// C's words and signs in text[begin, end).
void append_plain_runs(std::string_view text, std::size_t begin, std::size_t end, std::vector<ListingRun>& runs) {
  while (begin < end) {
    std::size_t stop = begin;
    const bool word = word_letter(text[begin]);
    while (stop < end && word_letter(text[stop]) == word) ++stop;
    const std::string_view run = text.substr(begin, stop - begin);
    const bool quiet = !word || run == "float" || run == "const" || run == "void";
    runs.push_back({begin, stop, quiet ? CodeInk::quiet : CodeInk::plain});
    begin = stop;
  }
}

}  // namespace

void CodeView::make(const Scene& scene, Language language, bool without_missing) {
  if (made_ && language == language_ && without_missing == without_missing_ && scene == scene_) return;
  scene_ = scene, language_ = language, without_missing_ = without_missing, made_ = true;
  listing = cg::listing(scene, language);
  if (without_missing) std::erase_if(listing.lines, [](const ListingLine& l) { return l.guilty && l.comment; });
  widest = 0;
  for (const ListingLine& line : listing.lines) widest = std::max(widest, line.text.size());
  name_numbers();
  find_sections();
}

std::string CodeView::text() const {
  std::string out;
  for (const ListingLine& line : listing.lines) out += line.text + "\n";
  return out;
}

void CodeView::name_numbers() {
  std::map<std::pair<std::string, int>, int> seen;
  keys.clear();
  for (const ListingLine& line : listing.lines) {
    std::vector<int>& row = keys.emplace_back();
    for (const ListingNumber& number : line.numbers) {
      const int occurrence = seen[{number.path, number.component}]++;
      const std::string name = number.path + "#" + std::to_string(number.component) + "#" + std::to_string(occurrence);
      row.push_back(int(std::hash<std::string>()(name)));
    }
  }
}

void CodeView::find_sections() {
  sections.clear();
  const auto add = [&](Text label, int light, auto begins) {
    const auto& lines = listing.lines;
    const auto found = std::find_if(lines.begin(), lines.end(), begins);
    if (found != lines.end()) sections.push_back({std::move(label), int(found - lines.begin()), light});
  };
  add(Words{"State", "状態"}, -1, [](const ListingLine&) { return true; });
  add(Words{"Camera", "カメラ"}, -1, about_camera);
  for (int i = 0; i < int(scene_.lights.size()); ++i) {
    const std::string n = std::to_string(i);
    add(i == 0 ? Text("Light 0", "光源 0") : Text(n, n), i, [i](const ListingLine& l) { return l.light == i; });
  }
  add(Words{"Material", "素材"}, -1, about_material);
  add(Words{"Mesh", "形"}, -1, [](const ListingLine& l) { return l.comment && l.text == "/* draw_mesh() */"; });
}

std::vector<ListingRun> code_runs(const ListingLine& line) {
  if (line.comment) return {{0, line.text.size(), CodeInk::comment}};
  std::vector<ListingRun> runs;
  std::size_t at = 0;
  for (const ListingNumber& number : line.numbers) {
    append_plain_runs(line.text, at, number.begin, runs);
    runs.push_back({number.begin, number.end, CodeInk::number});
    at = number.end;
  }
  append_plain_runs(line.text, at, line.text.size(), runs);
  return runs;
}

}  // namespace cg
