// What of the light is looked at, and what there is to say of the way a solver went.
#include <algorithm>
#include <cmath>

#include "params/numbers.h"
#include "radiosity/solver_parts.h"

namespace cg {

std::vector<glm::dvec3> Solver::Parts::received(const Channels& x, Progress& progress) {
  std::vector<glm::dvec3> out(size());
  for (std::size_t i = 0; i < size(); ++i) {
    if (i % 64 == 0) check(progress);
    out[i] = rows.times(i, x, progress);
  }
  return out;
}

std::vector<glm::dvec3> Solver::radiosity() const {
  std::vector<glm::dvec3> out = parts_->iteration->radiosity();
  if (const glm::dvec3 estimate = ambient(); largest(estimate) > 0)
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += parts_->data->reflectance[i] * estimate;
  return out;
}

std::vector<glm::dvec3> Solver::part(LightPart part, Progress& progress) const {
  std::vector<glm::dvec3> b = radiosity();
  const SolverData& data = *parts_->data;
  switch (part) {
    case LightPart::total:
      break;
    case LightPart::unshot: {
      if (const Channels* unshot = parts_->iteration->unshot()) return unshot->vectors();
      const auto received = parts_->received(Channels(b), progress);
      for (std::size_t i = 0; i < b.size(); ++i) b[i] = data.emission[i] + data.reflectance[i] * received[i] - b[i];
      break;
    }
    case LightPart::received:
      return parts_->received(Channels(b), progress);
    case LightPart::indirect: {
      const auto direct = parts_->received(data.emission, progress);
      for (std::size_t i = 0; i < b.size(); ++i) b[i] -= data.emission[i] + data.reflectance[i] * direct[i];
      break;
    }
  }
  return b;
}

double Solver::residual(Progress& progress) const {
  if (const Channels* unshot = parts_->iteration->unshot()) {
    double most = 0;
    for (const glm::dvec3& r : unshot->vectors()) most = std::max(most, largest(r));
    return kind() == RadiositySolver::progressive ? parts_->bounce.closed * most : most;
  }
  double out = 0;
  for (const glm::dvec3& r : part(LightPart::unshot, progress)) out = std::max(out, largest(glm::abs(r)));
  return out;
}

Text Solver::message() const {
  const Parts& p = *parts_;
  if (p.end == SolverEnd::diverges && p.bounce.closed > 1) {
    const std::string kept = number_text(std::ceil(p.bounce.closed * 1e6) / 1e6);
    return {
        "It diverges: a bounce returns up to " + kept + " of the light, ρ(1 + δ) ≥ 1. Normalise the rows or lower ρ.",
        "発散する：1 回の反射で光が最大 " + kept + " 倍になる（ρ(1 + δ) ≥ 1）。行の和を 1 にするか、ρ を下げる。"};
  }
  if (p.end == SolverEnd::diverges)
    return Words{"It diverges: nothing absorbs the light where ρ = 1 in a closed scene. Lower ρ.",
                 "発散する：閉じたシーンで ρ = 1 だと光を吸収するものがない。ρ を下げる。"};
  if (p.end == SolverEnd::rounding) {
    const std::string bound = number_text(std::pow(10, std::ceil(std::log10(p.curve.back().error_bound))));
    return {"The digits of double are used up: B is known to " + bound + " of the brightest.",
            "double の桁を使い切った：B の誤差は最大値の " + bound + " 以下。"};
  }
  if (p.iteration->unshot() && !p.data->columns)
    return Words{"Columns of F by reciprocity, F_ji = F_ij A_i / A_j: there is no memory for them.",
                 "F の列は相反則 F_ji = F_ij A_i / A_j から求める（列を保存するメモリがない）。"};
  return {};
}

}  // namespace cg
