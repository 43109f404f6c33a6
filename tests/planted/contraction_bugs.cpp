// A kernel on expansions, whose exact products rely on every operation being rounded by itself: compiled as the build
// means it, and with a·b + c contracted to one operation.
#include <cmath>

#include "core/segura_feito.h"
#include "exact/kernels/dyadic.h"
#include "exact/methods/cgal_kernels.h"
#include "tests/planted/bugs.h"

namespace tribunal::planted {

using SignOfDeterminant = int (*)(const double (&u)[3], const double (&v)[3], const double (&w)[3]);
int plain_sign(const double (&u)[3], const double (&v)[3], const double (&w)[3]);
int contracted_sign(const double (&u)[3], const double (&v)[3], const double (&w)[3]);

namespace {

/// x − o, if it is exact and far from overflow and underflow.
bool exact_arm(const Point3& o, const Point3& x, double (&arm)[3]) {
  for (int i = 0; i < 3; ++i) {
    arm[i] = x[i] - o[i];
    const double size = std::fabs(arm[i]);
    if (size != 0 && !(size > 0x1p-200 && size < 0x1p200)) return false;
    if (sign_of(Dyadic(x[i]) - Dyadic(o[i]) - Dyadic(arm[i])) != Sign::zero) return false;
  }
  return true;
}

/// A kernel that uses expansions where the differences are exact, and EPICK elsewhere.
struct ExpansionKernel : EpickKernel {
  SignOfDeterminant sign;

  explicit ExpansionKernel(SignOfDeterminant s) : sign(s) {}

  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const {
    double u[3], v[3], w[3];
    if (exact_arm(a, b, u) && exact_arm(a, c, v) && exact_arm(a, x, w)) return static_cast<Sign>(sign(u, v, w));
    return EpickKernel::orient3d(a, b, c, x);
  }

  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& d) const {
    return EpickKernel::orient3d(a, b, c, d);
  }
};

Method by_expansions(const char* name, const char* what, SignOfDeterminant sign) {
  return method(name, what, [kernel = ExpansionKernel(sign)](const Segment& s, const Triangle& t) {
    return segura_feito(s, t, kernel);
  });
}

}  // namespace

/// The bug, or none if the processor has no fused operation or contraction changes no result.
std::vector<Method> contraction_bugs() {
#if defined(TRIBUNAL_CONTRACTS)
  if (__builtin_cpu_supports("fma")) {
    return {by_expansions("planted-contraction", "contraction on: a*b + c rounded once", contracted_sign)};
  }
#endif
  return {};
}

Method sound_expansion() { return by_expansions("sound-expansion", "expansions, then EPICK", plain_sign); }

}  // namespace tribunal::planted
