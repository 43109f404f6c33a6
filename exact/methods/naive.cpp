#include "exact/methods/naive.h"

#include "core/tolerance_kernel.h"
#include "exact/methods/exact_methods.h"
#include "exact/methods/segura_feito_method.h"

namespace tribunal {
namespace {

/// Inlined as a whole, as in a user's loop.
template <class K>
struct Inlined {
  template <class P>
  [[gnu::flatten]] bool operator()(const P& probe, const Triangle& t) const {
    return segura_feito(probe, t, K{}).hit;
  }
};

template <class K>
Method naive(const KernelDescription& d) {
  Method m = segura_feito_method(d, K{});
  m.native = native_loops(Inlined<K>{});
  m.native_rays = native_ray_loops(Inlined<K>{});
  return m;
}

/// Adds the exact twin: the Segura–Feito test without rounding is the reference.
Method with_exact_twin(Method m) {
  const Method twin = sf_rational();
  m.exact_twin = [twin](const Query& query) { return twin.ask(query); };
  return m;
}

}  // namespace

Method sf_float() {
  return with_exact_twin(naive<FormulaKernel<float>>(
      {.number = "binary32", .summary = "five signs in single precision", .format = Format::binary32, .exact = false}));
}

Method sf_double() {
  return with_exact_twin(naive<FormulaKernel<double>>(
      {.number = "binary64", .summary = "five signs in double precision", .format = Format::binary64, .exact = false}));
}

Method sf_double_eps() {
  return naive<ToleranceKernel>({.number = "binary64, tolerance 1e-12",
                                 .summary = "five signs in double precision, small volumes called zero",
                                 .format = Format::binary64,
                                 .exact = false});
}

}  // namespace tribunal
