// Bugs in how numbers are read, and in the floating-point environment they are computed in.
#include <cfenv>
#include <cmath>
#include <type_traits>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "core/segura_feito.h"
#include "exact/methods/cgal_kernels.h"
#include "tests/planted/bugs.h"

namespace tribunal::planted {
namespace {

struct MinusZeroIsLess : EpickKernel {
  template <class X>
  Sign compare(Axis axis, const Point3& a, const X& x) const {
    const Sign plain = EpickKernel::compare(axis, a, x);
    if constexpr (std::is_same_v<X, Point3>) {
      const auto i = static_cast<int>(axis);
      if (plain == Sign::zero && std::signbit(a[i]) != std::signbit(x[i])) {
        return std::signbit(a[i]) ? Sign::positive : Sign::negative;
      }
    }
    return plain;
  }
};

Answer minus_zero_is_less(const Segment& s, const Triangle& t) { return segura_feito(s, t, MinusZeroIsLess{}); }

template <class F>
Answer with_points(const Segment& s, const Triangle& t, const F& f) {
  return right({f(s.p), f(s.q)}, {f(t.a), f(t.b), f(t.c)});
}

Answer subnormals_are_zero(const Segment& s, const Triangle& t) {
  return with_points(s, t, [](Point3 p) {
    for (int i = 0; i < 3; ++i) p[i] = std::fabs(p[i]) < 0x1p-1022 ? 0 : p[i];
    return p;
  });
}

Answer through_binary32(const Segment& s, const Triangle& t) {
  return with_points(s, t, [](const Point3& p) {
    const Point3 rounded = in_format(p, Format::binary32);
    return is_finite(rounded) ? rounded : p;
  });
}

#if defined(__SSE2__)
constexpr unsigned flush_to_zero = 1U << 15, denormals_are_zero = 1U << 6;

Answer flushing(const Segment& s, const Triangle& t) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | flush_to_zero | denormals_are_zero);
  const Answer answer = right(s, t);
  _mm_setcsr(before);
  return answer;
}

Answer leaves_flushing(const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  _mm_setcsr(_mm_getcsr() | flush_to_zero | denormals_are_zero);
  return answer;
}
#else
Answer leaves_flushing(const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  std::fesetround(FE_UPWARD);
  return answer;
}
#endif

}  // namespace

std::vector<Method> operand_bugs() {
  return {
    method("planted-minus-zero", "-0 is less than 0", minus_zero_is_less),
        method("planted-subnormals", "subnormals are read as zero", subnormals_are_zero),
        method("planted-binary32", "binary64 operands rounded to binary32", through_binary32),
#if defined(__SSE2__)
        method("planted-ftz", "flushes subnormals to zero while it decides", flushing),
#endif
  };
}

Method environment_bug() {
  return method("planted-environment", "leaves its thread with another floating-point environment", leaves_flushing);
}

}  // namespace tribunal::planted
