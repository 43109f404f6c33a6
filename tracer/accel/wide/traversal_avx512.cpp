// Compiled for AVX-512 (F, BW, CD, DQ, VL).
#define HWY_COMPILE_ONLY_STATIC
#include "tracer/accel/wide/stream_lanes.h"

namespace tribunal {

const TreeTarget tree_avx512 = HWY_NAMESPACE::tree_target_here();

}  // namespace tribunal
