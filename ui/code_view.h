// What the panel of the listing keeps from frame to frame: the listing of the scene as it is now, where its sections
// begin, and the number that is in hand.
#pragma once
#include <imgui.h>

#include <string>
#include <vector>

#include "workbench/listing.h"

namespace cg {

struct App;

struct CodeView {
  // A place to jump to.
  struct Section {
    Text label;
    int line = 0;
    int light = -1;  // index into Scene::lights
  };
  // The number that the mouse holds.
  struct Held {
    ImGuiID id = 0;  // 0: none
    ListingNumber number;
    bool moved = false;
  };

  Listing listing;
  std::vector<std::vector<int>> keys;  // a name for each number that it keeps while lines come and go
  std::vector<Section> sections;
  std::size_t widest = 0;  // letters of the longest line

  Held held;
  double typing_since = -1;  // the window's clock when the field in the listing opened
  int jump = -1;             // the line that comes to the top in the next frame; -1: none
  int light = -1;            // that was selected in the last frame

  // The listing of `scene`: made again only where something differs. `without_missing`: what is left out by mistake
  // leaves no trace.
  void make(const Scene& scene, Language language, bool without_missing);
  std::string text() const;

 private:
  void name_numbers();
  void find_sections();
  Scene scene_;
  Language language_ = Language::english;
  bool made_ = false, without_missing_ = false;
};

// A run of letters in one colour.
enum class CodeInk { plain, quiet, comment, number };
struct ListingRun {
  std::size_t begin = 0, end = 0;
  CodeInk ink = CodeInk::plain;
};
// The line as runs, from left to right, without gaps: its numbers, and between them C's words and signs.
std::vector<ListingRun> code_runs(const ListingLine& line);

// One number of the listing with its top left corner at `at`: shown, dragged, typed, set back. Returns how much more
// room than its letters it takes: the field in which it is typed is wider.
float code_number(App& app, const ListingLine& line, std::size_t index, int key, ImVec2 at, float height);
// Moves the number that is held, also where its line is out of sight. Once a frame, in the window of the lines.
void move_held_number(App& app);

}  // namespace cg
