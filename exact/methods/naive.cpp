#include "exact/methods/naive.h"

#include "core/tolerance_kernel.h"
#include "exact/methods/segura_feito_method.h"

namespace tribunal {

Method sf_float() {
  return segura_feito_method(
      {.number = "binary32", .summary = "five signs in single precision", .format = Format::binary32, .exact = false},
      FormulaKernel<float>{});
}

Method sf_double() {
  return segura_feito_method(
      {.number = "binary64", .summary = "five signs in double precision", .format = Format::binary64, .exact = false},
      FormulaKernel<double>{});
}

Method sf_double_eps() {
  return segura_feito_method({.number = "binary64, tolerance 1e-12",
                              .summary = "five signs in double precision, small volumes called zero",
                              .format = Format::binary64,
                              .exact = false},
                             ToleranceKernel{});
}

}  // namespace tribunal
