// Compiled for no vector instructions in particular.
#define HWY_COMPILE_ONLY_SCALAR
#include "tracer/accel/wide/stream_lanes.h"

namespace tribunal {

const TreeTarget tree_portable = HWY_NAMESPACE::tree_target_here();

}  // namespace tribunal
