// Faults of published tests, on exact numbers, so that nothing but the fault is wrong (docs/findings.md).
#include "core/rivals/adapter.h"
#include "core/rivals/chirkov.h"
#include "exact/kernels/extended_rational.h"
#include "exact/methods/cgal_kernels.h"
#include "tests/planted/bugs.h"

namespace tribunal::planted {
namespace {

using namespace published;

/// Chirkov's variant without stored data as its published code has it: |n_x| and |n_y| are compared with 0.57735 times
/// the square of the normal's length, where 0.57735 times the length is meant. So where the normal is longer than √3,
/// an axis that it lies along may not be dropped, and the triangle is projected to a line.
template <class N>
struct ChirkovWithoutRoot {
  using Number = N;
  using Prepared = Corners<N>;
  static constexpr Contract contract = chirkov_detail::contract;

  static Axis axis_of(const Vec3<N>& normal) {
    const N bound = dot(normal, normal) * static_cast<N>(0.57735);
    if (absolute(normal.x) > bound) return Axis::x;
    return absolute(normal.y) > bound ? Axis::y : Axis::z;
  }

  static std::optional<RivalHit<N>> meet_segment(const Vec3<N>& p, const Vec3<N>& q, const Prepared& t) {
    const Vec3<N> normal = plane_of(t).normal;
    const N height = dot(normal, t.a);
    return chirkov_detail::hit_by_sides<N>(p, q, t,
                                           {dot(normal, p) - height, dot(normal, q) - height, axis_of(normal)});
  }
};

Method chirkov_without_root() {
  Method m = method("planted-chirkov-root", "Chirkov's C2 as published: |n.x| against 0.57735 |n|^2, a root is missing",
                    answer_of<ChirkovWithoutRoot<ExtendedRational>, Segment, Triangle>);
  m.contract.convention = Convention::transversal;
  m.contract.boundary = Boundary::open;
  return m;
}

const EpickKernel k;

bool strictly_between(Axis axis, const Point3& x, const Segment& s) {
  return k.compare(axis, s.p, x) * k.compare(axis, x, s.q) == Sign::positive;
}

/// An end of one lies strictly within the range of the other, on an axis that is kept.
bool ranges_overlap(Axis dropped, const Segment& s, const Segment& e) {
  for (const Axis axis : all_axes) {
    if (axis == dropped) continue;
    for (const Point3& x : {s.p, s.q}) {
      if (strictly_between(axis, x, e)) return true;
    }
    for (const Point3& x : {e.p, e.q}) {
      if (strictly_between(axis, x, s)) return true;
    }
  }
  return false;
}

/// Two segments seen along an axis. One that runs along it is a point then, and where that is an end of the other, no
/// range holds the other's end strictly: here is the fault.
bool meet_as_seen(Axis dropped, const Segment& s, const Segment& e) {
  const Sign p = k.orient2d(dropped, e.p, e.q, s.p), q = k.orient2d(dropped, e.p, e.q, s.q);
  const Sign a = k.orient2d(dropped, s.p, s.q, e.p), b = k.orient2d(dropped, s.p, s.q, e.q);
  if (p != q && a != b) return true;
  const bool on_a_line = p == Sign::zero && q == Sign::zero && a == Sign::zero && b == Sign::zero;
  return on_a_line && ranges_overlap(dropped, s, e);
}

bool meet_by_projections(const Segment& s, const Segment& e) {
  return meet_as_seen(Axis::x, s, e) && meet_as_seen(Axis::y, s, e) && meet_as_seen(Axis::z, s, e);
}

/// In the plane: an end is in the triangle, or an edge is met; edges by their three projections.
Answer edges_by_projections(const Segment& s, const Triangle& t) {
  const bool in_plane = k.orient3d(t.a, t.b, t.c, s.p) == Sign::zero && k.orient3d(t.a, t.b, t.c, s.q) == Sign::zero;
  if (!in_plane) return right(s, t);
  const bool hit = right({s.p, s.p}, t).hit || right({s.q, s.q}, t).hit || meet_by_projections(s, {t.a, t.b}) ||
                   meet_by_projections(s, {t.b, t.c}) || meet_by_projections(s, {t.c, t.a});
  return hit ? hit_at(Contact::coplanar) : miss();
}

Method projected_edges() {
  Method m = method("planted-projected-edges",
                    "in the plane, edges are met by projections: one seen as a point misses another's end",
                    edges_by_projections);
  m.contract.triangles = Triangles::proper;
  return m;
}

}  // namespace

std::vector<Method> published_bugs() { return {chirkov_without_root(), projected_edges()}; }

}  // namespace tribunal::planted
