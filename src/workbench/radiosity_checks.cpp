#include "workbench/radiosity_checks.h"

#include <algorithm>
#include <cmath>

#include "params/numbers.h"
#include "radiosity/hemicube.h"

namespace cg {

namespace {

std::string decimals(double v, int digits) {
  const double unit = std::pow(10, digits);
  return number_text(std::round(v * unit) / unit + 0.0);
}

std::string padded(std::string text, std::size_t width) {
  // By characters: those of Japanese have two columns each; their first byte is from e3 on.
  std::size_t columns = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    columns += byte < 0x80 ? 1 : byte >= 0xe3 ? 2 : byte >= 0xc0 ? 1 : 0;
  }
  return text + std::string(columns < width ? width - columns : 1, ' ');
}

// The mean over the patches of `from`, weighted by area, of the factors to all patches of `to`.
double object_factor(const Patches& patches, const FormFactorMethod& method, std::uint32_t from, std::uint32_t to,
                     const Progress& progress) {
  double sum = 0, area = 0;
  for (std::uint32_t i = 0; i < patches.patches.size(); ++i) {
    const Patch& p = patches.patches[i];
    if (p.object != from) continue;
    area += p.area;
    for (const FormFactor& f : method.row(i, progress).factors)
      if (patches.patches[f.patch].object == to) sum += p.area * double(f.value);
  }
  return area > 0 ? sum / area : 0;
}

}  // namespace

WeightFigures weight_figures(const Patches& patches, const Radiosity& options, std::uint32_t from, std::uint32_t to,
                             const MakeDrawItems& gl, const Progress& progress) {
  Radiosity o = options;
  o.normalise = Normalise::none;
  const auto factor = [&] { return object_factor(patches, form_factor_method(patches, o, gl), from, to, progress); };
  WeightFigures out;
  o.form_factors = FormFactors::hemicube;
  for (std::size_t w = 0; w < names_of<PixelWeight>.size(); ++w) {
    o.weight = PixelWeight(w);
    out.rows.push_back({o.weight, factor(), PixelWeights(hemicube_resolution(o.resolution), o.weight).sum()});
  }
  o.form_factors = FormFactors::nusselt;
  out.nusselt = factor();
  o.form_factors = FormFactors::closed_form;
  out.closed_form = factor();
  return out;
}

Tree json_of(const WeightFigures& figures) {
  Tree::List rows;
  for (const WeightFigures::Row& r : figures.rows)
    rows.push_back(Tree::Members{
        {"weight", names_of<PixelWeight>[std::size_t(r.weight)].id}, {"form_factor", r.form_factor}, {"sum", r.sum}});
  return Tree::Members{
      {"weights", std::move(rows)}, {"nusselt", figures.nusselt}, {"closed_form", figures.closed_form}};
}

std::string text_of(const WeightFigures& figures, Language language) {
  constexpr std::size_t label = 36, number = 12;
  const auto line = [&](Words name, const std::string& rest) {
    return "  " + padded(std::string(name.in(language)), label) + rest + "\n";
  };
  std::string out = line({"a pixel counts", "画素の重み"},
                         padded("F", number) + std::string(Words{"all pixels", "全画素の和"}.in(language)));
  for (const WeightFigures::Row& r : figures.rows)
    out += line(names_of<PixelWeight>[std::size_t(r.weight)].label,
                padded(decimals(r.form_factor, 6), number) + decimals(r.sum, 6));
  out += line({"exact from these positions (Nusselt)", "同じ位置での厳密な値（ヌッセルト）"},
              decimals(figures.nusselt, 6));
  return out + line({"exact for whole patches", "パッチ全体の厳密な値"}, decimals(figures.closed_form, 6));
}

MeanDifferences mean_differences(const Scene& scene, const RadiositySolution& solution,
                                 const RadiositySolution& other) {
  MeanDifferences out{.other = other.options.form_factors, .rows = {}};
  const std::vector<ObjectLight> ours = mean_radiosity(solution, scene.objects.size()),
                                 theirs = mean_radiosity(other, scene.objects.size());
  for (std::size_t o = 0; o < ours.size(); ++o) {
    if (!(ours[o].area > 0)) continue;
    glm::dvec3 difference(0);
    for (int c = 0; c < 3; ++c) {
      const double right = theirs[o].radiosity[c], d = ours[o].radiosity[c] - right;
      if (d != 0) difference[c] = d / right;
      out.largest = std::max(out.largest, std::abs(difference[c]));
    }
    out.rows.push_back({scene.objects[o].name, difference});
  }
  return out;
}

Tree json_of(const MeanDifferences& differences) {
  Tree::List rows;
  for (const MeanDifferences::Row& r : differences.rows)
    rows.push_back(
        Tree::Members{{"name", r.object}, {"difference", Tree::List{r.difference.x, r.difference.y, r.difference.z}}});
  return Tree::Members{{"form_factors", names_of<FormFactors>[std::size_t(differences.other)].id},
                       {"largest", differences.largest},
                       {"objects", std::move(rows)}};
}

std::string text_of(const MeanDifferences& differences, Language language) {
  const Words other = names_of<FormFactors>[std::size_t(differences.other)].label;
  const auto per_cent = [](double v) { return decimals(100 * v, 2) + " %"; };
  std::string out = language == Language::japanese
                        ? "物体ごとの平均の差（" + std::string(other.ja) + "に対して）、R G B\n"
                        : "difference of each object's mean from that by " + std::string(other.en) + ", R G B\n";
  for (const MeanDifferences::Row& r : differences.rows) {
    out += "  " + padded(r.object, 20);
    for (int c = 0; c < 3; ++c) out += padded(per_cent(r.difference[c]), 10);
    while (out.back() == ' ') out.pop_back();
    out += "\n";
  }
  return out + "  " + padded(std::string(Words{"largest", "最大"}.in(language)), 20) + per_cent(differences.largest) +
         "\n";
}

}  // namespace cg
