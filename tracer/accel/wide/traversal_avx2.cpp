// Compiled for AVX2 with FMA.
#define HWY_COMPILE_ONLY_STATIC
#include "tracer/accel/wide/stream_lanes.h"

namespace tribunal {

const TreeTarget tree_avx2 = HWY_NAMESPACE::tree_target_here();

}  // namespace tribunal
