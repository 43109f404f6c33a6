// Compiled for AVX-512 (F, BW, CD, DQ, VL).
#define HWY_COMPILE_ONLY_STATIC
#include "exact/filtered/batch/batch_lanes.h"

static_assert(HWY_TARGET == HWY_AVX3);

namespace tribunal {

const BatchTarget batch_avx512 = HWY_NAMESPACE::target_named("AVX-512", has_avx512);

}  // namespace tribunal
