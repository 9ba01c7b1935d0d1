// The parts of the report that take minutes: each knob's trade at a small size, and the extremes.
#pragma once
#include "measure/report_page.h"

namespace cg {

// On the scene that the command `trade` takes where none is named. A slope that is not the predicted one is shown, and
// is no fault: the text beside it says where the curve bends and why. `language`: of the progress on a terminal.
ReportPart trades_part(std::span<const Technique> techniques, int threads, Language language);

// All cases by all techniques; what is off or broken does not hold, a driver's own fault is only shown.
ReportPart extremes_part(std::span<const Technique> techniques, Language language);

}  // namespace cg
