// shadebench radiosity: how a scene is cut, what its form factors cost and are worth, and how its light was solved.
#include "workbench/radiosity_command.h"

#include <algorithm>
#include <cstdio>

#include "params/numbers.h"
#include "params/tree.h"
#include "radiosity/solution_file.h"
#include "workbench/command_parts.h"
#include "workbench/measured_plan.h"
#include "workbench/progress_line.h"
#include "workbench/radiosity_checks.h"

namespace cg {

namespace {

constexpr const char* end_names[] = {"none", "converged", "rounding", "diverges"};

template <class T>
const Name& name_of(T value) {
  return names_of<T>[std::size_t(value)];
}

// By its name, or by its number.
std::uint32_t object_named(const Scene& scene, const std::string& text, const std::string& option) {
  std::string names;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (scene.objects[i].name == text) return std::uint32_t(i);
    names += (i > 0 ? ", " : "") + std::to_string(i) + " " + scene.objects[i].name;
  }
  if (const auto i = whole_number(text, 0, int(scene.objects.size()) - 1)) return std::uint32_t(*i);
  throw bad_option(option, text, {"the objects are " + names, "物体は " + names});
}

// --form-factor A,B: of objects, where a name may have commas too.
struct FromTo {
  std::uint32_t from = 0, to = 0;
};
FromTo objects_of(const Scene& scene, const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == text.npos)
    throw bad_option("--form-factor", text,
                     {"name two objects, or their numbers: floor,ceiling or 0,1",
                      "物体を二つ、名前か番号で指定すること：floor,ceiling や 0,1"});
  return {object_named(scene, text.substr(0, comma), "--form-factor"),
          object_named(scene, text.substr(comma + 1), "--form-factor")};
}

Tree colour(const glm::dvec3& v) { return Tree::List{v.x, v.y, v.z}; }

// The mean radiosity of each object over its area.
Tree objects_json(const Scene& scene, const RadiositySolution& s) {
  const std::vector<ObjectLight> lights = mean_radiosity(s, scene.objects.size());
  Tree::List out;
  for (std::size_t o = 0; o < lights.size(); ++o)
    if (lights[o].area > 0)
      out.push_back(Tree::Members{
          {"name", scene.objects[o].name}, {"area", lights[o].area}, {"radiosity", colour(lights[o].radiosity)}});
  return out;
}

// What was asked for beside the solution.
struct Asked {
  std::optional<double> form_factor;
  std::optional<WeightFigures> weights;
  std::optional<MeanDifferences> against;
};

Tree lines_json(const std::vector<Text>& lines) {
  Tree::List out;
  for (const Text& line : lines) out.emplace_back(line.en);
  return out;
}

Tree matrix_json(const RadiositySolution& s) {
  const MatrixFigures& m = s.figures.matrix;
  return Tree::Members{{"storage", s.matrix->storage() == Storage::dense ? "dense" : "sparse"},
                       {"rows", s.matrix->size()},
                       {"kept_rows", s.matrix->kept_rows()},
                       {"bytes", s.figures.matrix_bytes},
                       {"least_row_sum", m.least_sum},
                       {"mean_row_sum", m.mean_sum},
                       {"greatest_row_sum", m.greatest_sum}};
}

bool balance_known(const RadiositySolution& s) { return s.patches->closed && s.matrix->whole(); }

Tree json_of(const Arguments& a, const Scene& scene, const RadiositySolution& s, const Asked& asked) {
  const RadiosityFigures& f = s.figures;
  const Radiosity& o = s.options;
  Tree::Members out{{"scene", a.scene},
                    {"patches", s.patches->patches.size()},
                    {"elements", s.patches->elements.size()},
                    {"closed", s.patches->closed},
                    {"form_factors", name_of(o.form_factors).id},
                    {"resolution", o.resolution},
                    {"samples", o.samples},
                    {"solver", name_of(o.solver).id},
                    {"seconds", Tree::Members{{"patches", f.patches_s},
                                              {"form_factors", f.form_factors_s},
                                              {"solve", f.solve_s},
                                              {"elements", f.elements_s},
                                              {"total", f.patches_s + f.form_factors_s + f.solve_s + f.elements_s}}},
                    {"matrix", matrix_json(s)},
                    {"row_sum_error", s.patches->closed ? Tree(f.matrix.sum_error()) : Tree()},
                    {"missed", f.matrix.missed},
                    {"reciprocity_error", f.matrix.reciprocity_error},
                    {"reciprocity_relative", f.matrix.reciprocity_relative},
                    {"energy_error", balance_known(s) ? Tree(f.energy_error) : Tree()},
                    {"steps", f.steps},
                    {"sweeps", f.sweeps},
                    {"residual", f.residual},
                    {"error_bound", f.error_bound},
                    {"end", end_names[std::size_t(f.end)]},
                    {"objects", objects_json(scene, s)},
                    {"notes", lines_json(s.notes)}};
  if (asked.form_factor) out.emplace_back("form_factor", *asked.form_factor);
  if (asked.weights) out.emplace_back("form_factor_by_weight", json_of(*asked.weights));
  if (asked.against) out.emplace_back("against", json_of(*asked.against));
  return out;
}

std::string seconds_text(double s) { return number_text(std::round(s * 1e3) / 1e3) + " s"; }
// An error, rounded up to one digit: 3e-7.
std::string error_text(double v) {
  if (!(v > 0)) return "0";
  double exponent = std::floor(std::log10(v)), digit = std::ceil(v / std::pow(10, exponent) - 1e-9);
  if (digit > 9) digit = 1, ++exponent;
  return number_text(digit) + "e" + number_text(exponent);
}

std::string text_of(const RadiositySolution& s, const Asked& asked, Language l) {
  const RadiosityFigures& f = s.figures;
  const auto line = [&](Words words, const std::string& rest) { return std::string(words.in(l)) + rest + "\n"; };
  const std::string patches = std::to_string(s.patches->patches.size()),
                    elements = std::to_string(s.patches->elements.size()),
                    sweeps = number_text(std::round(f.sweeps * 10) / 10);
  const std::string colon = l == Language::japanese ? "：" : ": ";
  std::string out = line({"patches", "パッチ"}, colon + patches + "  (" + seconds_text(f.patches_s) + ")");
  out += line({"elements", "要素"}, colon + elements + "  (" + seconds_text(f.elements_s) + ")");
  out +=
      line({"form factors", "形態係数"}, colon + std::string(name_of(s.options.form_factors).label.in(l)) + ", " +
                                             size_text(f.matrix_bytes) + "  (" + seconds_text(f.form_factors_s) + ")");
  if (s.patches->closed)
    out += line({"  row sums off 1 by", "  行の和の 1 からのずれ"}, colon + error_text(f.matrix.sum_error()));
  out += line({"  reciprocity |A_i F_ij - A_j F_ji|", "  相反則のずれ |A_i F_ij - A_j F_ji|"},
              colon + error_text(f.matrix.reciprocity_error) + " m²");
  out += line({"solver", "解法"}, colon + std::string(name_of(s.options.solver).label.in(l)) + ", " + sweeps +
                                      Text(" sweeps", " スイープ").in(l) + "  (" + seconds_text(f.solve_s) + ")");
  out += line({"  B is no further off than", "  B の誤差の上限"},
              colon + error_text(f.error_bound) + Text(" of the brightest", "（B の最大値に対して）").in(l));
  if (balance_known(s))
    out += line({"  energy lost or won", "  エネルギー収支のずれ"},
                colon + error_text(f.energy_error) + Text(" of the emitted", "（放射量に対して）").in(l));
  for (const Text& note : s.notes) out += "  ! " + note.in(l) + "\n";
  if (asked.form_factor) out += line({"form factor", "形態係数 F"}, colon + number_text(*asked.form_factor));
  if (asked.weights) out += text_of(*asked.weights, l);
  if (asked.against) out += text_of(*asked.against, l);
  return out;
}

FormFactors method_named(const std::string& text) {
  std::string names;
  for (std::size_t m = 0; m < names_of<FormFactors>.size(); ++m) {
    const std::string id(names_of<FormFactors>[m].id);
    if (id == text) return FormFactors(m);
    names += (m > 0 ? ", " : "") + id;
  }
  throw bad_option("--against", text, {"the methods are " + names, "方法は " + names});
}

}  // namespace

int run_radiosity(const Arguments& a, std::span<const Technique>, Language language) {
  const Scene scene = scene_for(a, language);
  SolveOptions how;
  how.threads = view_of(a).threads;
  how.method = [&](const Patches& patches, const Radiosity& options) {
    return form_factor_method(patches, options, a.draw_items);
  };
  if (a.weights && a.form_factor.empty())
    throw InputError("--weights", {"no objects are named", "物体の指定がない"},
                     {"name two: --form-factor floor,ceiling", "--form-factor floor,ceiling のように二つ指定すること"});
  std::optional<FromTo> objects;
  if (!a.form_factor.empty()) objects = objects_of(scene, a.form_factor);
  Radiosity other = scene.radiosity;
  if (!a.against.empty()) other.form_factors = method_named(a.against);
  how.announce = [&](const MatrixPlan& plan) {
    if (!a.json) print(plan.text().in(language) + "\n"), std::fflush(stdout);
  };
  Progress progress;
  SolutionHandle solution;
  Asked asked;
  {
    const ProgressLine line(progress, std::string(Words{"radiosity", "ラジオシティ"}.in(language)));
    solution = solve_radiosity(scene, scene.radiosity, nullptr, progress, how);
    if (objects) asked.form_factor = form_factor(*solution, objects->from, objects->to, progress);
    if (a.weights)
      asked.weights =
          weight_figures(*solution->patches, scene.radiosity, objects->from, objects->to, a.draw_items, progress);
    how.announce = {};
    if (!a.against.empty())
      asked.against = mean_differences(scene, *solution, *solve_radiosity(scene, other, nullptr, progress, how));
  }
  print(a.json ? to_json(json_of(a, scene, *solution, asked)) + "\n" : text_of(*solution, asked, language));
  if (solution->figures.end == SolverEnd::diverges) {
    for (const Text& note : solution->notes) std::fprintf(stderr, "shadebench: %s\n", note.in(language).c_str());
    return 1;
  }
  if (!a.output.empty()) save_solution(*solution, a.output);
  return 0;
}

}  // namespace cg
