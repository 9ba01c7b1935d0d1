// B = E + rho F B, solved step by step, so that every step can be looked at and gone back to.
// This work is based on: Cindy Goral, Kenneth Torrance, Donald Greenberg, Bennett Battaile, Modeling the Interaction of
// Light Between Diffuse Surfaces, 1984; Michael Cohen, Shenchang Chen, John Wallace, Donald Greenberg, A Progressive
// Refinement Approach to Fast Radiosity Image Generation, 1988; Steven Gortler, Michael Cohen, Philipp Slusallek,
// Radiosity and Relaxation Methods, 1994.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "radiosity/light_part.h"
#include "radiosity/matrix.h"

namespace cg {

struct RadiositySystem {
  std::shared_ptr<const FormFactorMatrix> matrix;
  std::vector<glm::dvec3> emission, reflectance;  // by patch; reflectance 0..1
};

RadiositySystem system_of(const Patches& patches, std::shared_ptr<const FormFactorMatrix> matrix);

enum class SolverEnd {
  none,       // it goes on
  converged,  // the error is below options.residual times the brightest B
  rounding,   // it fell no further: the digits of double are used up
  diverges    // it grows, or no row absorbs light
};

struct ResidualPoint {
  std::size_t step = 0;
  double sweeps = 0;
  double seconds = 0;  // of the steps, wall clock
  // The max norm of the residual (or what bounds it) over 1 - rho_max: B is no further off, as a share of the
  // brightest.
  double error_bound = 0;
};

class Solver {
 public:
  // options.solver and options.residual count, and options.memory for what a solver holds beside the matrix. `threads`
  // compute the rows that the matrix does not keep. Throws InputError where the method cannot have so many patches, and
  // where `progress` is not null Cancelled: the shooting solvers transpose the matrix first.
  Solver(RadiositySystem system, const Radiosity& options, int threads = 1, const Progress* progress = nullptr);
  ~Solver();
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;

  const RadiositySystem& system() const;
  RadiositySolver kind() const;

  // One row (Jacobi, Gauss-Seidel), one shot (Southwell, progressive) or all of it (LU). Nothing where it has ended.
  // These four throw Cancelled, within 100 ms; what was done until then stays, whole steps of it.
  void step(Progress& progress);
  void sweep(Progress& progress);  // to the end of this sweep: as many steps as there are patches
  void run(Progress& progress);    // until it ends
  // Back or forward to where `step` steps had been done. Back: from the nearest state that is remembered, forward
  // again; states lie the denser the younger they are, and take 256 MiB at most.
  void go_to(std::size_t step, Progress& progress);
  // From now on no states are remembered: for who only goes forward.
  void forget_states();

  std::size_t steps() const;
  std::size_t steps_a_sweep() const;
  double sweeps() const { return steps_a_sweep() ? double(steps()) / double(steps_a_sweep()) : 0; }
  // The row or the shooting patch of the next step; nothing where it has ended, or has no rows.
  std::optional<std::size_t> active() const;

  SolverEnd end() const;
  Text message() const;  // why it ended, and what to know of the way it goes; empty: nothing
  const std::vector<ResidualPoint>& curve() const;

  // By patch. Progressive refinement's includes what is unshot, and its ambient estimate until it has ended.
  std::vector<glm::dvec3> radiosity() const;
  // The ambient estimate of progressive refinement, else 0: rho of a patch times it is its share.
  glm::dvec3 ambient() const;
  // total: radiosity(). unshot: the residual E - (1 - rho F) B, which the shooting solvers keep. received: F B.
  // indirect: B - E - rho F E. But the first, and unshot where shot, each reads the whole matrix. Throws Cancelled.
  std::vector<glm::dvec3> part(LightPart part, Progress& progress) const;
  // The max norm of E - (1 - rho F) B: reads the whole matrix. Of the shooting solvers as they keep it: the largest
  // unshot radiosity, or of progressive refinement what its next bounce can be. Throws Cancelled.
  double residual(Progress& progress) const;
  // What a residual is multiplied by for the error it bounds: 1/(1 - rho_max), or where row sums exceed 1 with
  // rho_i times the row's sum for rho_max; 1 where there is no such bound.
  double error_factor() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cg
