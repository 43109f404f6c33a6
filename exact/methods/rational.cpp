#include <cmath>

#include "exact/kernels/rational_kernel.h"
#include "exact/methods/exact_methods.h"
#include "exact/methods/segura_feito_method.h"

namespace tribunal {

namespace {

/// Whether x is an integer of up to 15 bits. The conversion to int is one instruction where std::trunc is a call.
bool is_small_integer(double x) { return std::fabs(x) < 0x1p15 && static_cast<double>(static_cast<int>(x)) == x; }

bool is_small(const Point3& p) { return is_small_integer(p.x) && is_small_integer(p.y) && is_small_integer(p.z); }
bool is_small(const Direction& d) { return is_small(d.v); }

/// Decides by the rational kernel; but where all coordinates are small integers, as on lattices, by the same formulas
/// in double, which are exact there: |differences| < 2¹⁶, |minors| < 2³³, |volumes| and all their partial sums < 3·2⁴⁹
/// < 2⁵³, integers.
template <class P, class F>
Answer over_exact_numbers(const P& probe, const Triangle& t, const F& decide) {
  if (is_small(source(probe)) && is_small(target(probe)) && is_small(t.a) && is_small(t.b) && is_small(t.c)) {
    return decide(probe, t, FormulaKernel<double>{});
  }
  return decide(probe, t, RationalKernel{});
}

}  // namespace

Method sf_rational() {
  Method m = segura_feito_method({.number = "GMP dyadic rationals",
                                  .summary = "five exact signs; the reference that judges the others",
                                  .format = Format::binary64,
                                  .exact = true},
                                 RationalKernel{});
  const auto decide = [](const auto& probe, const Triangle& t, const auto& k) { return segura_feito(probe, t, k); };
  const auto with_class = [](const auto& probe, const Triangle& t, const auto& k) { return classify(probe, t, k); };
  m.segment = [decide](const Segment& s, const Triangle& t) { return over_exact_numbers(s, t, decide); };
  m.ray = [decide](const Ray& r, const Triangle& t) { return over_exact_numbers(r, t, decide); };
  m.classify = [with_class](const Probe& probe, const Triangle& t) {
    return std::visit([&](const auto& p) { return over_exact_numbers(p, t, with_class); }, probe);
  };
  return m;
}

}  // namespace tribunal
