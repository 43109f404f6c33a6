// Compiled for no vector instructions in particular.
#define HWY_COMPILE_ONLY_SCALAR
#include "exact/filtered/batch/batch_lanes.h"

namespace tribunal {

const BatchTarget batch_portable = HWY_NAMESPACE::target_named("portable", [] { return true; });

}  // namespace tribunal
