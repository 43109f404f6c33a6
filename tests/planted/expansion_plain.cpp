// The determinant as the build means it.
#include <initializer_list>

#include "tests/planted/expansion.h"

namespace tribunal::planted {

int plain_sign(const double (&u)[3], const double (&v)[3], const double (&w)[3]) {
  return sign_of_determinant(u, v, w);
}

}  // namespace tribunal::planted
