// The determinant compiled with contraction: tests/CMakeLists.txt gives this file -ffp-contract=fast and a target with
// FMA. Nothing else may be included here: what it instantiates might be used elsewhere.
#include <initializer_list>

#include "tests/planted/expansion.h"

namespace tribunal::planted {

int contracted_sign(const double (&u)[3], const double (&v)[3], const double (&w)[3]) {
  return sign_of_determinant(u, v, w);
}

}  // namespace tribunal::planted
