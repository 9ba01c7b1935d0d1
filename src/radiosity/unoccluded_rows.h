// Rows of form factors as if nothing stood between the patches: closed forms of polygon pairs, or the mean of what a
// patch's positions see by the Nusselt projection.
#pragma once
#include "radiosity/form_factors.h"

namespace cg {

// Whether every patch sees all of every other, so that rows without a blocker are exact: an empty convex room, or
// squares that face each other. False where there is none.
bool nothing_hides(const Patches& patches);

class UnoccludedRows {
 public:
  // Closed forms, or Nusselt's projection, as options.form_factors says. The patches must outlive this.
  UnoccludedRows(const Patches& patches, const Radiosity& options, bool normalise);

  // Of `part`, which belongs to patch `own`. From several threads at once. Throws Cancelled.
  FormFactorRow row(const Patch& part, std::uint32_t own, const Progress& progress) const;

 private:
  double factor(const Patch& from, const Patch& to) const;

  const Patches& patches_;
  bool nusselt_;
  int samples_;
  Placement placement_;
  bool normalise_;
};

}  // namespace cg
