// Bugs in the tests of the five signs.
#include "core/segura_feito.h"
#include "exact/methods/cgal_kernels.h"
#include "tests/planted/bugs.h"

namespace tribunal::planted {
namespace {

using namespace detail;

const EpickKernel exact;

/// The five signs of the published test.
struct FiveSigns {
  int source, target, edge[3];
};

FiveSigns signs_of(const Segment& s, const Triangle& t) {
  return {value(exact.orient3d(t.a, t.b, t.c, s.p)),
          value(exact.orient3d(t.a, t.b, t.c, s.q)),
          {value(exact.orient3d(s.p, t.a, t.b, s.q)), value(exact.orient3d(s.p, t.b, t.c, s.q)),
           value(exact.orient3d(s.p, t.c, t.a, s.q))}};
}

/// The unspoilt decision for operands that do not lie in one plane.
bool crosses(const FiveSigns& v) {
  const int side = v.source != 0 ? v.source : -v.target;
  for (const int e : v.edge) {
    if (side * e > 0) return false;
  }
  return v.source * v.target <= 0;
}

bool is_flat(const FiveSigns& v) { return v.source == 0 && v.target == 0; }

template <class Spoil>
Answer spoilt(const Segment& s, const Triangle& t, const Spoil& spoil) {
  FiveSigns v = signs_of(s, t);
  if (is_flat(v)) return right(s, t);
  spoil(v);
  return crosses(v) ? hit_at(Contact::unsaid) : miss();
}

Answer source_excluded(const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  return answer.at == At::source ? miss() : answer;
}

Answer target_excluded(const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  return answer.at == At::target ? miss() : answer;
}

template <Contact excluded>
Answer contact_excluded(const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  return answer.contact == excluded ? miss() : answer;
}

Answer edge_flipped(const Segment& s, const Triangle& t) {
  return spoilt(s, t, [](FiveSigns& v) { v.edge[1] = -v.edge[1]; });
}

/// det(p, a, c, q) where det(p, c, a, q) was meant.
Answer third_edge_in_wrong_order(const Segment& s, const Triangle& t) {
  return spoilt(s, t, [&](FiveSigns& v) { v.edge[2] = value(exact.orient3d(s.p, t.a, t.c, s.q)); });
}

Answer edge_ignored(const Segment& s, const Triangle& t) {
  return spoilt(s, t, [](FiveSigns& v) { v.edge[0] = 0; });
}

Answer plane_ignored(const Segment& s, const Triangle& t) {
  return spoilt(s, t, [](FiveSigns& v) { v.target = v.source == 0 ? v.target : -v.source; });
}

Answer zero_disables_the_reject(const Segment& s, const Triangle& t) {
  return spoilt(s, t, [](FiveSigns& v) {
    if (v.edge[0] == 0 || v.edge[1] == 0 || v.edge[2] == 0) v.edge[0] = v.edge[1] = v.edge[2] = 0;
  });
}

/// A probe on the line of an edge is sent to one side of it, by the order of the edge's ends alone: at a vertex two
/// edges may send it to opposite sides.
Answer tie_per_edge(const Segment& s, const Triangle& t) {
  return spoilt(s, t, [&](FiveSigns& v) {
    const Point3* const corner[] = {&t.a, &t.b, &t.c, &t.a};
    for (int i = 0; i < 3; ++i) {
      if (v.edge[i] == 0) v.edge[i] = value(lexicographic(*corner[i], *corner[i + 1], exact));
    }
  });
}

/// The vector from source to target, or half of it where it would overflow.
Point3 along(const Segment& s) {
  const Point3 d = s.q - s.p;
  return is_finite(d) ? d : s.q * 0.5 - s.p * 0.5;
}

Answer segment_as_ray(const Segment& s, const Triangle& t) { return segura_feito(Ray{s.p, {along(s)}}, t, exact); }

Answer segment_as_line(const Segment& s, const Triangle& t) {
  const Answer ahead = segment_as_ray(s, t);
  return ahead.hit ? ahead : segura_feito(Ray{s.p, {-along(s)}}, t, exact);
}

}  // namespace

std::vector<Method> sign_bugs() {
  return {
      method("planted-source-excluded", "< for <= at the source", source_excluded),
      method("planted-target-excluded", "< for <= at the target", target_excluded),
      method("planted-edge-excluded", "< for <= at an edge", contact_excluded<Contact::edge>),
      method("planted-vertex-excluded", "< for <= at a vertex", contact_excluded<Contact::vertex>),
      method("planted-edge-flipped", "one edge sign flipped", edge_flipped),
      method("planted-third-edge", "third edge taken in the wrong order", third_edge_in_wrong_order),
      method("planted-edge-ignored", "one edge never rejects", edge_ignored),
      method("planted-plane-ignored", "two ends on one side of the plane do not reject", plane_ignored),
      method("planted-zero-disables", "one zero sign disables the reject", zero_disables_the_reject),
      method("planted-tie-per-edge", "a tie broken per edge and not per vertex", tie_per_edge),
      method("planted-segment-as-ray", "segment treated as ray", segment_as_ray),
      method("planted-segment-as-line", "segment treated as line", segment_as_line),
  };
}

}  // namespace tribunal::planted
