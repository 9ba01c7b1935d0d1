// parity [--all] [--model NAME] [--pictures FOLDER]: software against OpenGL, every model, camera, light and mode.
// Prints the rows that fail (with --all: every row), the worst rows and a summary. Exit status 1 where a row fails.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "params/input_error.h"
#include "tests/parity/parity_cases.h"

namespace {

using cg::parity::Result;

void print(const Result& r) {
  std::printf("%-4s coverage %3zu  max %7.3f/255  within 1/255 %8.4f %%  cone edge %3zu  %s\n",
              r.passes() ? "ok" : "FAIL", r.coverage_mismatch, r.max_error * 255,
              r.covered ? 100.0 * double(r.covered - r.over_1_255) / double(r.covered) : 100.0, r.on_cone_edge,
              r.what.c_str());
}

int summarise(std::vector<Result> rows) {
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const Result& r) { return !r.passes(); });
  std::sort(rows.begin(), rows.end(), [](const Result& a, const Result& b) { return a.max_error > b.max_error; });
  std::puts("\nthe worst by colour:");
  for (std::size_t i = 0; i < std::min<std::size_t>(rows.size(), 10); ++i) print(rows[i]);
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Result& a, const Result& b) { return a.coverage_mismatch > b.coverage_mismatch; });
  std::puts("the worst by coverage:");
  for (std::size_t i = 0; i < std::min<std::size_t>(rows.size(), 3); ++i) print(rows[i]);
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Result& a, const Result& b) { return a.on_cone_edge > b.on_cone_edge; });
  std::puts("the most pixels left out because they lie on a spot's edge:");
  for (std::size_t i = 0; i < std::min<std::size_t>(rows.size(), 3); ++i) print(rows[i]);
  std::printf("%zu comparisons, %td failed\n", rows.size(), failed);
  return failed == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  bool all = false;
  std::string only, pictures;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--all") == 0)
      all = true;
    else if (std::strcmp(argv[i], "--model") == 0 && i + 1 < argc)
      only = argv[++i];
    else if (std::strcmp(argv[i], "--pictures") == 0 && i + 1 < argc)
      pictures = argv[++i];
    else
      return std::fprintf(stderr, "usage: parity [--all] [--model NAME] [--pictures FOLDER]\n"), 2;
  }
  setenv("SHADEBENCH_IMAGES", SHADEBENCH_IMAGES_PROGRAM, 0);
  try {
    cg::parity::Comparison comparison;
    std::vector<Result> rows;
    for (const auto& model : cg::parity::all_models()) {
      if (!only.empty() && model.name != only) continue;
      const std::size_t first = rows.size();
      for (const auto& setting : cg::parity::all_settings())
        for (Result& r : comparison.compare(cg::parity::scene_of(model, setting),
                                            model.name + ' ' + cg::parity::name_of(setting), pictures))
          rows.push_back(std::move(r));
      for (std::size_t i = first; i < rows.size(); ++i)
        if (all || !rows[i].passes()) print(rows[i]);
      std::fflush(stdout);
    }
    return summarise(std::move(rows));
  } catch (const cg::InputError& e) {
    return std::fprintf(stderr, "parity: %s\n", e.what()), 2;
  }
}
