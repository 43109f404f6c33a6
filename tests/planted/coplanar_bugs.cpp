// Bugs in the plane: operands in one plane, and the axis dropped to look at them.
#include "core/segura_feito.h"
#include "exact/classes/class_table.h"
#include "exact/kernels/dyadic.h"
#include "exact/methods/cgal_kernels.h"
#include "tests/planted/bugs.h"

namespace tribunal::planted {
namespace {

using namespace detail;

const EpickKernel exact;

Answer never(const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  return answer.contact == Contact::coplanar ? miss() : answer;
}

Answer by_ends_only(const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  if (answer.contact != Contact::coplanar) return answer;
  return right({s.p, s.p}, t).hit || right({s.q, s.q}, t).hit ? answer : miss();
}

/// A segment strictly inside, in the plane, meets no edge.
Answer by_edges_only(const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  if (answer.contact != Contact::coplanar) return answer;
  const Triangle edges[] = {{t.a, t.b, t.b}, {t.b, t.c, t.c}, {t.c, t.a, t.a}};
  for (const Triangle& e : edges) {
    if (right(s, e).hit) return answer;
  }
  return miss();
}

/// `<` in place of `≤` in every test in the plane, so that touching in one point does not count.
Answer touching_excluded(const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  if (answer.contact != Contact::coplanar) return answer;
  return class_row(class_of(chirotope(s, t, exact))).intersection == "point" ? miss() : answer;
}

/// Misses every triangle of which the first two vertices are equal, as one without area.
Answer two_equal_vertices_miss(const Segment& s, const Triangle& t) { return t.a == t.b ? miss() : right(s, t); }

struct ProjectsToXy : EpickKernel {
  template <class X>
  Sign orient2d(Axis, const Point3& a, const Point3& b, const X& x) const {
    return EpickKernel::orient2d(Axis::z, a, b, x);
  }
};

Answer always_projects_to_xy(const Segment& s, const Triangle& t) { return segura_feito(s, t, ProjectsToXy{}); }

bool exceeds(const Dyadic& x, const Dyadic& y) { return sign_of(x * x - y * y) == Sign::positive; }

/// The axis along which the normal is longest; equals fall through to z, where the normal may vanish.
Axis dominant_axis(const Triangle& t) {
  const Dyadic x = signed_area<Dyadic>(Axis::x, t.a, t.b, t.c), y = signed_area<Dyadic>(Axis::y, t.a, t.b, t.c),
               z = signed_area<Dyadic>(Axis::z, t.a, t.b, t.c);
  if (exceeds(x, y) && exceeds(x, z)) return Axis::x;
  if (exceeds(y, x) && exceeds(y, z)) return Axis::y;
  return Axis::z;
}

bool has_area(const Triangle& t) {
  for (const Axis axis : all_axes) {
    if (exact.orient2d(axis, t.a, t.b, t.c) != Sign::zero) return true;
  }
  return false;
}

Answer wrong_axis_on_ties(const Segment& s, const Triangle& t) {
  const bool flat =
      exact.orient3d(t.a, t.b, t.c, s.p) == Sign::zero && exact.orient3d(t.a, t.b, t.c, s.q) == Sign::zero;
  if (!flat || !has_area(t)) return right(s, t);
  const Axis dropped = dominant_axis(t);
  return meets_in_plane(dropped, exact.orient2d(dropped, t.a, t.b, t.c), s, t, exact) ? hit_at(Contact::coplanar)
                                                                                      : miss();
}

}  // namespace

std::vector<Method> coplanar_bugs() {
  return {
      method("planted-coplanar-never", "coplanar is always false", never),
      method("planted-coplanar-ends", "coplanar by ends only", by_ends_only),
      method("planted-coplanar-edges", "coplanar by edges only", by_edges_only),
      method("planted-coplanar-touch", "< for <= in the plane", touching_excluded),
      method("planted-equal-vertices", "two equal vertices are a miss", two_equal_vertices_miss),
      method("planted-xy", "always projects to xy", always_projects_to_xy),
      method("planted-axis-on-ties", "wrong axis where two components of the normal are equal", wrong_axis_on_ties),
  };
}

}  // namespace tribunal::planted
