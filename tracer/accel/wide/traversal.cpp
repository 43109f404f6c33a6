#include "tracer/accel/wide/traversal.h"

#include "exact/filtered/batch/batch_target.h"

namespace tribunal {

const TreeTarget& tree_target() { return for_target_in_use(tree_avx512, tree_avx2, tree_portable); }

}  // namespace tribunal
