// Compiled for no vector instructions in particular.
#define HWY_COMPILE_ONLY_SCALAR
#include "tracer/accel/wide/packet_lanes.h"

namespace tribunal {

const PacketTarget packet_portable = HWY_NAMESPACE::packet_target_here();

}  // namespace tribunal
