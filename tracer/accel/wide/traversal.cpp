#include "tracer/accel/wide/traversal.h"

#include "exact/filtered/batch/batch_target.h"

namespace tribunal {

const TreeTarget& tree_target() {
  const BatchTarget* batch = &batch_target();
  return batch == &batch_avx512 ? tree_avx512 : batch == &batch_avx2 ? tree_avx2 : tree_portable;
}

}  // namespace tribunal
