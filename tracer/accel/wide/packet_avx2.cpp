// Compiled for AVX2 with FMA.
#define HWY_COMPILE_ONLY_STATIC
#include "tracer/accel/wide/packet_lanes.h"

namespace tribunal {

const PacketTarget packet_avx2 = HWY_NAMESPACE::packet_target_here();

}  // namespace tribunal
