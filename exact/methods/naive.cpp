#include "exact/methods/naive.h"

#include "core/tolerance_kernel.h"
#include "exact/methods/exact_methods.h"
#include "exact/methods/segura_feito_method.h"

namespace tribunal {
namespace {

/// Adds the exact twin: the Segura–Feito test without rounding is the reference.
Method with_exact_twin(Method m) {
  const Method twin = sf_rational();
  m.exact_twin = [twin](const Query& query) { return twin.ask(query); };
  return m;
}

}  // namespace

Method sf_float() {
  return with_exact_twin(segura_feito_method(
      {.number = "binary32", .summary = "five signs in single precision", .format = Format::binary32, .exact = false},
      FormulaKernel<float>{}));
}

Method sf_double() {
  return with_exact_twin(segura_feito_method(
      {.number = "binary64", .summary = "five signs in double precision", .format = Format::binary64, .exact = false},
      FormulaKernel<double>{}));
}

Method sf_double_eps() {
  return segura_feito_method({.number = "binary64, tolerance 1e-12",
                              .summary = "five signs in double precision, small volumes called zero",
                              .format = Format::binary64,
                              .exact = false},
                             ToleranceKernel{});
}

}  // namespace tribunal
