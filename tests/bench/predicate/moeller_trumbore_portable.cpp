// Compiled for no vector instructions in particular.
#define HWY_COMPILE_ONLY_SCALAR
#include "tests/bench/predicate/moeller_trumbore_lanes.h"

namespace tribunal::bench {

const VectorPeer moeller_trumbore_portable{"portable", HWY_NAMESPACE::moeller_trumbore_columns<false, false>,
                                           HWY_NAMESPACE::moeller_trumbore_columns<false, true>,
                                           HWY_NAMESPACE::moeller_trumbore_columns<true, false>};

}  // namespace tribunal::bench
