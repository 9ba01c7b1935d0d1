#include "workbench/import_comment.h"

#include <algorithm>
#include <optional>

#include "params/input_error.h"
#include "params/lists.h"
#include "scene/text_scanner.h"
#include "workbench/import.h"

namespace cg {

namespace {

constexpr std::string_view mark = "shadebench import:";
constexpr std::string_view becomes = " -> ";

// JSON that may stand in a comment: no slash can begin or end one.
std::string in_comment(const Tree& value) {
  std::string out;
  for (const char c : to_json(value, 0)) out += c == '/' ? "\\/" : c == '*' ? "\\u002a" : std::string(1, c);
  return out;
}

std::string line(std::string_view path, const Tree& from, const Tree& to) {
  return " * " + std::string(path) + ": " + in_comment(from) + std::string(becomes) + in_comment(to) + "\n";
}

// Where lists have other lengths: `read` gets those of `scene`.
std::string length_lines(Scene& read, Scene& scene) {
  std::string out;
  const std::vector<ListSlot> wanted = lists(scene);
  std::size_t i = 0;
  for_each_list(read, [&](const ListSlot& list) {
    const std::size_t size = wanted[i++].size();
    if (list.size() == size) return;
    out += line(list.path, list.size(), size);
    list.resize(size);
  });
  return out;
}

// The two values of "A -> B"; a text in them may hold the arrow.
struct Change {
  Tree from, to;
};
std::optional<Change> change_of(std::string_view text) {
  for (std::size_t at = text.find(becomes); at != text.npos; at = text.find(becomes, at + 1)) try {
      return Change{parse_json(text.substr(0, at), ""), parse_json(text.substr(at + becomes.size()), "")};
    } catch (const InputError&) {
    }
  return std::nullopt;
}

bool same(const Tree& a, const Tree& b) { return to_json(a, 0) == to_json(b, 0); }

void apply(Scene& scene, std::string_view path, const Change& change) {
  for (const ListSlot& list : lists(scene))
    if (list.path == path) {
      const double* n = change.to.number();
      const double most = double(std::min(list.about->most, std::size_t(1000)));  // what a comment may ask for
      if (n && *n >= 0 && *n <= most && same(change.from, list.size())) list.resize(std::size_t(*n));
      return;
    }
  const Slots all = slots(scene);
  const Slot& slot = find_slot(all, path);
  if (same(slot_tree(slot), change.from)) assign(slot, change.to);
}

}  // namespace

std::string comment_between(const Scene& read, const Scene& scene) {
  Scene before = read, after = scene;
  std::string lines = length_lines(before, after);
  const Slots a = slots(before), b = slots(after);
  for (std::size_t i = 0; i < a.size(); ++i)
    if (const Tree from = slot_tree(a[i]), to = slot_tree(b[i]); !same(from, to)) lines += line(a[i].path, from, to);
  return lines.empty() ? "" : "\n/* " + std::string(mark) + "\n" + lines + " */\n";
}

void apply_comment(Scene& scene, std::span<const CComment> comments, Complaints& complaints) {
  for (const CComment& comment : comments) {
    if (!comment.text.starts_with(mark)) continue;
    TextScanner scanner(comment.text, "", {});
    while (scanner.next_line()) {
      std::string_view text = scanner.rest();
      if (text.starts_with(mark)) continue;
      if (text.starts_with("*")) text.remove_prefix(1);
      while (text.starts_with(" ")) text.remove_prefix(1);
      const std::size_t colon = text.find(": ");
      const auto change = colon == text.npos ? std::nullopt : change_of(text.substr(colon + 2));
      try {
        if (change)
          apply(scene, text.substr(0, colon), *change);
        else if (!text.empty())
          throw InputError("", Words{"this line of the comment is not understood", "コメントのこの行は解釈できない"});
      } catch (const InputError& e) {
        complaints.add(comment.line + scanner.line() - 1,
                       {e.message(Language::english), e.message(Language::japanese)});
      }
    }
  }
}

}  // namespace cg
