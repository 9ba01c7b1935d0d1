#include "ui/settings.h"

namespace cg {

template Slots slots<Settings>(Settings&);

}  // namespace cg
