// The commands that need no window. Each returns the exit status and throws InputError.
#pragma once
#include <span>
#include <string>
#include <vector>

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
  bool json = false;
  std::string report;  // a folder
  bool check = false;
};

// One technique's picture into a file.
int run_render(const Arguments& arguments, std::span<const Technique> techniques, Language language);

// Two techniques' pictures compared: figures on stdout, the difference into a file. 1 where --max-error is exceeded.
int run_compare(const Arguments& arguments, std::span<const Technique> techniques, Language language);

// What the colour of one pixel is made of.
int run_probe(const Arguments& arguments, std::span<const Technique> techniques, Language language);

// The passes that a technique runs for the scene, those that it leaves out, and why.
int run_plan(const Arguments& arguments, std::span<const Technique> techniques, Language language);

// Without a display: the scene by OpenGL and in software, the pictures in the user's cache folder, the comparison on
// stdout.
int run_without_display(const Arguments& arguments, std::span<const Technique> techniques, Language language);

}  // namespace cg
