#include "tracer/accel/wide/packet.h"

#include "exact/filtered/batch/batch_target.h"

namespace tribunal {

const PacketTarget& packet_target() { return for_target_in_use(packet_avx512, packet_avx2, packet_portable); }

}  // namespace tribunal
