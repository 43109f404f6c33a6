#include "exact/base/fp_environment.h"

#include <cfenv>
#include <limits>

#include "exact/base/failure.h"

namespace tribunal {
namespace {

/// Round to nearest, ties to even: 1 + u rounds to 1, and −1 − u to −1; a subnormal survives halving and doubling.
/// Traps where exceptions do, so that the control words are to be read first.
bool rounds_as_expected() {
  volatile double one = 1;
  volatile double u = 0x1p-53;
  volatile double tiny = std::numeric_limits<double>::denorm_min();
  volatile float tiny_f = std::numeric_limits<float>::denorm_min();
  const bool nearest = one + u == 1 && -one - u == -1 && one + 0x1.8p-53 > 1;
  return nearest && tiny * 2 != 0 && tiny + tiny != 0 && tiny_f * 2 != 0 && std::fegetround() == FE_TONEAREST;
}

/// Whether `long double`, which some bounds are computed in, has the digits that the compiler believes in.
bool long_double_is_whole() {
  volatile long double one = 1;
  volatile long double last = std::numeric_limits<long double>::epsilon();
  return one + last > 1;
}

bool is_as_expected() { return has_exact_rounding() && rounds_as_expected() && long_double_is_whole(); }

void repair() { std::fesetenv(FE_DFL_ENV); }

/// Runs before static objects are made: CGAL notes the rounding mode when it makes its own, and aborts at exit if the
/// mode is another then.
[[gnu::constructor(101)]] void repair_at_start() {
  if (!is_as_expected()) repair();
}

}  // namespace

bool has_exact_rounding() {
#if defined(__SSE2__)
  // MXCSR: flush to zero, rounding, masks of exceptions, denormals are zero. Of the x87 unit's: rounding, precision,
  // masks. The bits left out record what happened, or mean nothing.
  constexpr unsigned sse_control = 0xffc0, sse_default = 0x1f80, x87_control = 0x0f3f, x87_default = 0x033f;
  unsigned short x87 = 0;
  __asm__ volatile("fnstcw %0" : "=m"(x87));
  return (__builtin_ia32_stmxcsr() & sse_control) == sse_default && (x87 & x87_control) == x87_default;
#else
  return std::fegetround() == FE_TONEAREST;
#endif
}

bool require_exact_rounding() {
  if (is_as_expected()) return false;
  repair();
  if (!is_as_expected()) {
    throw Failure(Exit::fp_environment,
                  "floating-point environment: not round-to-nearest with gradual underflow, and it cannot be repaired");
  }
  return true;
}

void refuse_changed_rounding() {
  if (has_exact_rounding()) return;
  repair();  // for what remains to be done: CGAL aborts at exit if it finds another mode
  throw Failure(
      Exit::fp_environment,
      "floating-point environment: changed while this ran (rounding, precision, flush to zero or exceptions)");
}

}  // namespace tribunal
