// The test of Jiménez, Segura and Feito over exact numbers, as it should be and as public code has it.
// Source: Jiménez, Segura & Feito, "A robust segment/triangle intersection algorithm for interference tests.
// Efficiency study", Computational Geometry 43(5), 2010. Where the first end lies in the triangle's plane (w = 0) and
// the second above it (s > 0), the point beside the third edge is rejected by s < t + u; ports compare −s.
#include "exact/kernels/dyadic.h"
#include "tests/planted/bugs.h"

namespace tribunal::planted {
namespace {

using Vector = Vec3<Dyadic>;

Dyadic dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
Vector cross(const Vector& u, const Vector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// Whether t and u are not negative and t + u ≤ `whole`; if `up` is negative, all signs are reversed.
bool inside(const Dyadic& t, const Dyadic& u, const Dyadic& whole, Sign up) {
  return sign_of(t) * up != Sign::negative && sign_of(u) * up != Sign::negative &&
         sign_of(whole - t - u) * up != Sign::negative;
}

template <bool as_ported>
Answer jimenez(const Segment& segment, const Triangle& triangle) {
  const Vector v3 = lift<Dyadic>(triangle.c);
  const Vector a = lift<Dyadic>(segment.p) - v3, d = lift<Dyadic>(segment.q) - v3;
  const Vector b = lift<Dyadic>(triangle.a) - v3, c = lift<Dyadic>(triangle.b) - v3;
  const Vector w1 = cross(b, c);
  const Dyadic w = dot(a, w1), s = dot(d, w1);
  const Sign source_side = sign_of(w), target_side = sign_of(s);
  if (source_side == Sign::zero && target_side == Sign::zero) return miss();
  if (source_side * target_side == Sign::positive) return miss();
  const bool on_plane = source_side == Sign::zero;
  const Vector w2 = on_plane ? cross(d, a) : cross(a, d);
  const Dyadic t = dot(w2, c), u = -dot(w2, b);
  const Dyadic whole = !on_plane ? w - s : as_ported ? -s : s;
  const bool hit = inside(t, u, whole, on_plane ? target_side : source_side);
  return hit ? hit_at(Contact::unsaid) : miss();
}

Method transversal(Method m) {
  m.contract.convention = Convention::transversal;
  return m;
}

}  // namespace

std::vector<Method> jimenez_bugs() {
  return {transversal(method("planted-jimenez-w0", "Jimenez's branch w = 0 as ported: -s for s", jimenez<true>))};
}

Method sound_jimenez() { return transversal(method("sound-jimenez", "Jimenez's test over GMP", jimenez<false>)); }

}  // namespace tribunal::planted
