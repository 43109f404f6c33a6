#include "exact/kernels/exact_methods.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/kernels/segura_feito_method.h"

namespace tribunal {

Method sf_rational() {
  return segura_feito_method({.name = "sf-rational",
                              .number = "GMP dyadic rationals",
                              .summary = "five exact signs; the reference that judges the others",
                              .format = Format::binary64,
                              .exact = true},
                             RationalKernel{});
}

}  // namespace tribunal
