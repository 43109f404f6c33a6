// Compiled for AVX-512 (F, BW, CD, DQ, VL).
#define HWY_COMPILE_ONLY_STATIC
#include "tracer/accel/wide/packet_lanes.h"

namespace tribunal {

const PacketTarget packet_avx512 = HWY_NAMESPACE::packet_target_here();

}  // namespace tribunal
