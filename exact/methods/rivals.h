// Rivals as methods, each with its exact twin.
#pragma once

#include "core/rivals/adapter.h"
#include "exact/kernels/extended_rational.h"

namespace tribunal {

/// The rival on float or double, without its name; its exact twin is the same template on exact numbers.
template <template <class> class Rival, class N>
Method rival() {
  Method m = published::rival_method<Rival<N>>();
  m.exact_twin = published::answer_to<Rival<ExtendedRational>>;
  return m;
}

}  // namespace tribunal
