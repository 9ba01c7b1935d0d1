// Sums and texts of numbers at their extremes.
// This work is based on: William Kahan, Further Remarks on Reducing Truncation Errors, 1965.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "measure/arithmetic.h"
#include "measure/extreme_tables.h"
#include "params/numbers.h"

namespace cg {

namespace {

using Rows = std::vector<Naive::Row>;

Rows sums() {
  Rows rows;
  for (const int n : {1000, 1000000, 20000000}) {
    float naive = 0;
    double robust = 0;
    const float term = 0.1f;
    for (int i = 0; i < n; ++i) naive += term, robust += double(term);
    rows.push_back({std::to_string(n) + " terms of 0.1", naive, robust, n * double(term)});
  }
  return rows;
}

// The variance of numbers that differ little from their mean.
Rows variances() {
  Rows rows;
  for (const float mean : {1.0f, 1e4f, 1e5f}) {
    float sum = 0, squares = 0;
    const float values[] = {mean - 1, mean, mean + 1};
    for (const float v : values) sum += v, squares += v * v;
    const float m = sum / 3;
    float robust = 0;
    for (const float v : values) robust += (v - m) * (v - m);
    rows.push_back({"mean " + number_text(mean) + " ± 1", squares / 3 - m * m, robust / 3, 2.0 / 3});
  }
  return rows;
}

Rows texts() {
  Rows rows;
  for (const double v : {0.5, 1.0 / 3, 16777217.0, 1e-7}) {
    char six[64];
    std::snprintf(six, sizeof six, "%.6g", v);
    rows.push_back({six, parse_number(six).value_or(0), parse_number(number_text(v)).value_or(0), v});
  }
  return rows;
}

Rows small_steps() {
  Rows rows;
  for (const double x : {0.1, 1e-4, 1e-8}) {
    const float f = float(x);
    rows.push_back({"x = " + number_text(x), 1 - std::cos(f), 2 * std::sin(f / 2) * std::sin(f / 2),
                    2 * std::sin(double(f) / 2) * std::sin(double(f) / 2)});
  }
  return rows;
}

}  // namespace

void add_number_arithmetic(ExtremeTable& all) {
  all.push_back(
      naive_case("sum", {"A sum of many small terms", "多くの小さな項の和"}, "terms", "20 000 000",
                 {"n times the term.", "項の n 倍。"}, 1e-6,
                 {"float s; s += x",
                  "double s; s += x",
                  {"Beside a large s a term is rounded to float's step there: at 1e6 each 0.1 adds 0.125.",
                   "大きな s に足す項は、そこでの float の刻みに丸められるため。s = 1e6 では 0.1 が 0.125 になる。"},
                  sums}));
  all.push_back(naive_case("variance", {"The variance about a large mean", "大きな平均の周りの分散"}, "mean", "1e5 ± 1",
                           {"2/3.", "2/3。"}, 1e-5,
                           {"mean(x²) - mean(x)²",
                            "mean((x - mean)²)",
                            {"Two numbers of 1e10 are subtracted that agree in all of float's digits.",
                             "float の桁がすべて一致する 1e10 の数どうしを引くため。"},
                            variances}));
  all.push_back(naive_case("text", {"A number as text and back", "数を文字にして読み戻す"}, "preset, number",
                           "1/3, 16777217", {"The same number.", "同じ数。"}, 0,
                           {"printf(\"%.6g\")",
                            "the shortest text that reads back",
                            {"Six digits are fewer than the number has.", "六桁では数の桁が足りないため。"},
                            texts}));
  all.push_back(naive_case("one-minus-cosine", {"1 - cos x of a small angle", "小さな角の 1 - cos x"}, "x", "1e-8",
                           {"2 sin²(x/2).", "2 sin²(x/2)。"}, 1e-6,
                           {"1 - cos(x)",
                            "2 sin²(x/2)",
                            {"cos x rounds to 1, and all digits are lost in the difference.",
                             "cos x が 1 に丸められ、差で全桁が失われるため。"},
                            small_steps}));
}

}  // namespace cg
