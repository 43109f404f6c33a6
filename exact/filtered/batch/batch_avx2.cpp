// Compiled for AVX2 with FMA.
#define HWY_COMPILE_ONLY_STATIC
#include "exact/filtered/batch/batch_lanes.h"

static_assert(HWY_TARGET == HWY_AVX2);

namespace tribunal {

const BatchTarget batch_avx2 = HWY_NAMESPACE::target_named("AVX2", has_avx2);

}  // namespace tribunal
