#include "tracer/accel/wide/packet.h"

#include "exact/filtered/batch/batch_target.h"

namespace tribunal {

const PacketTarget& packet_target() {
  const BatchTarget* batch = &batch_target();
  return batch == &batch_avx512 ? packet_avx512 : batch == &batch_avx2 ? packet_avx2 : packet_portable;
}

}  // namespace tribunal
