// Compiled for AVX-512.
#define HWY_COMPILE_ONLY_STATIC
#include "tests/bench/predicate/moeller_trumbore_lanes.h"

namespace tribunal::bench {

const VectorPeer moeller_trumbore_avx512{"AVX-512", HWY_NAMESPACE::moeller_trumbore_columns<false, false>,
                                         HWY_NAMESPACE::moeller_trumbore_columns<false, true>,
                                         HWY_NAMESPACE::moeller_trumbore_columns<true, false>};

}  // namespace tribunal::bench
