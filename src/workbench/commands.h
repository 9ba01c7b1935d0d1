// The commands that need no window. Each returns the exit status and throws InputError.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "params/words.h"
#include "scene/item_drawer.h"
#include "scene/technique.h"

namespace cg {

// As typed; empty where an option was not given.
struct Arguments {
  std::string scene;
  std::vector<std::string> set;  // path=value, in order
  std::string technique, left, right;
  std::string size, threads, max_error, gain;
  std::string pixel;  // x,y
  std::string output, format;
  std::string target, pass;  // of a grade
  std::string form_factor;   // A,B of radiosity
  bool json = false;
  std::string report;  // a folder
  bool check = false, quick = false;
  std::string knob, repeats;  // of a trade
  std::string against;        // a trade's file; a method of form factors
  bool weights = false;       // of --form-factor
  std::string extreme;        // a case, or a group of them
  bool list = false;
  MakeDrawItems draw_items;  // not typed: who draws radiosity's hemicubes by OpenGL; null: nobody
};

using RunCommand = int (*)(const Arguments&, std::span<const Technique>, Language);

// A command of a room that this one does not know (a trade, the extremes), as a value: named, explained and run as this
// room's own are.
struct CommandOffer {
  struct Word {
    const char* name;  // "KNOB"
    std::string Arguments::*value;
  };
  struct Option {
    const char* names;  // "-o,--output"
    const char* type;   // "DIR"; null for a flag
    Words help;
    std::string Arguments::*value = nullptr;
    bool Arguments::*flag = nullptr;
  };
  const char* name;
  Words help;
  RunCommand run;
  std::vector<Word> words;  // what stands behind the name, in order; each may be left out
  std::vector<Option> options;
  bool draws = false;  // also --set, --size and --threads
};

// One technique's picture into a file.
int run_render(const Arguments& arguments, std::span<const Technique> techniques, Language language);

// Two techniques' pictures compared: figures on stdout, the difference into a file. 1 where --max-error is exceeded.
int run_compare(const Arguments& arguments, std::span<const Technique> techniques, Language language);

// What the colour of one pixel is made of.
int run_probe(const Arguments& arguments, std::span<const Technique> techniques, Language language);

// The passes that a technique runs for the scene, those that it leaves out, and why, measured: 1 where something else
// ran than was planned.
int run_plan(const Arguments& arguments, std::span<const Technique> techniques, Language language);

// Without a display: the scene by OpenGL and in software, the pictures in the user's cache folder, the comparison on
// stdout.
int run_without_display(const Arguments& arguments, std::span<const Technique> techniques, Language language);

}  // namespace cg
