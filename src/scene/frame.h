// What every technique returns, and what it is asked for: that is what makes a side-by-side mean something.
#pragma once
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "image/image.h"

namespace cg {

// The picture that is wanted.
struct View {
  int width = 512, height = 512;  // 0 is allowed and gives an empty frame
  int threads = 1;                // for techniques that can use more; the result does not depend on it
  bool ids = false;               // also fill Frame::triangle and Frame::object
  bool normals = false;           // also fill Frame::normal
  bool reuse = false;             // what the picture before computed may be taken where it is the same
  int samples = 1;                // a pixel, up to Technique::most_samples; 1 where ids or normals are asked for
  friend bool operator==(const View&, const View&) = default;
};

inline constexpr std::int32_t nothing = -1;

// What a technique really did for one line of its Plan, recorded while it drew. Lines that are not here did not run.
struct PassRun {
  std::string id;         // of Plan::passes
  double cpu_ms = 0;      // CPU time of the whole process; 0 where the line is no work of its own
  std::size_t bytes = 0;  // that it held, counted where they were asked for
  bool kept = false;      // it was there from a picture before: nothing was done
};

// Code that was compiled for the scene, and drew the picture.
struct CodeRun {
  std::string parts;      // what is in it, as in Plan::code
  double compile_ms = 0;  // CPU time, when it was compiled
  bool kept = false;      // that was for a picture before
};

// All layers have the picture's size, or are empty where they were not asked for. Row 0 is the top.
struct Frame {
  ColourImage colour;            // linear; the background where nothing is
  Image<float> depth;            // window depth 0..1, 1 where nothing is
  Image<std::uint8_t> covered;   // 1 where something is
  Image<std::int32_t> object;    // index into Scene::objects, or `nothing`
  Image<std::int32_t> triangle;  // index into the object's Mesh::triangles(), or `nothing`
  Image<glm::vec3> normal;       // unit, world; 0 where nothing is
  std::size_t nan_pixels = 0;    // NaN or infinite: replaced by 0 and counted
  double cpu_ms = 0;             // CPU time of the whole process while it was drawn
  std::vector<PassRun> passes;   // each once, in the order in which they began
  std::vector<CodeRun> code;     // each once
};

// How far work has come, and the place where it asks whether it was cancelled. Shared by two threads.
struct Progress {
  std::atomic<float> fraction{0};  // 0..1
  std::atomic<bool> cancelled{false};
};

// Thrown by work that noticed Progress::cancelled; caught where the work was started.
struct Cancelled {};

}  // namespace cg
