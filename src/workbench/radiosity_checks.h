// What form factors and light are held against: each weight of a hemicube's pixels beside the others and closed forms,
// and the light that form factors of another method make.
#pragma once
#include "params/tree.h"
#include "radiosity/solution.h"
#include "scene/scene.h"

namespace cg {

// F from one object to another, as form_factor(), for the same patches.
struct WeightFigures {
  struct Row {
    PixelWeight weight;
    double form_factor = 0;
    double sum = 0;  // of all pixels: 1 gives no weight away
  };
  std::vector<Row> rows;   // of PixelWeight, not normalised
  double nusselt = 0;      // of the same positions, exact there, with nothing between
  double closed_form = 0;  // of whole patches, with nothing between
};
// Throws Cancelled, and InputError as form_factor_method().
WeightFigures weight_figures(const Patches& patches, const Radiosity& options, std::uint32_t from, std::uint32_t to,
                             const MakeDrawItems& gl, const Progress& progress);
Tree json_of(const WeightFigures& figures);
std::string text_of(const WeightFigures& figures, Language language);

// How far the mean radiosity of each object in one solution are from another's.
struct MeanDifferences {
  FormFactors other;  // the method that they are compared with
  struct Row {
    std::string object;
    glm::dvec3 difference;  // over the other's, 0.01 is one per cent; 0 where both are 0
  };
  std::vector<Row> rows;  // of objects with patches
  double largest = 0;
};
MeanDifferences mean_differences(const Scene& scene, const RadiositySolution& solution, const RadiositySolution& other);
Tree json_of(const MeanDifferences& differences);
std::string text_of(const MeanDifferences& differences, Language language);

}  // namespace cg
