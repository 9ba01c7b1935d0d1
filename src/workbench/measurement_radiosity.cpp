// Measurements of a scene's radiosity: form factors and the rows of their matrix, an object's light, how it was solved.
#include <array>
#include <cmath>

#include "params/input_error.h"
#include "radiosity/unoccluded_rows.h"
#include "workbench/measurement_picture.h"

namespace cg {

namespace {

SolutionHandle solution_of(const MeasureInput& in) { return in.solved.of(in.scene, in.progress).solution; }

std::uint32_t object_index(const MeasureInput& in, int index) {
  object_at(in.scene, index);
  return std::uint32_t(index);
}

double factor(const MeasureInput& in) {
  return form_factor(*solution_of(in), object_index(in, in.options.object), object_index(in, in.options.to),
                     in.progress);
}

constexpr std::size_t most_compared = 256;

// Over all pairs of patches: the root mean square of the factors' errors, over that of the factors.
double factor_error(const MeasureInput& in) {
  const SolutionHandle s = solution_of(in);
  if (s->patches->patches.size() > most_compared || !nothing_hides(*s->patches))
    throw InputError("form-factor-error",
                     {"its form factors have no closed form, as one face hides another or there are too many",
                      "面が多すぎるか、面どうしが隠し合うため、形態係数の厳密な値が求まらない"},
                     {"an empty room of large patches works", "大きなパッチの、空の部屋なら求まる"});
  Radiosity exact = s->options;
  exact.form_factors = FormFactors::closed_form;
  const FormFactorMethod closed_form = form_factor_method(*s->patches, exact);
  double off = 0, all = 0;
  for (std::uint32_t i = 0; i < s->patches->patches.size(); ++i) {
    std::vector<double> row(s->patches->patches.size());
    for (const FormFactor& f : s->matrix->row(i, in.progress).factors) row[f.patch] = f.value;
    for (const FormFactor& f : closed_form.row(i, in.progress).factors) {
      row[f.patch] -= f.value;
      all += double(f.value) * double(f.value);
    }
    for (const double d : row) off += d * d;
  }
  return std::sqrt(off / all);
}

// Of the object's patches, weighted by area, as the method gave it.
double row_sum(const MeasureInput& in) {
  const SolutionHandle s = solution_of(in);
  const std::uint32_t object = object_index(in, in.options.object);
  double sum = 0, area = 0;
  for (std::size_t i = 0; i < s->matrix->kept_rows(); ++i) {
    const Patch& p = s->patches->patches[i];
    if (p.object != object) continue;
    sum += p.area * double(s->matrix->row_figures()[i].sum);
    area += p.area;
  }
  return area > 0 ? sum / area : 0;
}

double radiosity(const MeasureInput& in) {
  const std::uint32_t object = object_index(in, in.options.object);
  const SolutionHandle s = solution_of(in);
  if (s->figures.end == SolverEnd::diverges)
    throw InputError("radiosity", {"the light grows without end", "光が限りなく増え、解が求まらない"},
                     {"lower ρ, or normalise the rows", "ρ を下げるか、行の和を 1 にする"});
  const glm::dvec3 mean = mean_radiosity(*s, in.scene.objects.size())[object].radiosity;
  return in.options.channel == Channel::mean ? (mean.x + mean.y + mean.z) / 3 : mean[int(in.options.channel)];
}

constexpr std::array table{
    Measurement{"form-factor",
                {"Form factor of two objects", "物体どうしの形態係数"},
                "1",
                {"object, to", "object、to"},
                factor},
    Measurement{"form-factor-error",
                {"Error of all form factors, RMS", "すべての形態係数の誤差（RMS）"},
                "1",
                {"of an empty convex room", "凸で空の部屋だけ"},
                factor_error},
    Measurement{
        "row-sum", {"Row sum, before it is normalised", "正規化する前の行の和"}, "1", {"object", "object"}, row_sum},
    Measurement{"reciprocity-error",
                {"Largest |A_i F_ij − A_j F_ji|", "|A_i F_ij − A_j F_ji| の最大値"},
                "m²",
                {"—", "—"},
                [](const MeasureInput& in) { return solution_of(in)->figures.matrix.reciprocity_error; }},
    Measurement{"radiosity",
                {"Mean radiosity of an object", "物体の平均ラジオシティ"},
                "1",
                {"object; channel", "object、channel"},
                radiosity},
    Measurement{"patches",
                {"Patches", "パッチの数"},
                "1",
                {"—", "—"},
                [](const MeasureInput& in) { return double(solution_of(in)->patches->patches.size()); }},
    Measurement{"elements",
                {"Elements", "要素の数"},
                "1",
                {"—", "—"},
                [](const MeasureInput& in) { return double(solution_of(in)->patches->elements.size()); }},
    Measurement{"sweeps",
                {"Sweeps that the solver made", "解法が行った反復の数"},
                "1",
                {"as many steps as there are patches are one", "パッチの数だけの手順で 1 反復"},
                [](const MeasureInput& in) { return solution_of(in)->figures.sweeps; }},
    Measurement{"solver-steps",
                {"Steps that the solver made", "解法の手順の数"},
                "1",
                {"rows, or shots", "行、または放出"},
                [](const MeasureInput& in) { return double(solution_of(in)->figures.steps); }},
    Measurement{"residual",
                {"Largest residual of B = E + ρFB", "B = E + ρFB の残差の最大値"},
                "1",
                {"—", "—"},
                [](const MeasureInput& in) { return solution_of(in)->figures.residual; }},
    Measurement{"diverges",
                {"Whether the light grows without end (1) or not (0)", "光が限りなく増える（1）か否（0）か"},
                "1",
                {"—", "—"},
                [](const MeasureInput& in) { return solution_of(in)->figures.end == SolverEnd::diverges ? 1.0 : 0.0; }},
};

}  // namespace

std::span<const Measurement> radiosity_measurements() { return table; }

}  // namespace cg
