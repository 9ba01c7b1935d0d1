// One way of solving B = E + rho F B, a step at a time: what Solver drives. A copy is a state to come back to.
#pragma once
#include <memory>
#include <optional>

#include "radiosity/row_source.h"
#include "radiosity/solver.h"

namespace cg {

// What a sweep, or a step that knows it, says of how far it has come.
struct Standing {
  double residual = 0;   // the max norm of E - (1 - rho F) B, or what bounds it
  double brightest = 0;  // of B
  bool swept = false;    // the step was the last of a sweep
  bool grows = false;    // proven: in one channel no patch's part of it became smaller in a sweep
};

class Iteration {
 public:
  virtual ~Iteration() = default;
  virtual std::unique_ptr<Iteration> copy() const = 0;
  virtual void become(const Iteration& other) = 0;  // a copy of one of its own kind and size, in the memory it has
  virtual std::size_t bytes() const = 0;            // of a copy

  // Throws Cancelled, and then nothing has changed.
  virtual void step(RowSource& rows, Progress& progress) = 0;
  virtual std::size_t steps_a_sweep() const = 0;
  // Of the last step, where it says something.
  virtual std::optional<Standing> standing() const = 0;
  // The patch of the next step.
  virtual std::optional<std::size_t> active() const = 0;
  virtual std::vector<glm::dvec3> radiosity() const = 0;
  // The residual by patch, where it is kept.
  virtual const Channels* unshot() const { return nullptr; }
  // The estimate of the light that is still under way: rho times it is a patch's share.
  virtual glm::dvec3 ambient() const { return glm::dvec3(0); }

 protected:
  Iteration() = default;
  Iteration(const Iteration&) = default;
  Iteration& operator=(const Iteration&) = default;
};

// What does not change while it is solved, shared by the copies.
struct SolverData {
  RadiositySystem system;
  Channels emission, reflectance;
  double row_bound = 1;  // the largest rho_i times the row's sum, or the sum 1 where that is more
  // Of a shot: F_ji = columns' number (i, j) times what is in `shot`, or by reciprocity F_ij A_i times what is in it.
  std::shared_ptr<const FormFactorMatrix> columns;
  Channels shot;
};

std::unique_ptr<Iteration> make_gather(std::shared_ptr<const SolverData> data, bool gauss_seidel);
std::unique_ptr<Iteration> make_shooting(std::shared_ptr<const SolverData> data, bool progressive);
// Throws InputError where the matrix does not fit.
std::unique_ptr<Iteration> make_direct(std::shared_ptr<const SolverData> data);

// Sets columns and shot of `data`: F^T where all rows are kept and a second matrix fits into `memory` MiB. Throws
// Cancelled where `progress` is not null.
void prepare_shooting(SolverData& data, double memory, const Progress* progress);

// Whether in one channel every patch's value is as large as before, and not all are 0.
class Growth {
 public:
  void see(const glm::dvec3& before, const glm::dvec3& now);
  bool proven() const;

 private:
  bool fell_[3] = {}, any_[3] = {};
};

}  // namespace cg
