#include "exact/base/fp_environment.h"

#include <cfenv>
#include <limits>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "exact/base/failure.h"

namespace tribunal {
namespace {

/// Round to nearest, ties to even: 1 + u rounds to 1, and −1 − u to −1; a subnormal survives halving and doubling.
bool rounds_as_expected() {
  volatile double one = 1;
  volatile double u = 0x1p-53;
  volatile double tiny = std::numeric_limits<double>::denorm_min();
  volatile float tiny_f = std::numeric_limits<float>::denorm_min();
  const bool nearest = one + u == 1 && -one - u == -1 && one + 0x1.8p-53 > 1;
  return nearest && tiny * 2 != 0 && tiny + tiny != 0 && tiny_f * 2 != 0 && std::fegetround() == FE_TONEAREST;
}

#if defined(__SSE2__)
constexpr unsigned flush_to_zero = 1U << 15, denormals_are_zero = 1U << 6, rounding_mode = 3U << 13;
#endif

void repair() {
  std::fesetround(FE_TONEAREST);
#if defined(__SSE2__)
  _mm_setcsr(_mm_getcsr() & ~(flush_to_zero | denormals_are_zero));
#endif
}

/// Runs before static objects are made: CGAL notes the rounding mode when it makes its own, and aborts at exit if the
/// mode is another then.
[[gnu::constructor(101)]] void repair_at_start() {
  if (!rounds_as_expected()) repair();
}

}  // namespace

bool has_exact_rounding() {
#if defined(__SSE2__)
  return (_mm_getcsr() & (flush_to_zero | denormals_are_zero | rounding_mode)) == 0;
#else
  return std::fegetround() == FE_TONEAREST;
#endif
}

bool require_exact_rounding() {
  if (rounds_as_expected()) return false;
  repair();
  if (!rounds_as_expected()) {
    throw Failure(Exit::fp_environment,
                  "floating-point environment: not round-to-nearest with gradual underflow, and it cannot be repaired");
  }
  return true;
}

}  // namespace tribunal
